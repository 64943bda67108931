//! What another term brings, and what it costs never to gain energy: a panel a model.

use super::sample::{RANGE, empty, n_axis, number, over_n};
use super::{Figure, FigureError};
use crate::bound::Residual;
use crate::fit::{FactorForm, FactorRow, Objective};
use crate::integral::{Case, Limit, Lobe};
use crate::kernel::model::Model;
use crate::report::chart::{Axis, Chart, LineChart, Panels, Scale, Series, Style};

/// The curves: label, style, objective, and the forms of which the last that there is is drawn; where a
/// line does not pay there is only the proportional factor.
const CURVES: [(&str, Style, Objective, &[FactorForm]); 3] = [
    (
        "line p0 n + p1, minimax",
        Style::Line,
        Objective::Minimax,
        &[FactorForm::Proportional, FactorForm::Linear],
    ),
    (
        "line that never gains energy",
        Style::Dashed,
        Objective::OneSided,
        &[FactorForm::Proportional, FactorForm::Linear],
    ),
    ("with another term p2/n, minimax", Style::Line, Objective::Minimax, &[FactorForm::Inverse]),
];

/// The residuals of cs_16's factors on its support over n = 16..1024: the line and the inverse form by
/// minimax, and the line that never gains energy.
///
/// # Errors
///
/// [`FigureError::NoLines`] without any row of these.
pub(super) fn factors(rows: &[FactorRow]) -> Result<Figure, FigureError> {
    let shown = |row: &&FactorRow| {
        let range = (row.range.from(), row.range.to());
        row.lobe == Lobe::Cs16.id() && row.limit == Limit::Support.id() && range == RANGE
    };
    let rows: Vec<&FactorRow> = rows.iter().filter(shown).collect();
    let charts: Vec<LineChart> = Model::ALL.into_iter().filter_map(|model| panel(model, &rows)).collect();
    if charts.is_empty() {
        return Err(FigureError::NoLines);
    }
    let message = message(&rows);
    let chart = Chart::Panels(Panels {
        title: message.clone(),
        subtitle: "Residual on the true support. Above 0 a factor gains energy; one that never does loses \
                   up to twice the other's residual."
            .into(),
        columns: 2,
        charts,
    });
    Ok(Figure { stem: "factors", alt: format!("{message}."), chart })
}

fn find<'a>(
    model: Model,
    objective: Objective,
    forms: &[FactorForm],
    rows: &[&'a FactorRow],
) -> Option<&'a FactorRow> {
    let of = |form: FactorForm| {
        rows.iter().find(|r| r.model == model && r.objective == objective && r.form() == form)
    };
    forms.iter().rev().find_map(|form| of(*form)).copied()
}

fn panel(model: Model, rows: &[&FactorRow]) -> Option<LineChart> {
    let case = Case { model, lobe: Lobe::Cs16, limit: Limit::Support };
    let mut series = Vec::new();
    let (mut lo, mut hi) = (0.0_f64, 0.0_f64);
    let mut exact = true;
    for (index, (label, style, objective, forms)) in CURVES.into_iter().enumerate() {
        let Some(row) = find(model, objective, forms, rows) else { continue };
        let residual = Residual::new(case, row.factor.formula());
        let points = over_n(|n| residual.at(n).mid());
        (lo, hi) = points.iter().fold((lo, hi), |(lo, hi), p| (lo.min(p.1), hi.max(p.1)));
        exact &= row.extremes.magnitude().value.hi() == 0.0;
        series.push(Series { colour: Some(index), ..Series::new(label, style, points) });
    }
    if series.is_empty() {
        return None;
    }
    // Lines that are exactly 0 still need an axis.
    let room = (0.07 * (hi - lo)).max(1e-6);
    let levels = [FactorForm::Linear, FactorForm::Inverse]
        .into_iter()
        .filter_map(|form| find(model, Objective::Minimax, &[form], rows))
        .map(|row| number(row.extremes.magnitude().value.hi()));
    let subtitle = if exact {
        format!("{} n is exact", first_parameter(model, rows))
    } else {
        format!("largest residual {}", levels.collect::<Vec<_>>().join(", with p2/n "))
    };
    Some(LineChart {
        title: model.title().into(),
        subtitle,
        series,
        ..empty(n_axis(), Axis::new("residual 2π coef(n) Int(n) − 1", Scale::Linear, (lo - room, hi + room)))
    })
}

fn first_parameter<'a>(model: Model, rows: &[&'a FactorRow]) -> &'a str {
    let row = find(model, Objective::Minimax, &[FactorForm::Proportional], rows);
    row.and_then(|r| r.factor.parameters().first()).map_or("", String::as_str)
}

/// The model for which the further term brings most.
fn message(rows: &[&FactorRow]) -> String {
    let gain = |model: Model| {
        let level = |form| {
            find(model, Objective::Minimax, &[form], rows).map(|row| row.extremes.magnitude().value.hi())
        };
        let (line, inverse) = (level(FactorForm::Linear)?, level(FactorForm::Inverse)?);
        Some((line / inverse, line, inverse, model))
    };
    let most = Model::ALL.into_iter().filter_map(gain).max_by(|a, b| a.0.total_cmp(&b.0));
    match most {
        Some((times, line, inverse, model)) => format!(
            "{}: one more term p2/n makes the factor {times:.0} times better, {} instead of {}",
            model.title(),
            number(inverse),
            number(line)
        ),
        None => "Residuals of the factors over every real n of 16..1024".into(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fit::factor_rows;
    use crate::report::figures::render;

    fn rows(models: &[Model]) -> Vec<FactorRow> {
        let case = |&model: &Model| Case { model, lobe: Lobe::Cs16, limit: Limit::Support };
        let cases: Vec<Case> = models.iter().map(case).collect();
        factor_rows(&cases, "16..1024".parse().unwrap()).unwrap()
    }

    #[test]
    fn six_panels_show_what_the_rows_say() {
        let figure = factors(&rows(&Model::ALL)).unwrap();
        let Chart::Panels(panels) = &figure.chart else { panic!("panels") };
        assert_eq!(panels.charts.len(), 6);
        for (chart, model) in panels.charts.iter().zip(Model::ALL) {
            assert_eq!(chart.title, model.title());
            let exact = matches!(model, Model::Phong | Model::BlinnPhongNdf);
            assert_eq!(
                (chart.series.len(), chart.subtitle == "1.0625 n is exact"),
                (if exact { 2 } else { 3 }, exact)
            );
            // The dashed curve stays below 0, to the rounding of the drawn values.
            let never = chart.series.iter().find(|s| s.style == Style::Dashed).unwrap();
            assert!(never.points.iter().all(|p| p.1 <= 1e-13), "{}", chart.title);
        }
        let files = render(&[figure]).unwrap();
        assert_eq!((files[0].0.as_str(), files[1].0.as_str()), ("factors.svg", "factors.png"));
    }

    #[test]
    fn without_rows_there_is_no_figure() {
        assert_eq!(factors(&[]).unwrap_err(), FigureError::NoLines);
        let mut other = rows(&[Model::Phong]);
        other.iter_mut().for_each(|row| row.lobe = "another".into());
        assert_eq!(factors(&other).unwrap_err(), FigureError::NoLines);
    }
}
