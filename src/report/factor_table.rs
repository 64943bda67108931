//! `fits/factors.csv`: the factors of other forms and ranges.

use super::artifacts::ArtifactError;
use super::tables::csv_bytes;
use crate::fit::{FactorRow, Objective};
use serde::Serialize;

#[derive(Serialize)]
struct FactorLine<'a> {
    model: &'static str,
    lobe: &'a str,
    form: &'static str,
    objective: &'static str,
    n_lo: String,
    n_hi: String,
    p0: &'a str,
    p1: &'a str,
    p2: &'a str,
    p3: &'a str,
    max_residual: f64,
    n_at_max: f64,
    min_residual: f64,
    n_at_min: f64,
    over: &'static str,
    evidence: &'static str,
    divisor: u32,
    digits: usize,
    optimum: f64,
    excess: f64,
    fitted_over: &'static str,
}

impl<'a> From<&'a FactorRow> for FactorLine<'a> {
    /// Each extreme is printed by its outer end, so that the residual provably lies between them.
    fn from(row: &'a FactorRow) -> Self {
        let parameter = |k: usize| row.factor.parameters().get(k).map_or("", String::as_str);
        FactorLine {
            model: row.model.id(),
            lobe: &row.lobe,
            form: row.form().formula(),
            objective: row.objective.id(),
            n_lo: row.range.from().to_string(),
            n_hi: row.range.to().to_string(),
            p0: parameter(0),
            p1: parameter(1),
            p2: parameter(2),
            p3: parameter(3),
            max_residual: row.extremes.max.value.hi(),
            n_at_max: row.extremes.max.n,
            min_residual: row.extremes.min.value.lo(),
            n_at_min: row.extremes.min.n,
            over: FactorRow::OVER,
            evidence: "certified",
            divisor: row.factor.divisor(),
            digits: row.digits,
            optimum: row.optimum,
            excess: row.excess,
            fitted_over: match row.objective {
                Objective::LsAbsolute | Objective::LsRelative => "integers",
                _ => "reals",
            },
        }
    }
}

/// A row a factor, parameters that its form does not have empty, an endless range to `inf`.
pub(super) fn factors_csv<'a>(
    rows: impl IntoIterator<Item = &'a FactorRow>,
) -> Result<Vec<u8>, ArtifactError> {
    csv_bytes(rows.into_iter().map(FactorLine::from))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fit::{FactorForm, fit_factor};
    use crate::integral::{Case, Limit, Lobe};
    use crate::kernel::model::Model;

    #[test]
    fn columns_keep_their_order_and_missing_parameters_are_empty() {
        let case = Case { model: Model::BlinnPhong, lobe: Lobe::Cs16, limit: Limit::Support };
        let row = |range: &str, form, objective, digits| {
            fit_factor(&case, range.parse().unwrap(), form, objective, digits).unwrap()
        };
        let rows = [
            row("16..inf", FactorForm::Inverse, Objective::Minimax, 12),
            row("16..1024", FactorForm::Linear, Objective::OneSidedRounded, 4),
        ];
        let text = String::from_utf8(factors_csv(&rows).unwrap()).unwrap();
        let lines: Vec<&str> = text.lines().collect();
        let header = "model,lobe,form,objective,n_lo,n_hi,p0,p1,p2,p3,max_residual,n_at_max,min_residual,\
                      n_at_min,over,evidence,divisor,digits,optimum,excess,fitted_over";
        assert_eq!((lines[0], lines.len()), (header, 3));
        let fields = |line: usize| lines[line].split(',').collect::<Vec<_>>();
        assert_eq!(&fields(1)[..6], ["blinn-phong", "cs16", "p0 n + p1 + p2/n", "minimax", "16", "inf"]);
        assert!(!fields(1)[8].is_empty() && fields(1)[9].is_empty());
        assert_eq!(
            &fields(2)[2..10],
            ["p0 n + p1", "one-sided-rounded", "16", "1024", "1.06", "1.041", "", ""]
        );
        // Nothing is gained: the outer end of the largest residual is not positive.
        assert!(fields(2)[10].parse::<f64>().unwrap() <= 0.0);
        assert_eq!(&fields(2)[14..18], ["reals", "certified", "8", "4"]);
    }
}
