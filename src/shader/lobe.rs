//! Lobes: the constants of an exponent, and the lobe from cos θ or the versine.

use super::ShaderError;
use super::function::{Function, Item, Record, Statement, Type, squarings};
use super::language::Target;
use super::proof::lobe_error;
use crate::bound::Format;
use crate::kernel::constants::{CUBIC_COS_N, LINEAR_COS_N};
use crate::kernel::cubic::{BellFormula, CubicLobe};
use crate::kernel::stand_in::{Argument, StandIn};

/// The bell of a stand-in with its T, α and β; cs_16 has T = 16.
pub(super) fn formula(stand_in: StandIn) -> Option<BellFormula> {
    let (power, degree) = stand_in.bell()?;
    if stand_in == StandIn::Cs16 {
        return Some(BellFormula { power, reach: [16.0, 0.0, 0.0], linear: [0.0; 3], square: [0.0; 3] });
    }
    let table: &[BellFormula] = if degree == 1 { &LINEAR_COS_N } else { &CUBIC_COS_N };
    table.iter().find(|row| row.power == power).copied()
}

/// cs_16, linear_4, cubic_8: what a bell's functions begin with.
pub(super) fn stem(stand_in: StandIn) -> String {
    stand_in.id().replace('-', "_")
}

pub(super) fn items(
    stand_in: StandIn,
    argument: Argument,
    sentence: Option<&str>,
    target: Target,
) -> Result<Vec<Item>, ShaderError> {
    let error = match sentence {
        Some(sentence) => format!("Error: {sentence}"),
        None => format!("Error: {}", lobe_error(stand_in)?),
    };
    Ok(match formula(stand_in) {
        Some(bell) => {
            Bell { stand_in, bell, argument, target, with_rounding: sentence.is_some() }.items(error)
        }
        None => vec![closed(stand_in, argument, error, target)],
    })
}

const NAN: &str = "NaN: unspecified.";

fn takes(argument: Argument) -> (&'static str, &'static str, &'static str) {
    match argument {
        Argument::Cosine => ("cos_theta", "", "cos θ in [0, 1]; below 0 it is 0."),
        Argument::Versine => ("versine", "_versine", "the versine 1 - cos θ in [0, 1]; above 1 it is 0."),
    }
}

