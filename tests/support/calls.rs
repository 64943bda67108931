//! Calls of the emitted functions: their arguments over the domain, and what the kernels give there.
#![allow(dead_code)] // every test file uses its part

use super::draw::Draw;
use bellfit::bound::Format;
use bellfit::kernel::cubic::CubicLobe;
use bellfit::kernel::exact::{cs_16_factor_exact, cs_factor};
use bellfit::kernel::factor::{cos_n_factor, cs_16_factor_one_sided, cubic_factor};
use bellfit::kernel::linear::LinearLobe;
use bellfit::kernel::model::{LobeAngle, Model};
use bellfit::kernel::pixel::{Footprint, Jacobian, Padding, PaperReading, PixelWeight};
use bellfit::kernel::real::Real;
use bellfit::kernel::stand_in::{Argument, StandIn};
use bellfit::shader::Piece;

/// A type with its bits, and its names in the drivers.
pub trait Number: Real {
    const EPSILON: f64;
    /// The largest size of a rounding below the normal numbers.
    const TINY: f64;
    /// The type, that of its bits, and the format.
    const C: (&'static str, &'static str, Format);
    const RUST: (&'static str, &'static str, Format);
    fn bits(self) -> u64;
    fn of_bits(bits: u64) -> Self;
}

impl Number for f32 {
    const EPSILON: f64 = f32::EPSILON as f64;
    const TINY: f64 = 2e-45;
    const C: (&'static str, &'static str, Format) = ("float", "uint32_t", Format::Single);
    const RUST: (&'static str, &'static str, Format) = ("f32", "u32", Format::Single);
    fn bits(self) -> u64 {
        u64::from(self.to_bits())
    }
    fn of_bits(bits: u64) -> Self {
        f32::from_bits(u32::try_from(bits).unwrap())
    }
}

impl Number for f64 {
    const EPSILON: f64 = f64::EPSILON;
    const TINY: f64 = 5e-324;
    const C: (&'static str, &'static str, Format) = ("double", "uint64_t", Format::Double);
    const RUST: (&'static str, &'static str, Format) = ("f64", "u64", Format::Double);
    fn bits(self) -> u64 {
        self.to_bits()
    }
    fn of_bits(bits: u64) -> Self {
        f64::from_bits(bits)
    }
}

/// How near the kernels' value a result must be.
pub enum Near {
    /// The same number; of zeros either.
    Same,
    /// Within so many ε of it, of 1 + |ln value| times it: functions of the platform's library beside libm's.
    Elementary(f64),
    /// Within so many ε of it.
    Relative(f64),
    /// Within so many ε.
    Absolute(f64),
    /// Within so many ε of 1 + |it|.
    Mixed(f64),
}

