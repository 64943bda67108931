//! From a Jacobian to Q.

use super::function::{Function, Item, Record, Statement, Type};
use super::language::Target;
use super::{Language, ShaderError};
use crate::bound::Format;

/// Q where the footprint is degenerate: far outside, and its powers are still finite.
const FAR: &str = "1e9";

const SOURCE: &str = "Source: the pixel paper, (1) and (2), as M = J J^T; P. S. Heckbert, \"Fundamentals of Texture \
                      Mapping and Image Warping\", 1989.";

pub(super) fn items(target: Target) -> Result<Vec<Item>, ShaderError> {
    if target.format == Format::Half {
        return Err(ShaderError::Range);
    }
    let record = Record {
        name: "Footprint".to_owned(),
        about: vec![
            "Ellipse x^T M^-1 x <= 1 of texels under a pixel: its symmetric matrix M and det M.".to_owned(),
            SOURCE.to_owned(),
        ],
        fields: [
            ("uu", "M's entry of u with u: the square of the half width"),
            ("uv", "of u with v"),
            ("vv", "of v with v: the square of the half height"),
            ("det_m", "det M"),
        ]
        .map(|(field, meaning)| (field, meaning.to_owned()))
        .to_vec(),
    };
    let mut items = vec![Item::Record(record)];
    items.extend([false, true].map(|padded| matrix(padded, target)));
    items.push(q(target));
    Ok(items)
}

fn limits(target: Target) -> (&'static str, &'static str) {
    if target.format == Format::Double { ("2^255", "2^-511") } else { ("2^31", "2^-63") }
}

fn real(names: &[&'static str]) -> Vec<(&'static str, Type)> {
    names.iter().map(|name| (*name, Type::Real)).collect()
}

/// det J = ux vy - uy vx, as accurate as the language allows, and what is known of that.
fn determinant(target: Target) -> (Vec<Statement>, &'static str) {
    let set = |name, value: &str| Statement::Let(name, value.to_owned());
    let kahan = "det J with a relative error of at most 2 u, u = 2^-53 (C.-P. Jeannerod, N. Louvet, J.-M. Muller, \
                 Math. Comp. 82, 2013), barring underflow.";
    let exact = "det J with one rounding, as its products are exact in double precision.";
    match (target.language, target.format) {
        (Language::C, Format::Single) => {
            (vec![set("det_j", "(float)((double)ux * (double)vy - (double)uy * (double)vx)")], exact)
        }
        (Language::Rust, Format::Single) => (
            vec![set("det_j", "(f64::from(ux) * f64::from(vy) - f64::from(uy) * f64::from(vx)) as f32")],
            exact,
        ),
        (Language::C, _) => (
            vec![
                set("product", "uy * vx"),
                set("lost", "fma(-uy, vx, product)"),
                set("det_j", "fma(ux, vy, -product) + lost"),
            ],
            kahan,
        ),
        (Language::Rust, _) => (
            vec![
                set("product", "uy * vx"),
                set("lost", "f64::mul_add(-uy, vx, product)"),
                set("det_j", "f64::mul_add(ux, vy, -product) + lost"),
            ],
            kahan,
        ),
        _ => (
            vec![set("det_j", "ux * vy - uy * vx")],
            "det J with a relative error of at most 2 u times the ellipse's aspect to the first order, u half the \
             type's epsilon: that of its products.",
        ),
    }
}

fn matrix(padded: bool, target: Target) -> Item {
    let set = |name, value: &str| Statement::Let(name, value.to_owned());
    let (most, least) = limits(target);
    let (determinant, error) = determinant(target);
    let (name, meaning, domain, fields) = if padded {
        (
            "footprint_padded",
            "Footprint of a pixel with a texel's own size added: M = J J^T + I, so that no semi-axis is shorter than \
             one texel.",
            format!("Domain: components up to {most}; none is degenerate."),
            [
                ("uu", "uu + 1.0"),
                ("uv", "uv"),
                ("vv", "vv + 1.0"),
                ("det_m", "det_j * det_j + uu + vv + 1.0"),
            ],
        )
    } else {
        (
            "footprint_plain",
            "Footprint of a pixel: M = J J^T, the image of the circle of radius one pixel.",
            format!(
                "Domain: components up to {most}; |det J|, the lengths of J's rows and |det J| by either at least \
                 {least}. Below that the footprint is degenerate and holds no texel: Q = {FAR} everywhere."
            ),
            [("uu", "uu"), ("uv", "uv"), ("vv", "vv"), ("det_m", "det_j * det_j")],
        )
    };
    let fields = fields.map(|(field, value)| (field, value.to_owned())).to_vec();
    let mut body =
        vec![set("uu", "ux * ux + uy * uy"), set("uv", "ux * vx + uy * vy"), set("vv", "vx * vx + vy * vy")];
    body.extend(determinant);
    body.push(Statement::ReturnRecord("Footprint".to_owned(), fields));
    Item::Function(Function {
        name: name.to_owned(),
        about: vec![
            format!(
                "{meaning} J's columns: (ux, vx) = d(u, v)/dx and (uy, vy) = d(u, v)/dy, in texels per pixel."
            ),
            domain,
            format!("Error: {error} For the whole see footprint_q."),
            SOURCE.to_owned(),
        ],
        parameters: real(&["ux", "vx", "uy", "vy"]),
        result: Type::Record("Footprint".to_owned()),
        arithmetic: Type::Real,
        body,
    })
}

fn q(target: Target) -> Item {
    let set = |name, value: &str| Statement::Let(name, value.to_owned());
    let (smallest, least) = if target.format == Format::Double {
        (f64::MIN_POSITIVE, "2^-1022")
    } else {
        (f64::from(f32::MIN_POSITIVE), "2^-126")
    };
    let smallest = target.digits().of(smallest);
    let roundoff = if target.format == Format::Double { "2^-53" } else { "2^-24" };
    Item::Function(Function {
        name: "footprint_q".to_owned(),
        about: vec![
            "Q of a texel at (u, v) from the footprint's middle, in texels: 0 there, 1 on the ellipse, more outside. \
             A sum of two squares, v^2/vv + (vv/det M) (u - v uv/vv)^2."
                .to_owned(),
            format!(
                "Domain: a footprint in its domain; degenerate, det M < {least} max(vv, 1): {FAR}, where every weight \
                 but the box is 0."
            ),
            format!(
                "Error: sampled, not proven: for Q <= 1 absolute at most 16 u times the ellipse's aspect, u = {roundoff}, \
                 and in a shading language as much again from det J."
            ),
            SOURCE.to_owned(),
        ],
        parameters: vec![
            ("footprint", Type::Record("Footprint".to_owned())),
            ("u", Type::Real),
            ("v", Type::Real),
        ],
        result: Type::Real,
        arithmetic: Type::Real,
        body: vec![
            Statement::If(
                format!("footprint.det_m < {smallest} * max(footprint.vv, 1.0)"),
                vec![Statement::Return(FAR.to_owned())],
            ),
            set("curvature", "footprint.vv / footprint.det_m"),
            set("off", "u - v * (footprint.uv / footprint.vv)"),
            Statement::Return("v * (v / footprint.vv) + curvature * off * off".to_owned()),
        ],
    })
}