/// Schlick's lobe, the spherical Gaussian, and the ways to cosⁿ.
fn closed(stand_in: StandIn, argument: Argument, error: String, target: Target) -> Item {
    let (name, suffix, domain) = takes(argument);
    let is_cosine = argument == Argument::Cosine;
    let ret = |value: &str| Statement::Return(value.to_owned());
    let zero_unless = |condition: &str| Statement::If(condition.to_owned(), vec![ret("0.0")]);
    // 1 - w, where the lobe is one of the cosine.
    let mut body = if is_cosine || stand_in == StandIn::SphericalGaussian {
        vec![]
    } else {
        vec![Statement::Let("cos_theta", "1.0 - versine".to_owned())]
    };
    let schlick = "the lobe of C. Schlick, \"A fast alternative to Phong's specular model\", 1994";
    let (stem, meaning, source, n) = match stand_in {
        StandIn::Schlick => {
            let versine = if is_cosine { "(1.0 - cos_theta)" } else { "versine" };
            body.push(zero_unless("cos_theta <= 0.0"));
            body.push(Statement::Return(format!("cos_theta / (cos_theta + n * {versine})")));
            let meaning = "Schlick's lobe c/(c + n (1 - c)), c = cos θ.";
            (
                "schlick_lobe",
                meaning,
                format!("{schlick}; the denominator in the form that keeps its digits."),
                "n >= 0",
            )
        }
        StandIn::SchlickPrinted => {
            body.push(zero_unless("cos_theta <= 0.0"));
            body.push(ret("cos_theta / (n - n * cos_theta + cos_theta)"));
            let meaning = "Schlick's lobe c/(n - n c + c), c = cos θ, with the denominator as printed, which cancels \
                           near c = 1.";
            ("schlick_printed_lobe", meaning, format!("{schlick}."), "n >= 0")
        }
        StandIn::SphericalGaussian => {
            body.push(ret(if is_cosine { "exp(-(n * (1.0 - cos_theta)))" } else { "exp(-(n * versine))" }));
            let source =
                "Wang et al., \"All-frequency rendering of dynamic, spatially-varying reflectance\", 2009.";
            ("spherical_gaussian", "Spherical Gaussian e^(n (cos θ - 1)).", source.to_owned(), "n >= 0")
        }
        StandIn::Squarings => {
            let assign = |to: &'static str, value: &str| Statement::Assign(to, value.to_owned());
            let start = if is_cosine { "max(cos_theta, 0.0)" } else { "max(1.0 - versine, 0.0)" };
            body = vec![
                Statement::Let("base", start.to_owned()),
                Statement::If("n == 0u".to_owned(), vec![ret("1.0")]),
                Statement::Var("mask", Type::Count, "1u".to_owned()),
                Statement::While("mask <= (n >> 1u)".to_owned(), vec![assign("mask <<=", "1u")]),
                Statement::Var("power", Type::Real, "base".to_owned()),
                Statement::While(
                    "mask > 1u".to_owned(),
                    vec![
                        assign("mask >>=", "1u"),
                        assign("power *=", "power"),
                        Statement::If("(n & mask) != 0u".to_owned(), vec![assign("power *=", "base")]),
                    ],
                ),
                ret("power"),
            ];
            let source = "square and multiply, from the highest bit of n down.";
            ("cos_n_squarings", "cosⁿ θ for whole n by squarings.", source.to_owned(), "whole n >= 0")
        }
        StandIn::Exp2Log2 => {
            body.push(zero_unless("cos_theta <= 0.0"));
            body.push(ret("exp2(n * log2(cos_theta))"));
            ("cos_n_base_two", "cosⁿ θ as 2^(n log2 cos θ).", "the definition.".to_owned(), "n > 0")
        }
        _ if is_cosine || target.language.is_shading() => {
            body.push(zero_unless("cos_theta <= 0.0"));
            body.push(ret("pow(cos_theta, n)"));
            ("cos_n_pow", "cosⁿ θ.", "the definition.".to_owned(), "n > 0")
        }
        _ => {
            body = vec![zero_unless("versine >= 1.0"), ret("exp(n * log1p(-versine))")];
            ("cos_n_pow", "cosⁿ θ as e^(n ln(1 - w)), w the versine.", "the definition.".to_owned(), "n > 0")
        }
    };
    let domain = if stand_in == StandIn::SphericalGaussian {
        if is_cosine { "cos θ in [-1, 1]." } else { "the versine 1 - cos θ in [0, 2]." }
    } else {
        domain
    };
    let mut about = vec![meaning.to_owned(), format!("Domain: {n}, {domain} {NAN}"), error];
    if !is_cosine
        && matches!(body.first(), Some(Statement::Let("cos_theta", _)) if stand_in != StandIn::Schlick)
    {
        about.push(
            "The cosine is taken as 1 - w: what of w is below the cosine's last digit is lost.".to_owned(),
        );
    }
    about.push(format!("Source: {source}"));
    let count = if stand_in == StandIn::Squarings { Type::Count } else { Type::Real };
    Item::Function(Function {
        name: format!("{stem}{suffix}"),
        about,
        parameters: vec![(name, Type::Real), ("n", count)],
        result: Type::Real,
        arithmetic: Type::Real,
        body,
    })
}

struct Bell {
    stand_in: StandIn,
    bell: BellFormula,
    argument: Argument,
    target: Target,
    /// Whether the sentence about the error counts rounding in.
    with_rounding: bool,
}

impl Bell {
    fn is_linear(&self) -> bool {
        self.stand_in.bell().is_some_and(|(_, degree)| degree == 1)
    }

    /// Whether the cubic is evaluated around cos θ, in its depressed form.
    fn is_depressed(&self) -> bool {
        !self.is_linear() && self.argument == Argument::Cosine && self.bell.power <= 4
    }

    fn source(&self) -> String {
        match self.stand_in {
            StandIn::Cs16 => {
                "Source: the lobe paper, (1), with its exact cut; the bell is that of R. F. Lyon, Apple \
                              Technical Report 43, 1993."
                    .to_owned()
            }
            _ if self.is_linear() => {
                "Source: bellfit's fit of T in the bell of R. F. Lyon, Apple Technical Report 43, 1993."
                    .to_owned()
            }
            _ => "Source: bellfit's fit.".to_owned(),
        }
    }

