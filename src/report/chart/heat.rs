use super::ChartError;
use super::axis::{Axis, Scale};
use super::clip::inside;
use super::colour::{FRAME, GREY, INK, MISSING, Rgb, WHITE, diverging, rising};
use super::frame::{Frame, Plot};
use super::header::{FULL, Sizes, header};
use super::legend::{Colours, Key, Legend};
use super::line::curve;
use super::mark::Mark;
use super::scene::{Anchor, EDGE, LEADING, Raster, Rect, Scene, WIDTH};
use super::series::{Series, Style};
use super::ticks::{Room, Tick, ticks};

/// A value over two arguments, as colour, with a colour bar.
#[derive(Clone, Debug, PartialEq)]
pub struct HeatMap {
    /// The line above, in the picture's largest text.
    pub title: String,
    /// What stands under the title, in grey; may be empty.
    pub subtitle: String,
    /// The axis across.
    pub x: Axis,
    /// The axis up.
    pub y: Axis,
    /// What the colours mean, with its unit.
    pub value_label: String,
    /// The values at the ends of the palette; values beyond, infinite ones too, have the end's colour.
    pub value_range: (f64, f64),
    /// Cells across.
    pub columns: usize,
    /// Cells up.
    pub rows: usize,
    /// A value a cell, row by row from the lowest y up, each row from the lowest x on, taken at the
    /// cells' centres ([`Axis::centres`]); NaN is grey.
    pub values: Vec<f64>,
    /// Blue below 0, white at 0, red above, instead of dark to light.
    pub diverging: bool,
    /// Curves on top, such as a cut.
    pub curves: Vec<Series>,
    /// Texts about their places, without dots.
    pub labels: Vec<Mark>,
}

const PLOT: f64 = 860.0;
const BAR: f64 = 36.0;
const GAP: f64 = 10.0;
/// Steps of the colour bar: finer than is seen.
const STEPS: usize = 256;

impl HeatMap {
    pub(super) fn scene(&self) -> Result<Scene, ChartError> {
        if self.values.is_empty() || self.columns.checked_mul(self.rows) != Some(self.values.len()) {
            return Err(ChartError::Cells {
                title: self.title.clone(),
                columns: self.columns,
                rows: self.rows,
                given: self.values.len(),
            });
        }
        self.curves.iter().try_for_each(Series::check)?;
        let bar = Axis::new(self.value_label.as_str(), Scale::Linear, self.value_range);
        bar.span()?;

        let mut scene = Scene::new(&self.title)?;
        let top = header(&mut scene, &self.title, &self.subtitle);
        let outer = Rect { left: EDGE, top, right: WIDTH - EDGE, bottom: top + PLOT };
        let plot = Plot { x: &self.x, y: &self.y, sizes: &FULL, x_label: true, y_label: true };
        let room = self.bar_room(&scene, &bar)?;
        let mut margins = plot.margins(scene.font, outer.width() - room, outer.height())?;
        margins.right = margins.right.max(EDGE) + room;
        let frame = plot.frame(&outer, &margins)?;

        self.cells(&mut scene, &frame);
        let mut colours = Colours::default();
        let mut legend = Legend::default();
        for series in &self.curves {
            let colour = colours.series(series);
            legend.add(&series.label, Key::Series(series.style, colour));
            // A white casing: one colour of line cannot stand out from all colours of cells.
            let casing = Sizes { line: 1.8 * FULL.line, ..FULL };
            let under = Series { style: Style::Line, ..series.clone() };
            if series.style != Style::Points {
                curve(&mut scene, &under, &frame, WHITE, &casing);
            }
            curve(&mut scene, series, &frame, colour, &FULL);
        }
        for label in &self.labels {
            self.label(&mut scene, &frame, label);
        }
        if self.values.iter().any(|v| v.is_nan()) {
            legend.add("no value", Key::Patch(MISSING, 1.0, FRAME));
        }
        plot.surround(&mut scene, &frame)?;
        self.bar(&mut scene, &bar, &frame, outer.right - room)?;
        let below = Rect { left: frame.rect.left, top: outer.bottom + 0.8 * EDGE, ..outer };
        scene.height = below.top + legend.draw(&mut scene, &below, &FULL) + 0.6 * EDGE;
        Ok(scene)
    }

