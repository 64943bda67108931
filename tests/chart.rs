//! Charts: their formats, their limits, and that nothing is drawn where nothing is.
#![cfg(feature = "toolkit")]
#![allow(clippy::unwrap_used)] // helpers of tests may panic as tests do

use bellfit::report::chart::{
    Axis, Band, Chart, ChartError, HeatMap, LineChart, Mark, Panels, Scale, Series, Style,
};

/// The picture's width in pixels, and in the finer units of the SVG.
const WIDTH: u32 = 1600;
const FINE: f64 = 4.0;

fn line(series: Vec<Series>) -> LineChart {
    LineChart {
        title: "A bell & its <lobe>".into(),
        subtitle: "at n = 128".into(),
        x: Axis::new("θ (rad)", Scale::Linear, (0.0, 1.0)),
        y: Axis::new("value \"f\"", Scale::Linear, (0.0, 1.0)),
        bands: vec![],
        series,
        marks: vec![],
    }
}

fn parabola(style: Style) -> Series {
    let points = (0..=200).map(|i| f64::from(i) / 200.0).map(|t| (t, 4.0 * t * (1.0 - t))).collect();
    Series::new("4 t (1 − t)", style, points)
}

fn heat() -> HeatMap {
    let (columns, rows) = (40, 30);
    let values = (0..columns * rows)
        .map(|i| if i % 17 == 0 { f64::NAN } else { (i % columns) as f64 / columns as f64 - 0.5 })
        .collect();
    HeatMap {
        title: "Residual".into(),
        subtitle: String::new(),
        x: Axis::new("n", Scale::Log2, (16.0, 1024.0)),
        y: Axis::new("t", Scale::Linear, (0.0, 4.0)),
        value_label: "difference".into(),
        value_range: (-0.5, 0.5),
        columns,
        rows,
        values,
        diverging: true,
        curves: vec![Series::new("cut", Style::Dashed, vec![(16.0, 1.0), (1024.0, 3.0)])],
        labels: vec![],
    }
}

fn panels() -> Panels {
    Panels {
        title: "Six".into(),
        subtitle: "small multiples".into(),
        columns: 3,
        charts: (0..6)
            .map(|i| LineChart { title: format!("panel {i}"), ..line(vec![parabola(Style::Line)]) })
            .collect(),
    }
}

fn all() -> [Chart; 3] {
    let chart = LineChart {
        bands: vec![Band { label: "stated bound".into(), lo: 0.2, hi: f64::INFINITY }],
        marks: vec![Mark { at: (0.5, 1.0), text: "max 1 at t = 0.5".into() }],
        ..line(vec![parabola(Style::Line), Series::new("half", Style::Dotted, vec![(0.0, 0.5), (1.0, 0.5)])])
    };
    [Chart::Line(chart), Chart::Heat(heat()), Chart::Panels(panels())]
}

/// Every polyline in the SVG with this colour, in its fine units.
fn polylines(svg: &str, colour: &str) -> Vec<Vec<(f64, f64)>> {
    svg.lines()
        .filter(|l| l.starts_with("<polyline") && l.contains(&format!("stroke=\"{colour}\"")))
        .map(|l| {
            let points = l.split("points=\"").nth(1).unwrap().split('"').next().unwrap();
            let pair = |p: &str| p.split_once(',').map(|(x, y)| (x.parse().unwrap(), y.parse().unwrap()));
            points.split_whitespace().map(|p| pair(p).unwrap()).collect()
        })
        .collect()
}

/// What is drawn of the first series: in the palette's first colour, and not in the legend, which is
/// below the ticks' labels.
fn first_series(svg: &str) -> Vec<Vec<(f64, f64)>> {
    let legend = frame(svg)[2].1 + 40.0 * FINE;
    polylines(svg, "#0072B2").into_iter().filter(|line| line[0].1 < legend).collect()
}

/// The frame's outline: the only closed polyline of five points in its grey.
fn frame(svg: &str) -> Vec<(f64, f64)> {
    polylines(svg, "#707070").into_iter().find(|p| p.len() == 5).unwrap()
}

fn decode(bytes: &[u8]) -> (u32, u32, Vec<u8>) {
    let mut decoder = png::Decoder::new(std::io::Cursor::new(bytes));
    decoder.set_transformations(png::Transformations::EXPAND);
    let mut reader = decoder.read_info().unwrap();
    let mut pixels = vec![0; reader.output_buffer_size().unwrap()];
    let info = reader.next_frame(&mut pixels).unwrap();
    assert_eq!(info.color_type, png::ColorType::Rgb);
    (info.width, info.height, pixels)
}

