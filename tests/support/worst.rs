//! The kernels of one variable whose f32 rounding is exhausted, and the worst that was found.
#![allow(dead_code)] // every test file uses its part

use bellfit::kernel::bell::bell;
use bellfit::kernel::cubic::cubic_bell;
use bellfit::kernel::pixel::{SIGMA, clip_volume};
use bellfit::kernel::real::Real;
use bellfit::stability::{Clip, DoubleDouble, fitted_bell, lyon_bell};

pub struct Kernel {
    pub name: &'static str,
    /// The last argument; the first is 0.
    pub end: f32,
    pub single: fn(f32) -> f32,
    /// The same in f64: within `slack` of the exact value.
    pub double: fn(f64) -> f64,
    pub slack: f64,
    pub exact: fn(f64) -> DoubleDouble,
}

/// σ as the f32 kernel holds it.
pub fn sigma() -> f32 {
    SIGMA as f32
}

fn of_bell<const K: u32>(name: &'static str) -> Kernel {
    // bell's page: (1 + u)^(2K - 1), so 127 u = 1.4e-14 at most.
    let exact = |t| lyon_bell(K, DoubleDouble::from(t));
    Kernel { name, end: K as f32, single: bell::<K, f32>, double: bell::<K, f64>, slack: 1e-13, exact }
}

fn of_cubic<const K: u32>(name: &'static str) -> Kernel {
    // Some 10 roundings of numbers up to 2, raised to the power K ≤ 8: 160 u = 1.8e-14.
    let exact = |t| fitted_bell(K, DoubleDouble::from(t)).expect("K is 2, 4 or 8");
    Kernel {
        name,
        end: 16.0,
        single: cubic_bell::<K, f32>,
        double: cubic_bell::<K, f64>,
        slack: 1e-13,
        exact,
    }
}

pub fn kernels() -> Vec<Kernel> {
    vec![
        of_bell::<2>("bell 2"),
        of_bell::<4>("bell 4"),
        of_bell::<8>("bell 8"),
        of_bell::<16>("bell 16"),
        of_bell::<32>("bell 32"),
        of_bell::<64>("bell 64"),
        of_cubic::<2>("cubic bell 2"),
        of_cubic::<4>("cubic bell 4"),
        of_cubic::<8>("cubic bell 8"),
        Kernel {
            name: "exponential",
            end: 104.0, // e^-104 is below the smallest subnormal number
            single: |t| Real::exp(-t),
            double: |t| Real::exp(-t),
            slack: 1e-15, // libm's is within an ulp of numbers up to 1; four are left over
            exact: |t| (-DoubleDouble::from(t)).exp(),
        },
        Kernel {
            name: "clip volume",
            end: 0.5,
            single: |d| clip_volume(d, sigma()),
            double: |d| clip_volume(d, f64::from(sigma())),
            slack: 1e-15, // its page: 2 u = 2.2e-16
            exact: |d| Clip::Whole.exact(d, f64::from(sigma())),
        },
    ]
}

/// |computed - exact| at one argument.
pub fn error(kernel: &Kernel, t: f32) -> f64 {
    let value = DoubleDouble::from(f64::from((kernel.single)(t)));
    (value - (kernel.exact)(f64::from(t))).abs().to_f64()
}

/// The largest |computed - exact| over every f32 from 0 to the kernel's end and the bits of the first argument
/// where, as tests/stability_exhaustive.rs finds them.
pub const WORST: [(&str, u32, f64); 11] = [
    ("bell 2", 0x39b4_f800, 8.939031292953814e-8),
    ("bell 4", 0x3bff_0100, 2.0721038534995302e-7),
    ("bell 8", 0x3c78_e900, 4.3526134129465766e-7),
    ("bell 16", 0x3cf6_cd01, 8.698686614535878e-7),
    ("bell 32", 0x3d84_717f, 1.7051617962125812e-6),
    ("bell 64", 0x3d72_b201, 3.239264350545146e-6),
    ("cubic bell 2", 0x3f14_7653, 1.1341643463418933e-7),
    ("cubic bell 4", 0x3c39_ddff, 2.0762660473565286e-7),
    ("cubic bell 8", 0x3c79_4490, 4.3495100205807183e-7),
    ("exponential", 0x3eb0_50f1, 4.988704953333428e-8),
    ("clip volume", 0x3e2f_78f5, 4.2886024461102e-8),
];