    fn items(&self, error: String) -> Vec<Item> {
        let stem = stem(self.stand_in);
        let title: String = self.stand_in.id().split('-').map(capitalised).collect();
        let versine = self.argument == Argument::Versine;
        let (name, suffix, domain) = takes(self.argument);
        let field = |name, meaning: &str| (name, meaning.to_owned());
        let fields = match (self.is_linear(), self.is_depressed()) {
            (true, _) if versine => vec![],
            (true, _) => vec![field("offset", "1 - s"), field("slope", "s = n/T")],
            (_, true) => {
                vec![field("offset", "a"), field("slope", "b"), field("tilt", "c"), field("level", "d")]
            }
            _ => vec![field("first", "k, of w"), field("second", "k', of w²"), field("third", "k'', of w³")],
        };
        let power = self.bell.power;
        let (base, base_meaning) = match (self.is_linear(), self.is_depressed()) {
            (true, _) if versine => ("1.0 - slope * versine", "p = 1 - s w, w = 1 - cos θ, s = n/T"),
            (true, _) => ("constants.offset + constants.slope * cos_theta", "p = (1 - s) + s cos θ, s = n/T"),
            (_, true) => {
                ("(u * u + constants.tilt) * u + constants.level", "p = u³ + c u + d, u = a + b cos θ")
            }
            _ => (
                "1.0 - w * (constants.first - w * (constants.second - w * constants.third))",
                "p = 1 - w (k - w (k' - w k'')), w = 1 - cos θ",
            ),
        };
        let record_name = format!("{title}{}Constants", if versine { "Versine" } else { "" });
        let result = if fields.is_empty() { Type::Wide } else { Type::Record(record_name.clone()) };
        let constants_name =
            if fields.is_empty() { format!("{stem}_slope") } else { format!("{stem}{suffix}_constants") };
        let mut items = Vec::new();
        if !fields.is_empty() {
            items.push(Item::Record(Record {
                name: record_name,
                about: vec![format!("What {stem}_lobe{suffix} needs of n: {base_meaning}.")],
                fields,
            }));
        }
        items.push(Item::Function(Function {
            name: constants_name.clone(),
            about: vec![
                format!("The constants of {stem}_lobe{suffix} for the exponent n: once a material. {base_meaning}."),
                self.constants_domain(),
                "Error: rounding alone.".to_owned(),
                self.source(),
            ],
            parameters: vec![("n", Type::Wide)],
            result,
            arithmetic: Type::Wide,
            body: self.constants_body(),
        }));
        let argument_note = (!versine && !self.with_rounding).then(|| self.cosine_note());
        let guard = if versine { "versine > 1.0" } else { "cos_theta < 0.0" };
        let mut body = vec![Statement::If(guard.to_owned(), vec![Statement::Return("0.0".to_owned())])];
        if self.is_depressed() {
            body.push(Statement::Let("u", "constants.offset + constants.slope * cos_theta".to_owned()));
        } else if !self.is_linear() {
            let w = if versine { "versine" } else { "1.0 - cos_theta" };
            body.push(Statement::Let("w", w.to_owned()));
        }
        body.push(Statement::Let("p", format!("max({base}, 0.0)")));
        body.extend(squarings(power));
        let first = if self.is_linear() && versine {
            ("slope", Type::Real)
        } else {
            let record = format!("{title}{}Constants", if versine { "Versine" } else { "" });
            ("constants", Type::Record(record))
        };
        let mut about = vec![
            format!("The lobe {} for cosⁿ θ: max(p, 0)^{power}, {base_meaning}.", self.stand_in.id()),
            format!("Domain: constants from {constants_name}, {domain} {NAN}"),
            error,
        ];
        about.extend(argument_note);
        about.push(self.source());
        items.push(Item::Function(Function {
            name: format!("{stem}_lobe{suffix}"),
            about,
            parameters: vec![first, (name, Type::Real)],
            result: Type::Real,
            arithmetic: Type::Real,
            body,
        }));
        items
    }

