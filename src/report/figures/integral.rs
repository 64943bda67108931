//! n Int(n) of the models, by lobe and limit.

use super::Figure;
use super::sample::{RANGE, empty, n_axis, over_n};
use crate::integral::{Case, Limit, Lobe, scaled_closed_form};
use crate::kernel::model::Model;
use crate::report::chart::{Axis, Chart, LineChart, Panels, Scale, Series, Style};

/// What is drawn of each model; later lines lie over earlier ones.
const CURVES: [(&str, Lobe, Limit, Style); 4] = [
    ("cosⁿ, hemisphere", Lobe::CosN, Limit::Support, Style::Line),
    ("cs_16, its support", Lobe::Cs16, Limit::Support, Style::Line),
    ("cs_16, up to 6/√n", Lobe::Cs16, Limit::Paper, Style::Dashed),
    ("cs_16, up to √(6/n)", Lobe::Cs16, Limit::Card, Style::Dotted),
];

/// n Int(n) over n: how much each limit leaves of the lobe.
pub(super) fn integrals() -> Figure {
    let mut charts: Vec<LineChart> = Vec::new();
    for model in Model::ALL {
        let series: Vec<Series> = CURVES
            .into_iter()
            .map(|(label, lobe, limit, style)| {
                let case = Case { model, lobe, limit };
                Series::new(label, style, over_n(|n| scaled_closed_form(case, &(1.0 / n))))
            })
            .collect();
        // A distribution of normals has the integral of its namesake in θ: one panel serves both.
        if let Some(same) = charts.iter_mut().find(|chart| chart.series == series) {
            same.title = format!("{} and {}", same.title, model.title());
            continue;
        }
        let values = series.iter().flat_map(|s| s.points.iter().map(|p| p.1));
        let (lo, hi) = values.fold((f64::INFINITY, 0.0_f64), |(lo, hi), v| (lo.min(v), hi.max(v)));
        let room = 0.06 * (hi - lo);
        let y = Axis::new("n · Int(n) (units of 2π sr)", Scale::Linear, (lo - room, hi + room));
        charts.push(LineChart { title: model.title().into(), series, ..empty(n_axis(), y) });
    }
    let [phong, blinn] = [Model::Phong, Model::BlinnPhong].map(|model| lost(model, Limit::Card));
    let message = format!("Cut at √(6/n), Phong's lobe loses {phong:.1} %, Blinn-Phong's {blinn:.0} %");
    let chart = Chart::Panels(Panels {
        title: message.clone(),
        subtitle: "The integrals with their limits, times n. Losses are those of cs_16 at n = 1024.".into(),
        columns: 2,
        charts,
    });
    let alt = format!(
        "{message} of its integral; cut at 6/√n, Blinn-Phong's loses {:.1} %.",
        lost(Model::BlinnPhong, Limit::Paper)
    );
    Figure { stem: "integrals", alt, chart }
}

/// The percentage of cs_16 beyond the limit, at the largest n.
fn lost(model: Model, limit: Limit) -> f64 {
    let at = |limit| scaled_closed_form(Case { model, lobe: Lobe::Cs16, limit }, &(1.0 / RANGE.1));
    let (cut, whole): (f64, f64) = (at(limit), at(Limit::Support));
    100.0 * (1.0 - cut / whole)
}
