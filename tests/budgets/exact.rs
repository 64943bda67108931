//! References: the formulas that the kernels' pages define them by, evaluated in double-double arithmetic (about 100
//! bits) at the very arguments that the kernel was given.

use bellfit::integral::Field;
use bellfit::kernel::cubic::BellFormula;
use bellfit::kernel::real::Real;
use bellfit::stability::{Angle, DoubleDouble};
use dashu_ratio::RBig;

pub type Exact = DoubleDouble;

/// A number of either type at its word.
pub fn x<F: Real>(value: F) -> Exact {
    Exact::from(value.to_f64())
}

pub fn number(value: f64) -> Exact {
    Exact::from(value)
}

pub fn vector<F: Real>(v: [F; 3]) -> [Exact; 3] {
    v.map(x)
}

/// A rational, rounded to two doubles.
pub fn of_rational(value: &RBig) -> Exact {
    let hi = value.to_f64().value();
    let rest = value.clone() - bellfit::bound::exact(hi).expect("a finite number");
    number(hi) + number(if rest == RBig::int(0) { 0.0 } else { rest.to_f64().value() })
}

/// xᵏ by repeated products.
pub fn power(base: Exact, k: u32) -> Exact {
    (0..k).fold(number(1.0), |product, _| product * base)
}

/// ln x for x > 0.
pub fn ln(value: Exact) -> Exact {
    (number(1.0) - value).log_one_minus()
}

/// baseⁿ for base > 0.
pub fn real_power(base: Exact, n: Exact) -> Exact {
    (n * ln(base)).exp()
}

/// (sin, cos) of an angle in [-π, π]: of half of it, doubled; what the double leaves to first order.
pub fn turn(angle: Exact) -> (Exact, Exact) {
    let (hi, lo) = angle.parts();
    let half = Angle::of(0.5 * hi.abs());
    let (s, c) = (half.sine(), half.cosine());
    let (two, one) = (number(2.0), number(1.0));
    let (sin, cos) = (two * s * c, one - two * s * s);
    let sin = if hi < 0.0 { -sin } else { sin };
    (sin + number(lo) * cos, cos - number(lo) * sin)
}

/// The angle of (x, y) from the x axis, in [-π, π]: the double's, and a step by the sine of what is left.
pub fn arctan2(y: Exact, x: Exact) -> Exact {
    let start = number(libm::atan2(y.to_f64(), x.to_f64()));
    let (sin, cos) = turn(start);
    start + (y * cos - x * sin) / (x * cos + y * sin)
}

pub fn hypot(a: Exact, b: Exact) -> Exact {
    (a * a + b * b).sqrt()
}

pub fn dot(a: [Exact; 3], b: [Exact; 3]) -> Exact {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

pub fn scale(s: Exact, v: [Exact; 3]) -> [Exact; 3] {
    v.map(|component| s * component)
}

pub fn add(a: [Exact; 3], b: [Exact; 3]) -> [Exact; 3] {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}

pub fn sub(a: [Exact; 3], b: [Exact; 3]) -> [Exact; 3] {
    add(a, b.map(|component| -component))
}

pub fn length(v: [Exact; 3]) -> Exact {
    dot(v, v).sqrt()
}

/// 2 (l·n) n - l.
pub fn reflect(l: [Exact; 3], n: [Exact; 3]) -> [Exact; 3] {
    sub(scale(number(2.0) * dot(l, n), n), l)
}

/// Frisvad's basis in Duff's form, of a as it is.
pub fn basis([ax, ay, az]: [Exact; 3]) -> [[Exact; 3]; 2] {
    let one = number(1.0);
    let s = if az.to_f64() < 0.0 { -one } else { one };
    let q = -one / (s + az);
    [[one + s * q * ax * ax, s * q * ax * ay, -(s * ax)], [q * ax * ay, s + q * ay * ay, -ay]]
}

/// (1 - w) axis + √(w (2 - w)) (cos 2πu t + sin 2πu s), |u| ≤ ½.
pub fn direction(axis: [Exact; 3], w: Exact, u: Exact) -> [Exact; 3] {
    let (sin, cos) = turn(number(2.0) * Exact::pi() * u);
    let sine = (w * (number(2.0) - w)).sqrt();
    let [tangent, side] = basis(axis);
    let across = add(scale(sine * cos, tangent), scale(sine * sin, side));
    add(scale(number(1.0) - w, axis), across)
}

/// max(1 - t/K, 0)^K, and its slope's size.
pub fn lyon(k: u32, t: Exact) -> (Exact, f64) {
    let base = number(1.0) - t / number(f64::from(k));
    if base.to_f64() <= 0.0 {
        return (number(0.0), 0.0);
    }
    (power(base, k), power(base, k - 1).to_f64())
}

/// (T, α, β) of a bell's formula, each c₀ + c₁/n + c₂/n².
pub fn at_exponent(formula: &BellFormula, n: Exact) -> [Exact; 3] {
    [formula.reach, formula.linear, formula.square]
        .map(|[a, b, c]| number(a) + (number(b) + number(c) / n) / n)
}

/// max((1 - y)(1 + α y + β y²), 0)^K, y = n w/T.
pub fn fitted(formula: &BellFormula, n: Exact, w: Exact) -> Exact {
    let ([reach, linear, square], one) = (at_exponent(formula, n), number(1.0));
    let y = n * w / reach;
    let base = (one - y) * (one + y * (linear + y * square));
    if base.to_f64() > 0.0 { power(base, formula.power) } else { number(0.0) }
}