    fn colour(&self, value: f64) -> Rgb {
        let (lo, hi) = self.value_range;
        if value.is_nan() {
            MISSING
        } else if self.diverging {
            diverging(0.5 + 0.5 * value / lo.abs().max(hi.abs()))
        } else {
            rising((value - lo) / (hi - lo))
        }
    }

    fn cells(&self, scene: &mut Scene, frame: &Frame) {
        // Pictures go down where axes go up.
        let rows = self.values.chunks(self.columns).rev();
        let cells = rows.flatten().map(|&v| self.colour(v)).collect();
        scene.rasters.push(Raster { rect: frame.rect, columns: self.columns, rows: self.rows, cells });
    }

    /// A text in white on dark cells, and dark on others; the cell's colour covers a curve behind it.
    fn label(&self, scene: &mut Scene, frame: &Frame, label: &Mark) {
        let Some((u, v)) = frame.place(label.at).filter(|&at| inside(at)) else { return };
        let cell = |part: f64, count: usize| ((part * count as f64) as usize).min(count - 1);
        let value = self.values[cell(v, self.rows) * self.columns + cell(u, self.columns)];
        let Rgb(red, green, blue) = self.colour(value);
        let light = 3 * u32::from(red) + 6 * u32::from(green) + u32::from(blue);
        let (x, y) = frame.pixel((u, v));
        let colour = if light < 1200 { WHITE } else { INK };
        let (across, up) = (0.53 * scene.font.width(&label.text, FULL.tick), 0.5 * FULL.tick);
        let behind = Rect { left: x - across, top: y - up, right: x + across, bottom: y + up };
        scene.fill(behind, self.colour(value), 1.0);
        scene.text((x, y + 0.36 * FULL.tick), &label.text, FULL.tick, colour, Anchor::Middle);
    }

    fn bar_ticks(&self, scene: &Scene, bar: &Axis, length: f64) -> Result<Vec<Tick>, ChartError> {
        Ok(ticks(bar, &bar.span()?, scene.font, Room { length, size: FULL.tick, across: false }))
    }

    /// The width of the colour bar with its texts, and the gap before it.
    fn bar_room(&self, scene: &Scene, bar: &Axis) -> Result<f64, ChartError> {
        let lines = scene.font.wrap(&bar.label, FULL.label, 0.8 * PLOT).len();
        let widest = self.widest(scene, bar, 0.85 * PLOT)?;
        Ok(BAR + GAP + widest + GAP + LEADING * FULL.label * lines as f64)
    }

    fn widest(&self, scene: &Scene, bar: &Axis, length: f64) -> Result<f64, ChartError> {
        let ticks = self.bar_ticks(scene, bar, length)?;
        let widths = ticks.iter().map(|t| scene.font.width(&t.label, FULL.tick));
        Ok(8.0 + 1.08 * widths.fold(0.0, f64::max))
    }

    fn bar(&self, scene: &mut Scene, bar: &Axis, frame: &Frame, left: f64) -> Result<(), ChartError> {
        let rect = Rect { left, right: left + BAR, ..frame.rect };
        let (lo, hi) = self.value_range;
        let value = |i: usize| hi - (hi - lo) * (i as f64 + 0.5) / STEPS as f64;
        let cells = (0..STEPS).map(|i| self.colour(value(i))).collect();
        scene.rasters.push(Raster { rect, columns: 1, rows: STEPS, cells });
        scene.outline(&rect, FRAME, 2.0);
        for tick in self.bar_ticks(scene, bar, rect.height())? {
            let y = rect.bottom - tick.at * rect.height();
            scene.stroke(vec![(rect.right, y), (rect.right + 8.0, y)], FRAME, 2.0);
            let at = (rect.right + 8.0 + GAP, y + 0.36 * FULL.tick);
            scene.text(at, &tick.label, FULL.tick, GREY, Anchor::Start);
        }
        let from = rect.right + GAP + self.widest(scene, bar, rect.height())? + GAP;
        for (i, line) in scene.font.wrap(&bar.label, FULL.label, 0.95 * rect.height()).iter().enumerate() {
            let x = from + (LEADING * i as f64 + 0.95) * FULL.label;
            scene.text_upwards((x, 0.5 * (rect.top + rect.bottom)), line, FULL.label, INK);
        }
        Ok(())
    }
}
