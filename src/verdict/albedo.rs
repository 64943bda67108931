//! Statements that no light is gained at any angle, with the exponents taken one by one.

use super::judgement::{Finding, Verdict};
use crate::bound::{Formula, Interval, Polynomial};
use crate::integral::albedo::{
    AlbedoError, Profile, Reflectance, Supremum, directional_albedo, supremum_over_angles,
};
use crate::integral::{Estimate, Field, Lobe};
use crate::kernel::lobe::{cos_n_versine, cs_versine};
use core::f64::consts::FRAC_PI_2;

/// What one exponent has to say, times the factor.
struct Found {
    n: u32,
    /// Where the largest albedo is, in degrees.
    angle: f64,
    largest: Interval,
    /// What no angle exceeds.
    ceiling: Interval,
}

/// a(θ) ≤ 1 for every θ and every whole n of the range: by theorems about quadratures, so estimated.
pub(super) fn energy_at_every_angle(of: Reflectance, lobe: Lobe, factor: &Formula, n: (u32, u32)) -> Finding {
    let mut all = Vec::new();
    for n in n.0..=n.1 {
        match found(of, lobe, factor, n) {
            Ok(found) => all.push(found),
            // Of the factor: these lobes keep their shape at every n.
            Err(error) => return undecided(None, format!("{error}, at n = {n}")),
        }
    }
    let most = all.iter().map(|f| f.largest.lo()).fold(f64::NEG_INFINITY, f64::max);
    // Ties within what is known go to the smallest n, but to none of which less is known.
    let tied = |f: &&Found| f.largest.hi() >= most && (f.largest.lo() > 1.0) == (most > 1.0);
    let Some(worst) = all.iter().find(tied) else {
        return undecided(None, format!("no exponent in {}..{}", n.0, n.1));
    };
    let (text, place) = (beside_one(worst.largest.mid()), place(worst.angle));
    let computed = Some(worst.largest);
    if worst.largest.lo() > 1.0 {
        let place = exceeded(of, lobe, factor, worst);
        let witness = format!("gains energy: the albedo reaches {text} {place}, n = {}", worst.n);
        Finding { printed: String::new(), computed, verdict: Verdict::Refuted, witness }
    } else if all.iter().all(|f| f.ceiling.hi() <= 1.0) {
        let witness = format!("the albedo is at most {text} {place}, n = {}", worst.n);
        Finding { printed: String::new(), computed, verdict: Verdict::Reproduced, witness }
    } else {
        undecided(computed, format!("the albedo reaches {text} {place}, n = {}", worst.n))
    }
}

/// An albedo by its distance from 1, where all its digits are zeros or nines.
fn beside_one(albedo: f64) -> String {
    let beside = albedo - 1.0;
    match () {
        () if beside.abs() > 1e-4 => format!("{albedo:.7}"),
        () if beside > 0.0 => format!("1 + {beside:.1e}"),
        () => format!("1 - {:.1e}", beside.abs()),
    }
}

fn undecided(computed: Option<Interval>, witness: String) -> Finding {
    Finding { printed: String::new(), computed, verdict: Verdict::Undecided, witness }
}

fn found(of: Reflectance, lobe: Lobe, factor: &Formula, n: u32) -> Result<Found, AlbedoError> {
    let Supremum { at, ceiling, .. } =
        with_lobe(lobe, f64::from(n), |profile| supremum_over_angles(of, profile, 1.0))?;
    let factor = value(factor, f64::from(n));
    // As for the library's own factors: finite and not negative.
    if !(factor.lo() >= 0.0 && factor.hi() < f64::INFINITY) {
        return Err(AlbedoError::Factor(factor.mid()));
    }
    let times = |e: Estimate| Interval::new(e.value - e.error, e.value + e.error) * factor;
    Ok(Found { n, angle: at.degrees(), largest: times(at.value), ceiling: times(ceiling) })
}