#[test]
fn svg_is_one_element_with_balanced_tags_and_no_nan() {
    for chart in all() {
        let svg = chart.svg().unwrap();
        assert!(svg.starts_with("<svg ") && svg.trim_end().ends_with("</svg>"));
        assert!(svg.contains("viewBox=\"0 0 6400 ") && svg.contains("width=\"100%\""));
        // The image's code may hold any letters.
        let drawn = svg.lines().filter(|line| !line.starts_with("<image"));
        assert!(
            drawn.clone().count() > 10 && drawn.into_iter().all(|l| !l.contains("NaN") && !l.contains("inf"))
        );
        for tag in ["svg", "text", "title"] {
            let open = svg.matches(&format!("<{tag} ")).count() + svg.matches(&format!("<{tag}>")).count();
            assert_eq!(open, svg.matches(&format!("</{tag}>")).count(), "{tag}");
        }
        assert!(svg.contains("font-family=\"DejaVu Sans, Verdana, sans-serif\""));
    }
}

#[test]
fn every_text_is_in_the_svg_escaped() {
    let [first, second, third] = all().map(|chart| chart.svg().unwrap());
    for text in [
        "A bell &amp; its &lt;lobe&gt;",
        "at n = 128",
        "θ (rad)",
        "value &quot;f&quot;",
        "4 t (1 − t)",
        "half",
        "stated bound",
        "max 1 at t = 0.5",
        "0.8",
    ] {
        assert!(first.contains(text), "{text}");
    }
    for text in ["Residual", "difference", "1024", "cut", "no value", "-0.2", "data:image/png;base64,"] {
        assert!(second.contains(text), "{text}");
    }
    for i in 0..6 {
        assert!(third.contains(&format!("panel {i}")));
    }
    // One legend for all panels.
    assert_eq!(third.matches("4 t (1 − t)").count(), 1);
}

#[test]
fn both_formats_are_the_same_twice() {
    for (one, two) in all().iter().zip(&all()) {
        assert_eq!(one.svg(), two.svg());
        assert_eq!(one.png(), two.png());
    }
}

#[test]
fn png_has_the_size_of_the_svg_and_shows_the_curve() {
    for chart in all() {
        let (width, height, pixels) = decode(&chart.png().unwrap());
        assert_eq!(width, WIDTH);
        let svg = chart.svg().unwrap();
        let tall: f64 =
            svg.split("viewBox=\"0 0 6400 ").nth(1).unwrap().split('"').next().unwrap().parse().unwrap();
        assert!((f64::from(height) - tall / FINE).abs() <= 1.0);
        let count = |wanted: [u8; 3]| pixels.chunks(3).filter(|p| *p == wanted).count();
        assert!(count([0xFF; 3]) > pixels.len() / 30, "a white ground");
        assert!(count([0x00, 0x72, 0xB2]) > 500, "a blue curve");
        // Nothing is cut off at the edges.
        let row = 3 * width as usize;
        let edge = pixels[..row].iter().chain(&pixels[pixels.len() - row..]);
        let sides = pixels.chunks(row).flat_map(|r| r[..3].iter().chain(&r[row - 3..]));
        assert!(edge.chain(sides).all(|&v| v == 0xFF));
    }
}

#[test]
fn text_is_drawn_without_any_installed_font() {
    let blank = Chart::Line(LineChart { title: String::new(), ..line(vec![parabola(Style::Line)]) });
    let titled = Chart::Line(line(vec![parabola(Style::Line)]));
    let dark = |chart: &Chart| {
        let (_, _, pixels) = decode(&chart.png().unwrap());
        pixels.chunks(3).filter(|p| *p == [0x22; 3]).count()
    };
    assert!(dark(&titled) > dark(&blank) + 500);
}

#[test]
fn non_finite_points_split_a_line() {
    for bad in [(0.5, f64::NAN), (f64::NAN, 0.5), (0.5, f64::INFINITY), (f64::NEG_INFINITY, 0.5)] {
        let points = vec![(0.1, 0.2), (0.4, 0.2), bad, (0.6, 0.8), (0.9, 0.8)];
        let svg = Chart::Line(line(vec![Series::new("split", Style::Line, points)])).svg().unwrap();
        let runs = first_series(&svg);
        assert_eq!(runs.len(), 2, "{bad:?}");
        assert!(runs.iter().all(|run| run.len() == 2 && run[0].1 == run[1].1));
    }
}

#[test]
fn a_value_below_a_logarithm_splits_a_line() {
    let points = vec![(0.1, 0.2), (0.4, 0.2), (0.5, 0.0), (0.55, -1.0), (0.6, 0.8), (0.9, 0.8)];
    let chart = LineChart {
        y: Axis::new("y", Scale::Log10, (0.1, 1.0)),
        ..line(vec![Series::new("split", Style::Line, points)])
    };
    assert_eq!(first_series(&Chart::Line(chart).svg().unwrap()).len(), 2);
}

