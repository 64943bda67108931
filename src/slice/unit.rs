//! The vector unit that a loop runs on.

use std::sync::OnceLock;

/// A body to be compiled for every vector unit.
///
/// `run` must be `#[inline(always)]`, and so must what its loops call: only what is inlined is compiled for
/// the unit. Lanes are arrays of a fixed length, which the compiler turns into vectors.
pub trait Job {
    /// What it computes.
    type Output;

    /// The body.
    fn run(self) -> Self::Output;
}

/// A body that fuses a multiply with an add where the unit does, and nowhere else: where it does not, a fused
/// one is a call of the library. The other rules are those of [`Job`].
pub(super) trait FusedJob {
    /// What it computes.
    type Output;

    /// The body.
    fn run<const FUSED: bool>(self) -> Self::Output;
}

/// A job that fuses or does not, decided.
struct Decided<J, const FUSED: bool>(J);

impl<J: FusedJob, const FUSED: bool> Job for Decided<J, FUSED> {
    type Output = J::Output;

    #[inline(always)]
    fn run(self) -> J::Output {
        self.0.run::<FUSED>()
    }
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
enum Kind {
    Plain,
    #[cfg(target_arch = "x86_64")]
    Avx2,
    #[cfg(target_arch = "x86_64")]
    Avx512,
}

/// A vector unit that this machine has: a value of this type is the proof that it has it.
///
/// ```
/// use bellfit::slice::{Job, Unit};
/// struct Dot<'a>(&'a [f32], &'a [f32]);
/// impl Job for Dot<'_> {
///     type Output = f32;
///     #[inline(always)]
///     fn run(self) -> f32 {
///         let mut lanes = [0.0; 8];
///         for (a, b) in self.0.chunks_exact(8).zip(self.1.chunks_exact(8)) {
///             for i in 0..8 {
///                 lanes[i] += a[i] * b[i];
///             }
///         }
///         lanes.iter().sum()
///     }
/// }
/// let (a, b) = ([0.1; 64], [0.3; 64]);
/// let plain = Unit::plain().run(Dot(&a, &b));
/// assert!(Unit::available().all(|unit| unit.run(Dot(&a, &b)) == plain));
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Unit(Kind);

impl Unit {
    /// What the crate is compiled for; every machine has it.
    pub fn plain() -> Unit {
        Unit(Kind::Plain)
    }

    /// The widest that this machine has, found once.
    #[inline]
    pub fn best() -> Unit {
        static BEST: OnceLock<Unit> = OnceLock::new();
        *BEST.get_or_init(|| Unit::available().last().unwrap_or(Unit::plain()))
    }

    /// All that this machine has, the plain one first, the widest last.
    #[cfg(target_arch = "x86_64")]
    pub fn available() -> impl Iterator<Item = Unit> {
        let avx2 = is_x86_feature_detected!("avx2") && is_x86_feature_detected!("fma");
        let avx512 = avx2
            && is_x86_feature_detected!("avx512f")
            && is_x86_feature_detected!("avx512bw")
            && is_x86_feature_detected!("avx512dq")
            && is_x86_feature_detected!("avx512vl");
        let all = [(true, Kind::Plain), (avx2, Kind::Avx2), (avx512, Kind::Avx512)];
        all.into_iter().filter(|&(has, _)| has).map(|(_, kind)| Unit(kind))
    }

    /// All that this machine has, the plain one first, the widest last.
    #[cfg(not(target_arch = "x86_64"))]
    pub fn available() -> impl Iterator<Item = Unit> {
        std::iter::once(Unit::plain())
    }

    /// `plain`, `avx2` or `avx512`.
    pub fn id(self) -> &'static str {
        match self.0 {
            Kind::Plain => "plain",
            #[cfg(target_arch = "x86_64")]
            Kind::Avx2 => "avx2",
            #[cfg(target_arch = "x86_64")]
            Kind::Avx512 => "avx512",
        }
    }

    /// The job's result, by the copy compiled for this unit.
    #[inline]
    #[allow(unsafe_code)] // the one place: calling code that is compiled for features the machine has
    pub fn run<J: Job>(self, job: J) -> J::Output {
        match self.0 {
            Kind::Plain => job.run(),
            #[cfg(target_arch = "x86_64")]
            // SAFETY: a `Unit` of this kind is made in `available` alone, where the machine has AVX2 and FMA.
            Kind::Avx2 => unsafe { avx2(job) },
            #[cfg(target_arch = "x86_64")]
            // SAFETY: likewise, where it has AVX-512 F, BW, DQ and VL, AVX2 and FMA.
            Kind::Avx512 => unsafe { avx512(job) },
        }
    }

    /// The same for a job that fuses where the unit does.
    #[inline]
    #[allow(unsafe_code)] // as `run`
    pub(super) fn run_fused<J: FusedJob>(self, job: J) -> J::Output {
        match self.0 {
            Kind::Plain => job.run::<false>(),
            #[cfg(target_arch = "x86_64")]
            // SAFETY: as in `run`.
            Kind::Avx2 => unsafe { avx2(Decided::<J, true>(job)) },
            #[cfg(target_arch = "x86_64")]
            // SAFETY: as in `run`.
            Kind::Avx512 => unsafe { avx512(Decided::<J, true>(job)) },
        }
    }
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx2,fma")]
fn avx2<J: Job>(job: J) -> J::Output {
    job.run()
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx512f,avx512bw,avx512dq,avx512vl,avx2,fma")]
fn avx512<J: Job>(job: J) -> J::Output {
    job.run()
}
