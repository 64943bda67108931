use super::ChartError;
use super::frame::{Margins, Plot};
use super::header::{FULL, Heading, SMALL, header};
use super::legend::{Colours, Legend};
use super::line::LineChart;
use super::scene::{EDGE, Rect, Scene, WIDTH};

/// Small multiples in rows, with one legend; a label has the same colour in every panel.
///
/// An axis label that all panels share stands only at the bottom of each column, or at the left of
/// each row.
#[derive(Clone, Debug, PartialEq)]
pub struct Panels {
    /// The line above, in the picture's largest text.
    pub title: String,
    /// What stands under the title, in grey; may be empty.
    pub subtitle: String,
    /// The number of panels side by side: 1 to 4 are readable.
    pub columns: usize,
    /// The panels, row by row.
    pub charts: Vec<LineChart>,
}

/// The distance between neighbouring panels.
const BETWEEN: f64 = 24.0;
/// About what the texts over and under a frame take from a panel's height.
const ROOM: f64 = 90.0;

impl Panels {
    pub(super) fn scene(&self) -> Result<Scene, ChartError> {
        let (count, columns) = (self.charts.len(), self.columns.min(self.charts.len()));
        if columns == 0 {
            let title = self.title.clone();
            return Err(ChartError::Panels { title, columns: self.columns, charts: count });
        }
        self.charts.iter().try_for_each(LineChart::check)?;
        let mut scene = Scene::new(&self.title)?;
        let mut top = header(&mut scene, &self.title, &self.subtitle);

        let cell = (WIDTH - 2.0 * EDGE) / columns as f64 - BETWEEN;
        let height = (0.45 * cell + 110.0).min(600.0);
        // The frames of a column, and those of a row, line up; all are of one size.
        let (mut sides, mut ends) = (vec![Margins::default(); columns], vec![Margins::default(); count]);
        for i in 0..count {
            let margins = self.plot(i, columns).margins(scene.font, cell, height + ROOM)?;
            sides[i % columns] = sides[i % columns].join(margins);
            ends[i / columns] = ends[i / columns].join(margins);
        }
        let taken: f64 = sides.iter().map(|m| m.left + m.right).sum();
        let width = (WIDTH - 2.0 * EDGE - BETWEEN * (columns - 1) as f64 - taken) / columns as f64;

        let (mut colours, mut bands) = (Colours::default(), Colours::default());
        for (row, (charts, end)) in self.charts.chunks(columns).zip(&ends).enumerate() {
            let headings: Vec<Heading> = charts
                .iter()
                .map(|c| Heading::new(scene.font, &c.title, &c.subtitle, width, &SMALL))
                .collect();
            let tallest = headings.iter().map(|h| h.height).fold(0.0, f64::max);
            let mut left = EDGE;
            for (i, (chart, heading)) in charts.iter().zip(&headings).enumerate() {
                let margins = Margins { top: end.top, bottom: end.bottom, ..sides[i] };
                let right = left + margins.left + width + margins.right;
                heading.draw(&mut scene, left + margins.left, top + tallest - heading.height);
                let under = top + tallest;
                let bottom = under + margins.top + height + margins.bottom;
                let plot = self.plot(row * columns + i, columns);
                let frame = plot.frame(&Rect { left, top: under, right, bottom }, &margins)?;
                chart.draw(&mut scene, &plot, &frame, &mut colours, &mut bands)?;
                left = right + BETWEEN;
            }
            top += tallest + end.top + height + end.bottom + BETWEEN;
        }
        let left = EDGE + sides[0].left;
        let below = Rect { left, top, right: WIDTH - EDGE, bottom: top };
        scene.height = top + Legend::of(&self.charts).draw(&mut scene, &below, &FULL) + 0.6 * EDGE;
        Ok(scene)
    }

    fn plot(&self, index: usize, columns: usize) -> Plot<'_> {
        let chart = &self.charts[index];
        let one_x = self.charts.iter().all(|c| c.x.label == chart.x.label);
        let one_y = self.charts.iter().all(|c| c.y.label == chart.y.label);
        let lowest = index + columns >= self.charts.len();
        chart.plot(&SMALL, lowest || !one_x, index.is_multiple_of(columns) || !one_y)
    }
}