/// How a function takes its arguments and gives its result.
pub enum Shape {
    /// Numbers, how many.
    Numbers(usize),
    /// A number and a whole one.
    Count,
    /// So many numbers; a structure back.
    Makes(usize, &'static str, &'static [&'static str]),
    /// A structure, then so many numbers.
    Takes(&'static str, &'static [&'static str], usize),
}

type Kernel<F> = Box<dyn Fn(&[F]) -> Vec<F>>;

/// A function with arguments and what it must give.
pub struct Call<F> {
    pub name: String,
    pub shape: Shape,
    pub arguments: Vec<Vec<F>>,
    pub kernel: Kernel<F>,
    pub near: Near,
}

impl<F: Number> Call<F> {
    pub fn check(&self, arguments: &[F], found: &[F], language: &str) {
        for (value, &found) in (self.kernel)(arguments).into_iter().zip(found) {
            let (v, x) = (value.to_f64(), found.to_f64());
            let allowed = match self.near {
                Near::Same => 0.0,
                Near::Elementary(times) => {
                    times * F::EPSILON * v.abs() * (1.0 + libm::log(v.abs()).abs().min(1e3))
                }
                Near::Relative(times) => times * F::EPSILON * v.abs(),
                Near::Absolute(times) => times * F::EPSILON,
                Near::Mixed(times) => times * F::EPSILON * (1.0 + v.abs()),
            };
            let allowed =
                if matches!(self.near, Near::Same) || v == 0.0 { allowed } else { allowed + F::TINY };
            let name = &self.name;
            assert!((v - x).abs() <= allowed || v == x, "{language} {name}{arguments:?}: {x:e}, not {v:e}");
        }
    }

    fn list(from: usize, count: usize) -> String {
        (from..from + count).map(|i| format!("x[{i}]")).collect::<Vec<_>>().join(", ")
    }

    pub fn c_case(&self, index: usize) -> String {
        let name = &self.name;
        let body = match &self.shape {
            Shape::Numbers(count) => format!("y[0] = {name}({});", Self::list(0, *count)),
            Shape::Count => format!("y[0] = {name}(x[0], (uint32_t)x[1]);"),
            Shape::Makes(count, record, fields) => {
                let fields: String =
                    fields.iter().enumerate().map(|(i, f)| format!(" y[{i}] = k.{f};")).collect();
                format!("{record} k = {name}({});{fields}", Self::list(0, *count))
            }
            Shape::Takes(record, fields, count) => {
                let (fields, rest) = (Self::list(0, fields.len()), Self::list(fields.len(), *count));
                format!("{record} k = {{{fields}}}; y[0] = {name}(k, {rest});")
            }
        };
        format!("        case {index}: {{ {body} break; }}\n")
    }

    pub fn rust_case(&self, index: usize) -> String {
        let name = &self.name;
        let body = match &self.shape {
            Shape::Numbers(count) => format!("y[0] = {name}({});", Self::list(0, *count)),
            Shape::Count => format!("y[0] = {name}(x[0], x[1] as u32);"),
            Shape::Makes(count, _, fields) => {
                let fields: String =
                    fields.iter().enumerate().map(|(i, f)| format!(" y[{i}] = k.{f};")).collect();
                format!("let k = {name}({});{fields}", Self::list(0, *count))
            }
            Shape::Takes(record, fields, count) => {
                let rest = Self::list(fields.len(), *count);
                let fields: Vec<String> =
                    fields.iter().enumerate().map(|(i, f)| format!("{f}: x[{i}]")).collect();
                format!("let k = {record} {{ {} }}; y[0] = {name}(k, {rest});", fields.join(", "))
            }
        };
        format!("            {index} => {{ {body} }}\n")
    }
}

/// Exponents: the ends of the papers' range, whole and not, and some beyond.
pub fn exponents() -> Vec<f64> {
    let mut draw = Draw(7);
    let mut all = vec![16.0, 17.5, 32.0, 54.625, 55.0, 64.0, 100.0, 333.25, 512.0, 1000.0, 1024.0, 4096.0];
    all.extend((0..6).map(|_| draw.real(16.0, 1024.0)));
    all
}

/// Numbers in [0, 1]: both ends, powers of two near both, and the rest by chance.
pub fn unit<F: Number>(seed: u64) -> Vec<F> {
    let mut draw = Draw(seed);
    let mut all = vec![0.0, 1.0];
    for e in 1..=24 {
        let step = libm::scalbn(1.0, -e);
        all.extend([step, 1.0 - step, 1.5 * step, 1.0 - 1.5 * step]);
    }
    all.extend([-30, -60, -100, -126].map(|e| libm::scalbn(1.0, e)));
    all.extend((0..40).map(|_| draw.real(0.0, 1.0)));
    // Where the lobes live: n w about 1 to 20.
    all.extend((0..40).map(|_| 1.0 - draw.real(0.0, 0.3)));
    all.into_iter().map(F::from_f64).collect()
}

fn title(stand_in: StandIn, versine: bool) -> &'static str {
    match (stand_in, versine) {
        (StandIn::Cs16, _) => "Cs16Constants",
        (StandIn::Linear2, _) => "Linear2Constants",
        (StandIn::Linear4, _) => "Linear4Constants",
        (StandIn::Linear8, _) => "Linear8Constants",
        (StandIn::Linear16, _) => "Linear16Constants",
        (StandIn::Linear32, _) => "Linear32Constants",
        (StandIn::Cubic2, false) => "Cubic2Constants",
        (StandIn::Cubic4, false) => "Cubic4Constants",
        (StandIn::Cubic8, false) => "Cubic8Constants",
        (StandIn::Cubic2, true) => "Cubic2VersineConstants",
        (StandIn::Cubic4, true) => "Cubic4VersineConstants",
        _ => "Cubic8VersineConstants",
    }
}

const LINEAR: &[&str] = &["offset", "slope"];
const HORNER: &[&str] = &["first", "second", "third"];
const DEPRESSED: &[&str] = &["offset", "slope", "tilt", "level"];
const FOOTPRINT: &[&str] = &["uu", "uv", "vv", "det_m"];

/// The constants of a bell as the emitted functions have them.
fn constants<F: Real>(stand_in: StandIn, versine: bool, n: F) -> Vec<F> {
    fn cubic<const K: u32, F: Real>(n: F, depressed: bool) -> Vec<F> {
        let lobe = CubicLobe::<K, F>::new(n);
        if depressed { lobe.depressed().to_vec() } else { lobe.horner().to_vec() }
    }
    let linear = match stand_in {
        StandIn::Cs16 => LinearLobe::<16, F>::lyon(n).constants(),
        StandIn::Linear2 => LinearLobe::<2, F>::new(n).constants(),
        StandIn::Linear4 => LinearLobe::<4, F>::new(n).constants(),
        StandIn::Linear8 => LinearLobe::<8, F>::new(n).constants(),
        StandIn::Linear16 => LinearLobe::<16, F>::new(n).constants(),
        StandIn::Linear32 => LinearLobe::<32, F>::new(n).constants(),
        StandIn::Cubic2 => return cubic::<2, F>(n, !versine),
        StandIn::Cubic4 => return cubic::<4, F>(n, !versine),
        _ => return cubic::<8, F>(n, false),
    };
    if versine { vec![linear[1]] } else { linear.to_vec() }
}

fn value<F: Real>(stand_in: StandIn, argument: Argument, x: F, n: F) -> F {
    match argument {
        Argument::Cosine => stand_in.at(x, n),
        Argument::Versine => stand_in.at_versine(x, n),
    }
}

pub fn calls<F: Number>(piece: &Piece) -> Vec<Call<F>> {
    match piece {
        Piece::Lobe { stand_in, argument, .. } if stand_in.bell().is_some() => bell(*stand_in, *argument),
        Piece::Lobe { stand_in, argument, .. } => vec![closed(*stand_in, *argument)],
        Piece::Factor { model, stand_in, .. } => factor(*model, *stand_in),
        Piece::Footprint => footprint(),
        Piece::Weight(found) => vec![weight(*found)],
    }
}

fn bell<F: Number>(stand_in: StandIn, argument: Argument) -> Vec<Call<F>> {
    let versine = argument == Argument::Versine;
    let suffix = if versine { "_versine" } else { "" };
    let stem = stand_in.id().replace('-', "_");
    let (_, degree) = stand_in.bell().unwrap();
    let is_depressed = matches!(stand_in, StandIn::Cubic2 | StandIn::Cubic4) && !versine;
    let fields = match degree {
        1 => LINEAR,
        _ if is_depressed => DEPRESSED,
        _ => HORNER,
    };
    let record = title(stand_in, versine);
    let is_slope = degree == 1 && versine;
    let ns: Vec<F> = exponents().into_iter().map(F::from_f64).collect();
    let makes = Call {
        name: if is_slope { format!("{stem}_slope") } else { format!("{stem}{suffix}_constants") },
        shape: if is_slope { Shape::Numbers(1) } else { Shape::Makes(1, record, fields) },
        arguments: ns.iter().map(|n| vec![*n]).collect(),
        kernel: Box::new(move |x| constants(stand_in, versine, x[0])),
        // The platform's cbrt may be 1 ulp from libm's, and so b and with it a - b, of one size; c and d are
        // sums of terms below 3 with three and five factors b, ε each.
        near: if is_depressed { Near::Mixed(16.0) } else { Near::Same },
    };
    let mut xs = unit::<F>(11);
    xs.push(F::from_f64(if versine { 1.25 } else { -0.25 }));
    let mut arguments = Vec::new();
    for n in &ns {
        for x in &xs {
            let mut row = constants(stand_in, versine, *n);
            row.push(*x);
            arguments.push(row);
        }
    }
    // The kernels take n: it is found again by the row's constants.
    let rows: Vec<(Vec<F>, F)> = ns.iter().map(|n| (constants(stand_in, versine, *n), *n)).collect();
    let takes = Call {
        name: format!("{stem}_lobe{suffix}"),
        shape: if is_slope { Shape::Numbers(2) } else { Shape::Takes(record, fields, 1) },
        arguments,
        kernel: Box::new(move |row| {
            let (x, constants) = row.split_last().unwrap();
            let (_, n) = rows.iter().find(|(known, _)| known == constants).unwrap();
            vec![value(stand_in, argument, *x, *n)]
        }),
        near: Near::Same,
    };
    vec![makes, takes]
}

fn closed<F: Number>(stand_in: StandIn, argument: Argument) -> Call<F> {
    let suffix = if argument == Argument::Versine { "_versine" } else { "" };
    let (stem, near) = match stand_in {
        StandIn::Schlick => ("schlick_lobe", Near::Same),
        StandIn::SchlickPrinted => ("schlick_printed_lobe", Near::Same),
        StandIn::Squarings => ("cos_n_squarings", Near::Same),
        // Each library's exp, log2, exp2 and pow is within 1 ulp; of log2 that counts n log2 c times, and
        // ln value times ln 2 is that.
        StandIn::SphericalGaussian => ("spherical_gaussian", Near::Elementary(4.0)),
        StandIn::Exp2Log2 => ("cos_n_base_two", Near::Elementary(4.0)),
        _ => ("cos_n_pow", Near::Elementary(4.0)),
    };
    let mut xs = unit::<F>(13);
    xs.push(F::from_f64(if argument == Argument::Versine { 1.25 } else { -0.25 }));
    let is_whole = stand_in == StandIn::Squarings;
    let ns = exponents().into_iter().filter(|n| !is_whole || n.fract() == 0.0).map(F::from_f64);
    Call {
        name: format!("{stem}{suffix}"),
        shape: if is_whole { Shape::Count } else { Shape::Numbers(2) },
        arguments: ns.flat_map(|n| xs.iter().map(move |x| vec![*x, n]).collect::<Vec<_>>()).collect(),
        kernel: Box::new(move |x| vec![value(stand_in, argument, x[0], x[1])]),
        near,
    }
}

fn factor<F: Number>(model: Model, stand_in: StandIn) -> Vec<Call<F>> {
    let (id, stem) = (model.id().replace('-', "_"), stand_in.id().replace('-', "_"));
    let at = |from: f64| -> Vec<Vec<F>> {
        exponents().into_iter().filter(|n| *n >= from).map(|n| vec![F::from_f64(n)]).collect()
    };
    let call = |name: String, from: f64, near: Near, kernel: Kernel<F>| Call {
        name,
        shape: Shape::Numbers(1),
        arguments: at(from),
        kernel,
        near,
    };
    match stand_in {
        StandIn::Cs16 => {
            // 16/(1 - √½) = 54.63, where the hemisphere's edge is reached in θ/2
            let edge = if model.angle() == LobeAngle::Half { 54.7 } else { 16.0 };
            vec![
                call(
                    format!("cs_16_factor_line_{id}"),
                    16.0,
                    Near::Same,
                    Box::new(move |x| vec![cs_16_factor_one_sided(model).at(x[0])]),
                ),
                call(
                    format!("cs_16_factor_exact_{id}"),
                    edge,
                    Near::Same,
                    Box::new(move |x| vec![cs_16_factor_exact(model, x[0])]),
                ),
            ]
        }
        StandIn::Cubic2 | StandIn::Cubic4 | StandIn::Cubic8 => {
            let kernel: Kernel<F> = match stand_in {
                StandIn::Cubic2 => Box::new(move |x| vec![cubic_factor::<2, F>(model, x[0])]),
                StandIn::Cubic4 => Box::new(move |x| vec![cubic_factor::<4, F>(model, x[0])]),
                _ => Box::new(move |x| vec![cubic_factor::<8, F>(model, x[0])]),
            };
            vec![call(format!("{stem}_factor_{id}"), 16.0, Near::Same, kernel)]
        }
        StandIn::Squarings | StandIn::Exp2Log2 | StandIn::Power => {
            let has_exp2 = model.angle() == LobeAngle::Half;
            // 2^(-n/2) by either library, at most 1/256 beside n
            let near = if has_exp2 { Near::Relative(2.0) } else { Near::Same };
            let kernel: Kernel<F> = Box::new(move |x| vec![cos_n_factor(model, x[0])]);
            vec![call(format!("cos_n_factor_{id}"), 16.0, near, kernel)]
        }
        _ => match stand_in.bell() {
            Some((power, _)) => {
                // T(16)/(1 - √½), above the n from which the form is exact
                let edge = if model.angle() == LobeAngle::Half {
                    112.0_f64.min(3.5 * f64::from(power) + 1.0)
                } else {
                    32.7
                };
                let kernel: Kernel<F> = Box::new(move |x| {
                    let n = x[0].to_f64();
                    // K n/T is K times the lobe's slope.
                    let slope = constants(stand_in, true, n)[0];
                    let equivalent = f64::from(power) * slope;
                    let exact = match power {
                        2 => cs_factor::<2, f64>(model, equivalent),
                        4 => cs_factor::<4, f64>(model, equivalent),
                        8 => cs_factor::<8, f64>(model, equivalent),
                        16 => cs_factor::<16, f64>(model, equivalent),
                        _ => cs_factor::<32, f64>(model, equivalent),
                    };
                    vec![F::from_f64(exact)]
                });
                // 10.29 ε of the form to the first order, 4 ε of K n/T, ½ of the reference's own rounding
                vec![call(format!("{stem}_factor_exact_{id}"), edge, Near::Relative(15.0), kernel)]
            }
            None => vec![],
        },
    }
}

/// Jacobians: round, stretched, mirrored, nearly and quite degenerate, large and small.
pub fn jacobians() -> Vec<[f64; 4]> {
    let mut draw = Draw(17);
    let mut all = vec![
        [3.0, 0.0, 0.0, 2.0],
        [3.0, 1.0, 0.0, 2.0],
        [0.0, 2.0, -3.0, 0.5],
        [1e4, 1.0001e4, 0.0, 1.0],
        [1.0, 1.0, 1.0, 1.0 + 1e-6],
        [1e6, -2e6, 3e5, 1e6],
        [1e-3, 2e-4, -5e-4, 1e-3],
        [0.0, 0.0, 0.0, 0.0],
        [2.0, 4.0, 1.0, 2.0],
        [0.0, 3.0, 0.0, 1.0],
        [5.0, 0.0, 0.0, 0.0],
    ];
    all.extend((0..60).map(|_| [(); 4].map(|()| draw.real(-8.0, 8.0))));
    all
}

fn footprint<F: Number>() -> Vec<Call<F>> {
    fn of<F: Number>(j: &[F], padding: Padding) -> Vec<F> {
        let f = Footprint::of(Jacobian { ux: j[0], vx: j[1], uy: j[2], vy: j[3] }, padding);
        vec![f.uu, f.uv, f.vv, f.determinant]
    }
    let all: Vec<Vec<F>> = jacobians().iter().map(|j| j.map(F::from_f64).to_vec()).collect();
    let makes = |name: &str, padding| Call {
        name: name.to_owned(),
        shape: Shape::Makes(4, "Footprint", FOOTPRINT),
        arguments: all.clone(),
        kernel: Box::new(move |x| of(x, padding)),
        near: Near::Same,
    };
    let mut draw = Draw(19);
    let mut arguments = Vec::new();
    for padding in [Padding::Plain, Padding::Padded] {
        for j in &all {
            for _ in 0..10 {
                let mut row = of(j, padding);
                row.extend([(); 2].map(|()| F::from_f64(draw.real(-10.0, 10.0))));
                arguments.push(row);
            }
        }
    }
    let q = Call {
        name: "footprint_q".to_owned(),
        shape: Shape::Takes("Footprint", FOOTPRINT, 2),
        arguments,
        kernel: Box::new(|x: &[F]| {
            let q = Footprint { uu: x[0], uv: x[1], vv: x[2], determinant: x[3] }.q(x[4], x[5]);
            // The kernels' infinity is the shaders' 1e9.
            vec![if q == F::INFINITY { F::from_f64(1e9) } else { q }]
        }),
        near: Near::Same,
    };
    vec![makes("footprint_plain", Padding::Plain), makes("footprint_padded", Padding::Padded), q]
}

fn weight<F: Number>(weight: PixelWeight<f64>) -> Call<F> {
    let paper = |reading| match reading {
        PaperReading::R1 => "paper_r1",
        PaperReading::R2 => "paper_r2",
        PaperReading::R3 => "paper_r3",
        PaperReading::R4 => "paper_r4",
    };
    // Against double precision: ε/2 in the factor of Q, in the product and in the difference, each times
    // sup t |f'| < 1, the cubic's three more products and differences, and ε/2 a squaring times the power: K ε
    // of values below 1 by K (1 - f) f^..., together less than K + 8.
    let (name, near) = match weight {
        PixelWeight::Gaussian(_) => ("gaussian_weight".to_owned(), Near::Elementary(4.0)),
        PixelWeight::Box => ("box_weight".to_owned(), Near::Same),
        PixelWeight::Paper(reading) => (format!("{}_weight", paper(reading)), Near::Absolute(16.0)),
        PixelWeight::PaperProduct(reading) => {
            (format!("{}_weight_product", paper(reading)), Near::Absolute(16.0))
        }
        PixelWeight::Bell(k, _) => (format!("bell_{k}_weight"), Near::Absolute(f64::from(k) + 8.0)),
        PixelWeight::Cubic(k, _) => (format!("cubic_{k}_weight"), Near::Absolute(f64::from(k) + 8.0)),
    };
    let mut draw = Draw(23);
    let mut qs: Vec<f64> = unit::<F>(29).into_iter().map(F::to_f64).collect();
    qs.extend((0..100).map(|_| draw.real(0.0, 3.0)));
    qs.extend([1.0, 2.0, 8.0, 9.0, 16.0, 1e3, 1e9]);
    let is_product = !weight.is_radial();
    let arguments = qs.iter().map(|q| {
        let other = if is_product { vec![draw.real(0.0, 2.0)] } else { vec![] };
        [vec![*q], other].concat().into_iter().map(F::from_f64).collect()
    });
    Call {
        name,
        shape: Shape::Numbers(if is_product { 2 } else { 1 }),
        arguments: arguments.collect(),
        kernel: Box::new(move |x| {
            let bb = if is_product { x[1].to_f64() } else { 0.0 };
            vec![F::from_f64(weight.at(x[0].to_f64(), bb))]
        }),
        near,
    }
}
