//! Volumes that a straight edge cuts off a round pixel of base diameter 1 and volume 1.

use super::{Interval, Jet, Supremum, range, supremum};
use crate::integral::Field;

/// A round pixel over its base, the circle of diameter 1; every volume is 1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ClippedPixel {
    /// The whole Gaussian with σ = 1/m of the base's diameter, by m > 0, what lies beyond the base included.
    Gaussian(Interval),
    /// The same cut off at the base and scaled up to volume 1.
    GaussianOnBase(u32),
    /// (1 - (2r)²)ᴷ on the base; K = 0 is a flat disk, K = 8 the paper's bell with its zero at the rim.
    Bell(u32),
    /// 1 - 2r on the base.
    Cone,
}

/// Bells that make up a Gaussian on its base, beyond twice its rate: for the rate 4.5 the first left out
/// has a weight below 4.5^48/48! < 2e-30.
const BELLS: u32 = 48;
/// Boxes after which a search settles for what it has.
const MOST_BOXES: usize = 200_000;
/// The narrowest Gaussian on its base that is worked out: its series has m²/4 + 48 terms.
const NARROWEST: u32 = 64;

impl ClippedPixel {
    /// The share that lies beyond a straight edge at distance d from the centre, 0 ≤ d ≤ ½, with its
    /// derivative.
    ///
    /// With D = 2d the Gaussian's is ½ erfc(m d/√2). The bell's is the integral of its marginal,
    /// V_K = V_(K-1) - D (1 - D²)^(K+½)/((2K + 2) N_K) from V_(-1) = arccos(D)/π, where
    /// N_K = N_(K-1) (2K+1)/(2K+2) from N_(-1) = π. The cone's is
    /// (arccos D - 2 D √(1 - D²) + D³ artanh √(1 - D²))/π. A Gaussian on its base is a sum of bells, as
    /// e^(-18 r²) = e^-4.5 Σ 4.5ᵏ (1 - 4r²)ᵏ/k! for m = 6; for m above 64 only [0, ½] is said of it.
    ///
    /// ```
    /// use bellfit::bound::{ClippedPixel, Interval, Jet};
    /// let half = ClippedPixel::Bell(0).share_beyond(Jet::variable(Interval::from(0.0)));
    /// assert!(half.value.contains(0.5));                          // an edge through the centre halves it
    /// assert!((half.slope * Interval::PI).contains(-4.0));        // the disk's diameter by its area π/4
    /// ```
    pub fn share_beyond(self, d: Jet) -> Jet {
        let clamp = |x: f64| x.clamp(0.0, 0.5);
        let (from, to) = (clamp(d.value.lo()), clamp(d.value.hi()));
        // Both the share and the marginal fall from the centre outward, so the ends suffice.
        let (near, far) = (self.point(from), self.point(to));
        let value = Interval::new(far.0.lo(), near.0.hi());
        let marginal = Interval::new(far.1.lo(), near.1.hi());
        Jet { value, slope: -(marginal * d.slope) }
    }

    /// The share beyond d and the pixel's marginal there, which is minus its derivative.
    fn point(self, d: f64) -> (Interval, Interval) {
        let (one, two) = (Interval::from(1.0), Interval::from(2.0));
        // Doubling is exact.
        let (d, x) = (Interval::from(d), Interval::from(2.0 * d));
        let (share, marginal) = match self {
            ClippedPixel::Gaussian(m) => {
                let share = (one - (m * d / two.square_root()).erf()) / two;
                let height = m / (two * Interval::PI).square_root();
                (share, height * (-((m * d).power(2) / two)).exp())
            }
            ClippedPixel::GaussianOnBase(m) if m > NARROWEST => {
                (Interval::new(0.0, 0.5), Interval::new(0.0, f64::INFINITY))
            }
            ClippedPixel::GaussianOnBase(m) => {
                let count = m * m / 4 + BELLS;
                // 1/(2σ²) at the rim, r = ½: m²/8.
                let rate = Interval::int(i64::from(m)).power(2) / Interval::from(8.0);
                let mut weight = one;
                let (mut share, mut marginal, mut total) =
                    (Interval::from(0.0), Interval::from(0.0), Interval::from(0.0));
                let mut bells = Bells::new(x);
                for k in 0..count {
                    let (s, p) = bells.step();
                    // Volume of (1 - R²)ᵏ over the base: in the ratio 1/(k + 1).
                    let volume = weight / Interval::int(i64::from(k) + 1);
                    (share, marginal, total) = (share + volume * s, marginal + volume * p, total + volume);
                    weight = weight * rate / Interval::int(i64::from(k) + 1);
                }
                // The bells left out: the weights' tail is below twice the first, as the rate is below half
                // the count; their shares are at most ½ and their marginals at most 2 (k + 1).
                let tail = Interval::new(0.0, (two * weight).hi());
                let many = Interval::new(0.0, (Interval::int(4 * i64::from(count)) * weight).hi());
                ((share + tail) / (total + tail), (marginal + many) / (total + tail))
            }
            ClippedPixel::Bell(power) => {
                let mut bells = Bells::new(x);
                (0..power).fold(bells.step(), |_, _| bells.step())
            }
            ClippedPixel::Cone => {
                let s = ((one - x) * (one + x)).square_root();
                // x³ ln((1 + s)/x) and x² ln((1 + s)/x), both 0 at 0.
                let log = |power: u32| {
                    if x.lo() <= 0.0 { Interval::from(0.0) } else { x.power(power) * ((one + s) / x).ln() }
                };
                let share = (x.arccos() - two * x * s + log(3)) / Interval::PI;
                // Per d: twice the marginal in D = 2d, of volume π/3.
                (share, Interval::from(6.0) / Interval::PI * (s - log(2)))
            }
        };
        let within = |v: Interval| Interval::new(v.lo().max(0.0), v.hi().max(0.0));
        (within(share), within(marginal))
    }
}