#[test]
fn nothing_but_non_finite_points_draws_no_line() {
    for style in [Style::Line, Style::Dashed, Style::Dotted, Style::Points] {
        let chart = Chart::Line(line(vec![Series::new("none", style, vec![(f64::NAN, f64::NAN); 3])]));
        assert!(first_series(&chart.svg().unwrap()).is_empty());
        assert!(chart.png().is_ok());
    }
}

#[test]
fn curves_are_cut_at_the_frame() {
    let wild =
        vec![(-3.0, 0.5), (0.2, 0.5), (0.4, 7.0), (0.6, -1e300), (0.7, 0.4), (1e200, 1e200), (0.9, 0.1)];
    for style in [Style::Line, Style::Dashed, Style::Dotted] {
        let svg = Chart::Line(line(vec![Series::new("wild", style, wild.clone())])).svg().unwrap();
        let corners = frame(&svg);
        let (left, top) = corners[0];
        let (right, bottom) = corners[2];
        let lines = first_series(&svg);
        assert!(style == Style::Dotted || !lines.is_empty());
        for (x, y) in lines.into_iter().flatten() {
            assert!((left..=right).contains(&x) && (top..=bottom).contains(&y), "{style:?}: {x}, {y}");
        }
    }
}

#[test]
fn a_logarithmic_axis_places_by_ratio() {
    let series = Series::new("mid", Style::Line, vec![(16.0, 0.5), (128.0, 0.5)]);
    let chart = LineChart { x: Axis::new("n", Scale::Log2, (16.0, 1024.0)), ..line(vec![series]) };
    let svg = Chart::Line(chart).svg().unwrap();
    let corners = frame(&svg);
    let run = &first_series(&svg)[0];
    assert!((run[1].0 - 0.5 * (corners[0].0 + corners[1].0)).abs() <= 1.0);
    for label in ["16", "32", "64", "128", "256", "512", "1024"] {
        assert!(svg.contains(&format!(">{label}<")), "{label}");
    }
}

#[test]
fn bad_ranges_are_refused_by_name_and_value() {
    let bad = [(1.0, 0.0), (1.0, 1.0), (f64::NAN, 1.0), (0.0, f64::INFINITY), (-f64::MAX, f64::MAX)];
    for range in bad {
        for scale in [Scale::Linear, Scale::Log2, Scale::Log10] {
            let y = Axis::new("height", scale, range);
            let error = Chart::Line(LineChart { y, ..line(vec![parabola(Style::Line)]) }).svg().unwrap_err();
            assert!(matches!(error, ChartError::Range { .. }), "{error}");
            assert!(error.to_string().contains("height"), "{error}");
        }
        let error = Chart::Heat(HeatMap { value_range: range, ..heat() }).png().unwrap_err();
        assert!(matches!(error, ChartError::Range { .. }), "{error}");
    }
    for lo in [0.0, -2.5] {
        let x = Axis::new("n", Scale::Log2, (lo, 8.0));
        let error = Chart::Line(LineChart { x, ..line(vec![parabola(Style::Line)]) }).svg().unwrap_err();
        assert!(matches!(error, ChartError::LogRange { lo: l, hi: 8.0, .. } if l == lo));
        assert!(error.to_string().contains(&format!("{lo} to 8")), "{error}");
    }
}

#[test]
fn missing_data_is_refused() {
    let error = |chart: Chart| chart.svg().unwrap_err().to_string();
    assert!(error(Chart::Line(line(vec![]))).contains("no series"));
    assert_eq!(
        error(Chart::Line(line(vec![Series::new("bare", Style::Line, vec![])]))),
        "series \"bare\" has no points"
    );
    let few = HeatMap { values: vec![0.0; 7], ..heat() };
    assert!(error(Chart::Heat(few)).contains("7 values for 40 columns × 30 rows"));
    assert!(error(Chart::Heat(HeatMap { columns: 0, values: vec![], ..heat() })).contains("0 values"));
    assert!(error(Chart::Panels(Panels { columns: 0, ..panels() })).contains("6 charts in 0 columns"));
    assert!(error(Chart::Panels(Panels { charts: vec![], ..panels() })).contains("0 charts"));
    let band = Band { label: "upside down".into(), lo: 2.0, hi: 1.0 };
    assert!(
        error(Chart::Line(LineChart { bands: vec![band], ..line(vec![parabola(Style::Line)]) }))
            .contains("2 to 1")
    );
}