/// Where the largest is, and where it is a limit at grazing light, an angle before that exceeds 1 too.
fn exceeded(of: Reflectance, lobe: Lobe, factor: &Formula, worst: &Found) -> String {
    let (n, factor) = (f64::from(worst.n), value(factor, f64::from(worst.n)));
    let exceeds = |angle: &f64| {
        let theta = FRAC_PI_2 * (angle / 90.0);
        let at = with_lobe(lobe, n, |profile| directional_albedo(of, profile, 1.0, theta));
        at.is_ok_and(|at| (Interval::from(at.value - at.error) * factor).lo() > 1.0)
    };
    let before = [89.9, 89.99, 89.999, 89.9999, 89.99999, 89.999999].into_iter().find(exceeds);
    match before {
        Some(before) if worst.angle == 90.0 => format!("{} and exceeds 1 {}", place(90.0), place(before)),
        _ => place(worst.angle),
    }
}

/// An angle in degrees; the right angle is a limit.
fn place(angle: f64) -> String {
    if angle < 90.0 { format!("at θ = {angle}°") } else { "as θ → 90°".to_owned() }
}

/// The lobe about its axis, to the end of its support.
fn with_lobe<T>(
    lobe: Lobe,
    n: f64,
    then: impl FnOnce(&Profile<'_>) -> Result<T, AlbedoError>,
) -> Result<T, AlbedoError> {
    match lobe {
        Lobe::CosN => then(&Profile::new(&|w| cos_n_versine(w, n), 1.0, n)?),
        Lobe::Cs16 => then(&Profile::new(&|w| cs_versine::<16, f64>(w, n), (16.0 / n).min(2.0), n)?),
    }
}

/// Encloses the factor at n.
fn value(factor: &Formula, n: f64) -> Interval {
    let h = (Interval::from(-0.5 * n) * Interval::LN_2).exp();
    let variables = [Interval::from(n), h, Interval::PI];
    let sum = |polynomial: &Polynomial| {
        let term = |(coefficient, exponents): (Interval, [u32; 3])| {
            variables.iter().zip(exponents).fold(coefficient, |product, (x, k)| product * x.power(k))
        };
        polynomial.compile().into_iter().map(term).fold(Interval::from(0.0), |sum, term| sum + term)
    };
    sum(&factor.numerator) / sum(&factor.denominator)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::kernel::factor::{cos_n_factor, cs_16_factor_printed};
    use crate::kernel::model::Model;

    /// Seven digits say nothing of what is a millionth from 1.
    #[test]
    fn an_albedo_near_1_is_told_by_its_distance() {
        for (albedo, text) in [
            (1.25, "1.2500000"),
            (0.5, "0.5000000"),
            (1.0 + 2e-5, "1 + 2.0e-5"),
            (1.0 - 2e-5, "1 - 2.0e-5"),
            (1.0 + 2e-4, "1.0002000"),
            (1.0 - 2e-4, "0.9998000"),
        ] {
            assert_eq!(beside_one(albedo), text);
        }
    }

    #[test]
    fn a_formula_is_the_kernels_factor() {
        let formula = |text: &str| text.parse::<Formula>().unwrap();
        let table = formula("(n + 2)*(n + 4)/(8*pi*(2^(-n/2) + n))");
        let line = formula("(1.068*n + 0.96)/(8*pi)");
        for n in [1.0, 16.0, 64.0, 1024.0] {
            // A few roundings of the kernel's.
            for (enclosed, kernel) in [
                (value(&table, n), cos_n_factor(Model::BlinnPhongModified, n)),
                (value(&line, n), cs_16_factor_printed(Model::BlinnPhong).at(n)),
            ] {
                assert!((enclosed.mid() / kernel - 1.0).abs() < 8.0 * f64::EPSILON, "{enclosed:?}, {kernel}");
                assert!(enclosed.width() < 64.0 * f64::EPSILON * kernel);
            }
        }
        assert_eq!(value(&formula("1/(n - 16)"), 16.0), Interval::WHOLE);
    }
}