    /// s or the cubic's constants, step by step as the kernels compute them.
    fn constants_body(&self) -> Vec<Statement> {
        let digits = self.target.wide_digits();
        let set = |name, value: &str| Statement::Let(name, value.to_owned());
        let series = |name, row| Statement::Let(name, digits.series(row, "m"));
        let varies = [self.bell.reach, self.bell.linear, self.bell.square]
            .iter()
            .any(|[_, b, c]| *b != 0.0 || *c != 0.0);
        let mut body = if varies { vec![set("m", "1.0 / n")] } else { vec![] };
        if self.is_linear() {
            let slope = if varies {
                body.push(series("reach", self.bell.reach));
                "n / reach".to_owned()
            } else {
                format!("n / {}", digits.of(self.bell.reach[0]))
            };
            if self.argument == Argument::Versine {
                body.push(Statement::Return(slope));
                return body;
            }
            body.push(Statement::Let("slope", slope));
            let fields = vec![("offset", "1.0 - slope".to_owned()), ("slope", "slope".to_owned())];
            body.push(Statement::ReturnRecord(self.record_name(), fields));
            return body;
        }
        body.push(series("reach", self.bell.reach));
        body.push(series("alpha", self.bell.linear));
        body.push(series("beta", self.bell.square));
        body.push(set("scale", "n / reach"));
        body.push(set("first", "(1.0 - alpha) * scale"));
        body.push(set("second", "(beta - alpha) * scale * scale"));
        body.push(set("third", "beta * scale * scale * scale"));
        let fields: Vec<(&'static str, String)> = if self.is_depressed() {
            if self.target.language.is_shading() {
                // 2^(log₂(x)/3) and a step of Newton's method: no shading language has a cube root.
                body.push(set("rough", "exp2(log2(third) / 3.0)"));
                body.push(set("excess", "rough * rough * rough - third"));
                body.push(set("slope", "rough - excess / (3.0 * rough * rough)"));
            } else {
                body.push(set("slope", "cbrt(third)"));
            }
            body.push(set("shift", "second / (3.0 * slope * slope)"));
            body.push(set("tilt", "first / slope - 3.0 * shift * shift"));
            let level = "1.0 - shift * (shift * shift + tilt)";
            [("offset", "shift - slope"), ("slope", "slope"), ("tilt", "tilt"), ("level", level)]
                .map(|(field, value)| (field, value.to_owned()))
                .to_vec()
        } else {
            ["first", "second", "third"].map(|field| (field, field.to_owned())).to_vec()
        };
        body.push(Statement::ReturnRecord(self.record_name(), fields));
        body
    }

    fn record_name(&self) -> String {
        let title: String = self.stand_in.id().split('-').map(capitalised).collect();
        let versine = if self.argument == Argument::Versine { "Versine" } else { "" };
        format!("{title}{versine}Constants")
    }

    fn constants_domain(&self) -> String {
        let from = if self.stand_in == StandIn::Cs16 { "real n >= 0" } else { "real n >= 16" };
        let mut text = format!("Domain: {from}");
        if !self.is_linear() {
            text.push_str(", n^3 within the type");
        }
        if self.target.format == Format::Half && !self.is_linear() && !self.is_depressed() {
            text.push_str(&format!(": f16 holds the constants up to n = {}", most_in_half(self.bell.power)));
        }
        text.push_str(". T");
        if !self.is_linear() {
            text.push_str(", alpha and beta");
        }
        text.push_str(if self.bell.reach[1] == 0.0 && self.is_linear() {
            " is the same for every n."
        } else if self.is_linear() {
            " is a polynomial in m = 1/n."
        } else {
            " are polynomials in m = 1/n; p = (1 - y)(1 + alpha y + beta y^2), y = n (1 - cos θ)/T."
        });
        text
    }

    fn cosine_note(&self) -> String {
        let epsilon = match self.target.format {
            Format::Half => "2^-10",
            Format::Double => "2^-52",
            _ => "2^-23",
        };
        // CubicLobe::at and LinearLobe::at state both.
        let own = if self.is_depressed() { "0.7 n ε (sampled)" } else { "as much" };
        format!(
            "Rounding comes on top: a rounded cos θ alone moves the lobe by up to n ε/4, ε = {epsilon}, and the \
             sums of its polynomial by up to {own} more. At a large n take {}_lobe_versine.",
            stem(self.stand_in)
        )
    }
}

/// The largest whole n whose third constant binary16 holds.
fn most_in_half(power: u32) -> u32 {
    let third = |n: u32| match power {
        2 => CubicLobe::<2, f64>::new(f64::from(n)).horner()[2],
        4 => CubicLobe::<4, f64>::new(f64::from(n)).horner()[2],
        _ => CubicLobe::<8, f64>::new(f64::from(n)).horner()[2],
    };
    (16..=65504).rev().find(|&n| third(n) <= 65504.0).unwrap_or(16)
}

fn capitalised(word: &str) -> String {
    let mut letters = word.chars();
    letters.next().map_or_else(String::new, |first| first.to_ascii_uppercase().to_string() + letters.as_str())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn constants_beyond_half_are_named() {
        for (power, n) in [(2, most_in_half(2)), (4, most_in_half(4)), (8, most_in_half(8))] {
            assert!((100..2000).contains(&n), "K = {power}: {n}");
        }
    }
}
