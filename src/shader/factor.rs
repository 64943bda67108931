//! Factors coef(n): a line, a sum in 1/n or the closed form.

use super::ShaderError;
use super::function::{Function, Item, Statement, Type};
use super::language::Target;
use super::lobe::{formula, stem};
use super::proof::{cubic_factor_error, line_error};
use crate::bound::short;
use crate::kernel::constants::{CS16_ONE_SIDED, CUBIC_FACTOR};
use crate::kernel::cubic::BellFormula;
use crate::kernel::model::{Convention, LobeAngle, Model};
use crate::kernel::stand_in::StandIn;
use core::f64::consts::{FRAC_1_SQRT_2, PI};

const TABLE: &str = "the lobe paper, Table 1";

pub(super) fn items(
    model: Model,
    stand_in: StandIn,
    nudge: f64,
    target: Target,
) -> Result<Vec<Item>, ShaderError> {
    let factor = Factor { model, stand_in, nudge, target };
    Ok(match (formula(stand_in), stand_in.bell()) {
        (Some(bell), Some((_, 1))) if stand_in == StandIn::Cs16 => {
            vec![factor.line()?, factor.closed_form(&bell)]
        }
        (Some(bell), Some((_, 1))) => vec![factor.closed_form(&bell)],
        (Some(bell), _) => vec![factor.cubic(&bell)?],
        (None, _) if stand_in.is_exact() => vec![factor.of_cos_n()],
        _ => return Err(ShaderError::NoFactor(stand_in.id())),
    })
}

struct Factor {
    model: Model,
    stand_in: StandIn,
    nudge: f64,
    target: Target,
}

fn set(name: &'static str, value: String) -> Statement {
    Statement::Let(name, value)
}

impl Factor {
    fn function(&self, name: &str, mut about: Vec<String>, mut body: Vec<Statement>) -> Item {
        if let (true, Some(Statement::Return(value))) = (self.nudge > 0.0, body.last_mut()) {
            *value = format!("{value} * {}", self.number(1.0 - self.nudge));
            about.push(format!(
                "Lowered by {}, more than its own rounding, so that it gains nothing with the exact lobe.",
                short(self.nudge)
            ));
        }
        Item::Function(Function {
            name: format!("{name}_{}", self.model.id().replace('-', "_")),
            about,
            parameters: vec![("n", Type::Wide)],
            result: Type::Wide,
            arithmetic: Type::Wide,
            body,
        })
    }

    fn number(&self, value: f64) -> String {
        self.target.wide_digits().of(value)
    }

    /// divisor π: the product rounded as the kernels round it, exactly twice or eight times π's.
    fn divisor(&self, divisor: f64) -> String {
        self.number(divisor * PI)
    }

    fn meaning(&self, lobe: &str) -> String {
        let condition = match (self.model.convention(), self.model.angle()) {
            (Convention::Rdf, LobeAngle::Full) => "the integral of coef(n) lobe(R*V) over directions is 1",
            (Convention::RdfCosine, LobeAngle::Full) => {
                "the integral of coef(n) lobe(R*V) (N*L) over directions is 1"
            }
            (Convention::Rdf, LobeAngle::Half) => {
                "the integral of coef(n) lobe(N*H) over directions is 1, V along the normal"
            }
            (Convention::RdfCosine, LobeAngle::Half) => {
                "the integral of coef(n) lobe(N*H) (N*L) over directions is 1, V along the normal"
            }
            (Convention::Ndf, _) => "the integral of coef(n) lobe(N*H) over normals is 1",
            (Convention::Heightfield, _) => "the integral of coef(n) lobe(N*H) (N*H) over normals is 1",
        };
        format!("{}: factor of the lobe {lobe}, per steradian; {condition}.", self.model.title())
    }

    /// What rounding adds, in ε: with a correctly rounded division, and with the 2.5 ulp that WGSL asks for.
    fn rounding(&self, exact: u32, shading: u32) -> String {
        if self.target.language.is_shading() {
            format!("Rounding: up to {shading} ε more, gains too, with divisions within 2.5 ulp.")
        } else {
            format!("Rounding: up to {exact} ε more, gains too.")
        }
    }

    /// (a n + b)/(divisor π), never gaining.
    fn line(&self) -> Result<Item, ShaderError> {
        let [a, b, divisor] = CS16_ONE_SIDED[self.model as usize];
        let offset = if b == 0.0 { String::new() } else { self.target.wide_digits().added(b) };
        let sum = format!("{} * n{offset}", self.number(a));
        let sum = if b == 0.0 { sum } else { format!("({sum})") };
        let about = vec![
            self.meaning("cs-16"),
            format!(
                "The line (a n + b)/({divisor} π) that, but for rounding, never gains energy and loses least."
            ),
            "Domain: real n of 16..1024; outside, the line goes on and nothing is proved.".to_owned(),
            format!("Error: {} {}", line_error(self.model)?, self.rounding(2, 5)),
            format!("Source: bellfit's fit; the form is that of {TABLE}."),
        ];
        let body = vec![Statement::Return(format!("{sum} / {}", self.divisor(divisor)))];
        Ok(self.function("cs_16_factor_line", about, body))
    }