/// Shares and marginals of (1 - R²)ᵏ, k = 0, 1, 2, … at one distance.
struct Bells {
    x: Interval,
    /// 1 - D².
    edge: Interval,
    /// (1 - D²)^(k-½) before step k.
    power: Interval,
    share: Interval,
    /// N_(k-1).
    whole: Interval,
    k: i64,
}

impl Bells {
    fn new(x: Interval) -> Self {
        // Not 1 - x², whose rounding a square root would magnify near the rim.
        let edge = (Interval::from(1.0) - x) * (Interval::from(1.0) + x);
        let edge = Interval::new(edge.lo().max(0.0), edge.hi().max(0.0));
        let share = x.arccos() / Interval::PI;
        // Before step 0 the power is a reciprocal root; it is not read there.
        Bells { x, edge, power: Interval::from(1.0), share, whole: Interval::PI, k: 0 }
    }

    /// Share and marginal (per d) of the next power.
    fn step(&mut self) -> (Interval, Interval) {
        let k = self.k;
        self.power = if k == 0 { self.edge.square_root() } else { self.power * self.edge };
        self.whole = self.whole * Interval::int(2 * k + 1) / Interval::int(2 * k + 2);
        self.share = self.share - self.x * self.power / (Interval::int(2 * k + 2) * self.whole);
        self.k += 1;
        (self.share, Interval::from(2.0) * self.power / self.whole)
    }
}

/// sup over d in [0, ½] of |P(d) - share beyond d|, P = p₀ + p₁ d + p₂ d² + p₃ d³; `at` is d.
///
/// ```
/// use bellfit::bound::{ClippedPixel, Interval, clip_distance};
/// // 2 (½ - d)² against σ = 1/6
/// let p = [0.5, -2.0, 2.0, 0.0].map(Interval::from);
/// let found = clip_distance(p, ClippedPixel::Gaussian(Interval::from(6.0)), 1e-7);
/// assert!(found.value.lo() > 6.50e-2 && found.value.hi() < 6.51e-2);
/// ```
pub fn clip_distance(p: [Interval; 4], pixel: ClippedPixel, tolerance: f64) -> Supremum<1> {
    let p = p.map(Jet::constant);
    let error = |d: Jet| p[0] + d * (p[1] + d * (p[2] + d * p[3])) - pixel.share_beyond(d);
    let cell = |[d]: &[Interval; 1]| range(error, *d).abs();
    supremum(cell, [Interval::new(0.0, 0.5)], tolerance, MOST_BOXES)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn whole(m: u32) -> ClippedPixel {
        ClippedPixel::Gaussian(Interval::from(f64::from(m)))
    }

    fn all() -> [ClippedPixel; 7] {
        [
            whole(6),
            ClippedPixel::GaussianOnBase(6),
            whole(5),
            whole(4),
            ClippedPixel::Bell(0),
            ClippedPixel::Bell(8),
            ClippedPixel::Cone,
        ]
    }

    #[test]
    fn an_edge_through_the_centre_halves_and_one_at_the_rim_leaves_nothing() {
        for pixel in all() {
            let at = |d: f64| pixel.share_beyond(Jet::variable(Interval::from(d))).value;
            assert!(at(0.0).contains(0.5) && at(0.0).width() < 1e-13, "{pixel:?}: {:?}", at(0.0));
            if !matches!(pixel, ClippedPixel::Gaussian(_)) {
                assert!(at(0.5).contains(0.0) && at(0.5).width() < 1e-13, "{pixel:?}: {:?}", at(0.5));
            }
        }
    }

    /// Cut at the base, a narrow Gaussian loses nothing that counts.
    #[test]
    fn on_its_base_a_narrow_gaussian_is_the_whole_one() {
        for m in [14, 40, NARROWEST, NARROWEST + 1] {
            for d in [0.0, 0.01, 0.1, 0.4, 0.5] {
                let at = |pixel: ClippedPixel| pixel.share_beyond(Jet::variable(Interval::from(d)));
                let (whole, base) = (at(whole(m)), at(ClippedPixel::GaussianOnBase(m)));
                // e^(-m²/8) of it lies beyond the base.
                let lost = libm::exp(-f64::from(m * m) / 8.0);
                let around = base.value - Interval::new(-lost, lost);
                assert!(!around.is_disjoint(whole.value), "{m} {d}: {base:?} {whole:?}");
                assert!(m > NARROWEST || base.value.width() < 1e-9, "{m} {d}: {base:?}");
            }
        }
    }

    /// By the mean value theorem a difference quotient is a slope at a point between.
    #[test]
    fn slopes_are_minus_the_marginal() {
        for pixel in all() {
            for i in 0..25 {
                let d = Interval::new(0.02 * f64::from(i), 0.02 * f64::from(i + 1));
                let jet = pixel.share_beyond(Jet::variable(d));
                let at = |x: f64| pixel.share_beyond(Jet::variable(Interval::from(x))).value;
                let quotient = (at(d.hi()) - at(d.lo())) / (Interval::from(d.hi()) - Interval::from(d.lo()));
                assert!(!jet.slope.is_disjoint(quotient), "{pixel:?} {d:?}: {jet:?} {quotient:?}");
                assert!(jet.slope.width() < 0.6, "{pixel:?} {d:?}: {jet:?}");
            }
        }
    }
}
