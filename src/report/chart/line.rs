use super::ChartError;
use super::axis::Axis;
use super::clip::{inside, runs};
use super::colour::Rgb;
use super::frame::{Frame, Plot};
use super::header::{FULL, Sizes, header};
use super::legend::{Colours, Legend, OPACITY};
use super::mark::{self, Mark};
use super::scene::{EDGE, Point, Rect, Scene, WIDTH};
use super::series::{Band, Series, Style};
use super::stroke;

/// Curves over one pair of axes.
#[derive(Clone, Debug, PartialEq)]
pub struct LineChart {
    /// The line above, in the picture's largest text.
    pub title: String,
    /// What stands under the title, in grey; may be empty.
    pub subtitle: String,
    /// The axis across.
    pub x: Axis,
    /// The axis up.
    pub y: Axis,
    /// Bands under the curves.
    pub bands: Vec<Band>,
    /// The curves, later ones over earlier ones.
    pub series: Vec<Series>,
    /// Dots with labels, over the curves.
    pub marks: Vec<Mark>,
}

/// The height of a plot with its axes' texts.
const PLOT: f64 = 760.0;

impl LineChart {
    pub(super) fn scene(&self) -> Result<Scene, ChartError> {
        self.check()?;
        let mut scene = Scene::new(&self.title)?;
        let top = header(&mut scene, &self.title, &self.subtitle);
        let outer = Rect { left: EDGE, top, right: WIDTH - EDGE, bottom: top + PLOT };
        let plot = self.plot(&FULL, true, true);
        let margins = plot.margins(scene.font, outer.width(), outer.height())?;
        let frame = plot.frame(&outer, &margins)?;
        self.draw(&mut scene, &plot, &frame, &mut Colours::default(), &mut Colours::default())?;
        let below = Rect { left: frame.rect.left, top: outer.bottom + 0.8 * EDGE, ..outer };
        scene.height = below.top + Legend::of([self]).draw(&mut scene, &below, &FULL) + 0.6 * EDGE;
        Ok(scene)
    }

    /// Whether everything given can be drawn.
    pub(super) fn check(&self) -> Result<(), ChartError> {
        if self.series.is_empty() {
            return Err(ChartError::NoSeries { title: self.title.clone() });
        }
        self.x.span()?;
        self.y.span()?;
        self.series.iter().try_for_each(Series::check)?;
        self.bands.iter().try_for_each(Band::check)
    }

    pub(super) fn plot<'a>(&'a self, sizes: &'a Sizes, x_label: bool, y_label: bool) -> Plot<'a> {
        Plot { x: &self.x, y: &self.y, sizes, x_label, y_label }
    }

    /// Draws everything inside the frame and around it.
    pub(super) fn draw(
        &self,
        scene: &mut Scene,
        plot: &Plot<'_>,
        frame: &Frame,
        colours: &mut Colours,
        bands: &mut Colours,
    ) -> Result<(), ChartError> {
        for band in &self.bands {
            let (fill, border) = bands.band(&band.label);
            let (lo, hi) = (frame.y.place_end(band.lo), frame.y.place_end(band.hi));
            let (bottom, top) = (frame.pixel((0.0, lo)).1, frame.pixel((0.0, hi)).1);
            scene.fill(Rect { top, bottom, ..frame.rect }, fill, OPACITY);
            for (value, y) in [(band.lo, bottom), (band.hi, top)] {
                // An end outside the range is not at the frame.
                if frame.y.place(value).is_some_and(|v| inside((0.0, v))) {
                    scene.stroke(vec![(frame.rect.left, y), (frame.rect.right, y)], border, 2.5);
                }
            }
        }
        plot.grid(scene, frame)?;
        plot.surround(scene, frame)?;
        let mut lines = Vec::new();
        for series in &self.series {
            let colour = colours.series(series);
            lines.extend(curve(scene, series, frame, colour, plot.sizes));
        }
        mark::draw(scene, &self.marks, frame, &lines, plot.sizes);
        Ok(())
    }
}

/// Draws a series inside the frame; returns its runs in pixels.
pub(super) fn curve(
    scene: &mut Scene,
    series: &Series,
    frame: &Frame,
    colour: Rgb,
    sizes: &Sizes,
) -> Vec<Vec<Point>> {
    let placed = series.points.iter().map(|&p| frame.place(p));
    let runs = if series.style == Style::Points {
        // Unconnected points are not cut: those outside are left out.
        placed.flatten().filter(|&p| inside(p)).map(|p| vec![p]).collect()
    } else {
        runs(placed)
    };
    let mut drawn = Vec::new();
    for run in runs {
        let run: Vec<Point> = run.into_iter().map(|p| frame.pixel(p)).collect();
        stroke::draw(scene, &run, series.style, colour, sizes.line);
        drawn.push(run);
    }
    drawn
}