    /// The closed form for a support inside the hemisphere.
    fn closed_form(&self, bell: &BellFormula) -> Item {
        let k = f64::from(bell.power);
        let digits = self.target.wide_digits();
        let edge = match self.model.angle() {
            LobeAngle::Full => 1.0,
            // 1 - √½ without its cancellation
            LobeAngle::Half => 0.5 / (1.0 + FRAC_1_SQRT_2),
        };
        let lead = (k + 1.0) / (2.0 * PI * k);
        let mut body = Vec::new();
        // The bell of reach T at n is Lyon's at K n/T.
        let n = if self.stand_in == StandIn::Cs16 {
            "n"
        } else {
            if bell.reach[1] != 0.0 {
                body.push(set("m", "1.0 / n".to_owned()));
            }
            body.push(set("reach", digits.series(bell.reach, "m")));
            body.push(set("equivalent", format!("{} * n / reach", self.number(k))));
            "equivalent"
        };
        let ratio = |body: &mut Vec<Statement>| body.push(set("s", format!("{} / {n}", self.number(k))));
        let tilt = format!("(1.0 - s * {})", self.number(1.0 / (k + 2.0)));
        let value = match self.model {
            Model::Phong | Model::BlinnPhongNdf => format!("{n} * {}", self.number(lead)),
            Model::PhongModified | Model::BlinnPhongHeightfield => {
                ratio(&mut body);
                format!("{n} * {} / {tilt}", self.number(lead))
            }
            Model::BlinnPhong => {
                ratio(&mut body);
                format!("{n} * {} / {tilt}", self.number(0.25 * lead))
            }
            Model::BlinnPhongModified => {
                ratio(&mut body);
                let second = 12.0 / ((k + 2.0) * (k + 3.0));
                let bend = format!("{} - s * {}", self.number(second), self.number(second / (k + 4.0)));
                body.push(set("bend", bend));
                let bracket = format!("1.0 - s * ({} - s * bend)", self.number(5.0 / (k + 2.0)));
                format!("{n} * {} / ({bracket})", self.number(0.25 * lead))
            }
        };
        body.push(Statement::Return(value));
        // n ≥ K/E for Lyon's bell; with the reach T that falls with n: T(n)/E.
        let from = (16..4096).find(|&n| {
            let m = 1.0 / f64::from(n);
            let [a, b, c] = bell.reach;
            f64::from(n) >= (a + m * (b + m * c)) / edge
        });
        let from = match (self.stand_in, from) {
            (StandIn::Cs16, _) => format!("real n >= {}", short(libm::ceil(k / edge * 100.0) / 100.0)),
            (_, Some(16) | None) => "real n >= 16".to_owned(),
            (_, Some(n)) => format!("real n >= {n}"),
        };
        // By the kernels' count; 2.5 ulp for ½ in the two divisions, and in that of n/T and what it is made of.
        let (most, of_reach, division) = if self.target.language.is_shading() {
            ("15", 6, ", with divisions within 2.5 ulp")
        } else {
            ("10.29", 4, "")
        };
        let more = if self.stand_in == StandIn::Cs16 {
            String::new()
        } else {
            format!(", and up to {of_reach} ε more for n/T")
        };
        let error = format!(
            "Error: none but rounding, relative at most {most} ε to the first order{division}{more}."
        );
        let about = vec![
            self.meaning(self.stand_in.id()),
            "The exact factor where the lobe ends on the hemisphere, before its edge.".to_owned(),
            format!(
                "Domain: {from}; below, where the hemisphere cuts the lobe, another form is exact and this one is not."
            ),
            error,
            format!("Source: the condition of {TABLE} integrated term by term."),
        ];
        self.function(&format!("{}_factor_exact", stem(self.stand_in)), about, body)
    }

    /// (p₀ n + p₁ + p₂/n + p₃/n²)/(divisor π).
    fn cubic(&self, bell: &BellFormula) -> Result<Item, ShaderError> {
        let row = bell.power.trailing_zeros() as usize - 1;
        let [p0, p1, p2, p3, divisor] = CUBIC_FACTOR[row][self.model as usize];
        let digits = self.target.wide_digits();
        // p₂ + p₃/n, its sign taken into both operators.
        let inverse = format!("({}{} / n) / n", digits.of(p2), digits.added(p3));
        let value =
            format!("({} * n{} + {inverse}) / {}", digits.of(p0), digits.added(p1), self.divisor(divisor));
        let about = vec![
            self.meaning(self.stand_in.id()),
            format!("(p0 n + p1 + p2/n + p3/n^2)/({divisor} π); but for rounding it never gains energy."),
            "Domain: real n >= 16; below, the formula goes on and nothing is proved.".to_owned(),
            format!("Error: {} {}", cubic_factor_error(self.stand_in, self.model)?, self.rounding(4, 10)),
            "Source: bellfit's fit.".to_owned(),
        ];
        Ok(self.function(&format!("{}_factor", stem(self.stand_in)), about, vec![Statement::Return(value)]))
    }

    fn of_cos_n(&self) -> Item {
        let mut body = Vec::new();
        let value = match self.model {
            Model::Phong | Model::BlinnPhongNdf => format!("(n + 1.0) / {}", self.divisor(2.0)),
            Model::PhongModified | Model::BlinnPhongHeightfield => {
                format!("(n + 2.0) / {}", self.divisor(2.0))
            }
            Model::BlinnPhong => {
                body.push(set("q", "exp2(-0.5 * n)".to_owned()));
                format!("(n + 2.0) / ({} * (2.0 - q))", self.divisor(4.0))
            }
            Model::BlinnPhongModified => {
                body.push(set("q", "exp2(-0.5 * n)".to_owned()));
                format!("(n + 2.0) / {} * (1.0 + (4.0 - q) / (q + n))", self.divisor(8.0))
            }
        };
        body.push(Statement::Return(value));
        let about = vec![
            self.meaning("cosⁿ θ"),
            "Domain: real n >= 0.".to_owned(),
            "Error: exact but for rounding.".to_owned(),
            format!("Source: {TABLE}, column cosⁿ θ."),
        ];
        self.function("cos_n_factor", about, body)
    }
}