#[test]
fn labels_of_marks_stay_inside_the_frame() {
    let text = "max 1.70e-2 at t = 2.03";
    for at in [(0.0, 0.0), (1.0, 0.0), (0.0, 1.0), (1.0, 1.0), (0.5, 0.5)] {
        let marks =
            vec![Mark { at, text: text.into() }, Mark { at: (f64::NAN, 0.0), text: "nowhere".into() }];
        let svg = Chart::Line(LineChart { marks, ..line(vec![parabola(Style::Line)]) }).svg().unwrap();
        assert!(!svg.contains("nowhere"));
        let corners = frame(&svg);
        let tag = svg.split('<').find(|t| t.starts_with("text") && t.contains(text)).unwrap();
        let x: f64 = tag.split(" x=\"").nth(1).unwrap().split('"').next().unwrap().parse().unwrap();
        // A little less than a character's mean width.
        let width = 0.5 * 26.0 * FINE * text.len() as f64;
        assert!(x >= corners[0].0 && x + width <= corners[1].0 + 1.0, "{at:?}: {x}");
    }
}

#[test]
fn a_label_has_one_colour_in_all_panels() {
    let other = || Series::new("other", Style::Line, vec![(0.0, 0.1), (1.0, 0.9)]);
    let mut figure = panels();
    figure.charts[0].series = vec![parabola(Style::Line), other()];
    figure.charts[1].series = vec![other()];
    figure.charts.truncate(2);
    let svg = Chart::Panels(figure).svg().unwrap();
    // Two curves and the legend's sample.
    assert_eq!(polylines(&svg, "#D55E00").len(), 3);
    assert_eq!(polylines(&svg, "#0072B2").len(), 2);
}

#[test]
fn a_colour_can_be_chosen() {
    let chosen = Series { colour: Some(10), ..parabola(Style::Line) };
    let svg = Chart::Line(line(vec![chosen])).svg().unwrap();
    assert_eq!(polylines(&svg, "#009E73").len(), 2);
}

#[test]
fn the_callers_ticks_are_kept_and_thinned() {
    let series = vec![parabola(Style::Line)];
    let ticks = vec![(0.25, "quarter".to_owned()), (0.26, "crowded".to_owned()), (7.0, "outside".to_owned())];
    let x = Axis { ticks, ..Axis::new("x", Scale::Linear, (0.0, 1.0)) };
    let svg = Chart::Line(LineChart { x, ..line(series) }).svg().unwrap();
    assert!(svg.contains("quarter") && !svg.contains("crowded") && !svg.contains("outside"));
}

#[test]
fn a_heat_maps_first_value_is_at_the_lower_left() {
    let mut map = heat();
    map.curves.clear();
    map.values.fill(-0.5);
    map.values[0] = 0.5;
    let chart = Chart::Heat(map);
    let corners = frame(&chart.svg().unwrap());
    let (width, _, pixels) = decode(&chart.png().unwrap());
    let pixel = |x: f64, y: f64| {
        let at = 3 * ((y / FINE) as usize * width as usize + (x / FINE) as usize);
        [pixels[at], pixels[at + 1], pixels[at + 2]]
    };
    let ((left, top), (right, bottom)) = (corners[0], corners[2]);
    assert_eq!(pixel(left + 24.0, bottom - 24.0), [0x7D, 0x15, 0x24]);
    assert_eq!(pixel(left + 24.0, top + 24.0), [0x15, 0x3B, 0x7C]);
    assert_eq!(pixel(right - 24.0, bottom - 24.0), [0x15, 0x3B, 0x7C]);
}

#[test]
fn a_heat_maps_labels_are_dark_on_light_cells_and_white_on_dark() {
    let mark = |at, text: &str| Mark { at, text: text.into() };
    // Two cells of the same row: the palette's dark end and its light one.
    let map = HeatMap {
        x: Axis::new("x", Scale::Linear, (0.0, 2.0)),
        y: Axis::new("y", Scale::Linear, (0.0, 1.0)),
        value_range: (0.0, 1.0),
        columns: 2,
        rows: 1,
        values: vec![0.0, 1.0],
        diverging: false,
        curves: vec![],
        labels: vec![mark((0.5, 0.5), "low"), mark((1.5, 0.5), "high"), mark((9.0, 0.5), "nowhere")],
        ..heat()
    };
    let svg = Chart::Heat(map).svg().unwrap();
    let colour = |text: &str| {
        let before = svg.split(&format!(">{text}<")).next().unwrap();
        let tag = before.rsplit("<text ").next().unwrap();
        assert!(before.len() < svg.len(), "{text}");
        tag.split("fill=\"").nth(1).unwrap().split('"').next().unwrap().to_owned()
    };
    assert_eq!((colour("low").as_str(), colour("high").as_str()), ("#FFFFFF", "#222222"));
    assert!(!svg.contains("nowhere"));
}
