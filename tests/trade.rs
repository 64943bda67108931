//! Speed against accuracy: the frontier's laws, statistics, records, and what a small measurement says.
//! Nothing here depends on how fast anything is.
#![cfg(feature = "toolkit")]
#![allow(clippy::unwrap_used)] // helpers of tests may panic as tests do

#[path = "support/draw.rs"]
mod draw;

use bellfit::bound::Format;
use bellfit::kernel::stand_in::StandIn;
use bellfit::report::{trade_files, trade_lines};
use bellfit::trade::{Place, Plan, Record, Spread, Subject, TradeError, frontier, measure, proven};
use draw::Draw;
use std::sync::OnceLock;

const FORMATS: [Format; 2] = [Format::Single, Format::Double];

/// As small as it can be; what it says of errors is whole, what it says of times next to nothing.
fn small() -> Plan {
    Plan { rounds: 3, sample: 0.0, elements: 64, memory: 1 << 14, window: 512, ..Plan::quick(64) }
}

/// One small measurement for all tests.
fn record() -> &'static Record {
    static RECORD: OnceLock<Record> = OnceLock::new();
    RECORD.get_or_init(|| measure(&small(), &|_| ()).unwrap())
}

fn beats(a: (f64, f64), b: (f64, f64)) -> bool {
    a.0 <= b.0 && a.1 <= b.1 && a != b
}

#[test]
fn the_frontier_is_what_no_point_beats() {
    let mut draw = Draw(0x5eed_0001);
    for size in 0..60 {
        // Few levels, so that ties of one and both coordinates come up.
        let levels = 1 + draw.below(12);
        let mut level = || draw.below(levels) as f64;
        let points: Vec<(f64, f64)> = (0..size).map(|_| (level(), level())).collect();
        let found = frontier(&points);
        for i in 0..size {
            let beaten = points.iter().any(|&other| beats(other, points[i]));
            assert_eq!(found.contains(&i), !beaten, "{i} of {points:?}");
        }
        assert!(found.windows(2).all(|w| points[w[0]].0 <= points[w[1]].0), "{points:?}");
    }
    let nan = f64::NAN;
    assert_eq!(frontier(&[(nan, 0.0), (1.0, nan), (2.0, 2.0)]), [2]);
    assert!(frontier(&[]).is_empty());
}

#[test]
fn the_median_has_as_many_on_either_side() {
    let mut draw = Draw(0x5eed_0002);
    for count in 1..40 {
        let values: Vec<f64> = (0..count).map(|_| draw.real(1.0, 2.0)).collect();
        let Spread { median, least, most } = Spread::of(&values).unwrap();
        let below = values.iter().filter(|&&x| x < median).count();
        let above = values.iter().filter(|&&x| x > median).count();
        assert_eq!(below, above, "{values:?}");
        assert!(values.contains(&least) && values.iter().all(|&x| x >= least));
        assert!(values.contains(&most) && values.iter().all(|&x| x <= most));
    }
    assert_eq!(Spread::of(&[]), None);
    assert_eq!(Spread::of(&[1.0, f64::NAN]), None);
    assert_eq!(Spread::of(&[1.0, f64::INFINITY]), None);
    // One disturbance of nine leaves the median alone.
    let disturbed = Spread::of(&[1.0, 1.0, 1.0, 1.0, 50.0, 1.0, 1.0, 1.0, 1.0]).unwrap();
    assert_eq!((disturbed.median, disturbed.most, disturbed.wander()), (1.0, 50.0, 1.0));
    let rounded = Spread { median: 1.23456, least: 0.000_123_456, most: 98_765.4 }.rounded();
    assert_eq!(rounded, Spread { median: 1.235, least: 0.000_123_5, most: 98_770.0 });
}

#[test]
fn everything_is_measured_once() {
    let record = record();
    assert_eq!(record.rows.len(), Subject::all().count() * 6);
    for format in FORMATS {
        for place in Place::ALL {
            for subject in Subject::all() {
                let row = record.row(subject, format, place).unwrap();
                let Spread { median, least, most } = row.time;
                assert!(0.0 < least && least <= median && median <= most, "{row:?}");
                assert_eq!(row.cost, subject.cost(record.n));
            }
            assert!(record.floor(format, place).is_some());
        }
        for stand_in in StandIn::ALL {
            let row = record.row(Subject::StandIn(stand_in), format, Place::Cache).unwrap();
            assert_eq!(record.cost(stand_in, format), Some(row.time.median));
        }
    }
    assert_eq!(record.cost(StandIn::Cs16, Format::Half), None);
}

/// What is measured stays below what is proved, and comes near it.
#[test]
fn measured_errors_are_below_proved_ones() {
    for row in &record().rows {
        let Some(bound) = row.proven.approximation else { continue };
        let u = row.format.unit_roundoff();
        // A bell's sum (1 - s) + s c is off by 2 u n/T at most, and its slope is at most T: with c itself
        // exact and the few roundings of the powers 4 u n is generous.
        let rounding = row.proven.rounding.unwrap_or(4.0 * 64.0 * u);
        let (id, measured) = (row.subject.id(), row.sup_error);
        assert!(measured <= bound + rounding, "{id}: {measured} over {bound} + {rounding}");
        // A stand-in's is enclosed to 2e-3 of it; by sup|f″|, where the samples are coarse (64 over cos θ: 0.127
        // against 0.080), a table's is not more than 2.1 times too large; what e⁻¹⁶ and the roundings add shows
        // where the rest is small.
        let most = if id.starts_with("table") { 2.1 } else { 1.002 };
        assert!(bound <= most * measured + 2e-7 + rounding, "{id}: {bound} for {measured}");
    }
}

/// Against what is known otherwise.
#[test]
fn errors_are_the_known_ones() {
    let record = record();
    let error =
        |id: &str, format, place| record.row(Subject::from_id(id).unwrap(), format, place).unwrap().sup_error;
    for place in Place::ALL {
        // The lobe at n = 64 by the definition: max over t of (1 - t/64)^64 - (1 - t/16)^16, by calculus at
        // (1 - t/64)^63 = (1 - t/16)^15.
        let f = |t: f64| libm::pow(1.0 - t / 64.0, 64.0) - libm::pow(1.0 - t / 16.0, 16.0);
        let slope = |t: f64| libm::pow(1.0 - t / 16.0, 15.0) - libm::pow(1.0 - t / 64.0, 63.0);
        let (mut lo, mut hi) = (0.5, 4.0);
        assert!(slope(lo) > 0.0 && slope(hi) < 0.0);
        for _ in 0..50 {
            let mid = 0.5 * (lo + hi);
            if slope(mid) > 0.0 { lo = mid } else { hi = mid }
        }
        let known = f(lo);
        // Samples are 5e-4 apart in t, at a maximum.
        assert!((error("cs-16", Format::Double, place) - known).abs() < 1e-7, "{known}");
        assert!((error("cs-16", Format::Single, place) - known).abs() < 1e-5, "{known}");
        for format in FORMATS {
            // The usual platforms' powers are within an ulp, which is u below 1; four for a worse one. And no
            // power of 65536 arguments is right to a tenth of an ulp.
            let u = format.unit_roundoff();
            assert!((0.1 * u..4.0 * u).contains(&error("powf", format, place)));
            // (n - 1) u of binary powering, c exact.
            assert!((0.1 * u..63.0 * u).contains(&error("squarings", format, place)));
        }
        // Schlick's at n = 64: its tail stays, 1/(1 + t) against e⁻ᵗ.
        assert!((0.19..0.21).contains(&error("schlick", Format::Double, place)));
        // Twice the samples but one, a fourth of the error.
        let tables = ["table-t-linear-64", "table-t-linear-256", "table-t-linear-1024"];
        let [a, b, c] = tables.map(|id| error(id, Format::Double, place));
        assert!((a / b - 16.0).abs() < 1.5 && (b / c - 16.0).abs() < 0.6, "{a} {b} {c}");
    }
}

#[test]
fn bounds_at_other_exponents_hold() {
    // cs_16 at 16 is cosⁿ itself; its error rises with n towards Lyon's 1.7277e-2.
    let cs_16 = |n| proven(Subject::StandIn(StandIn::Cs16), n, Format::Single).approximation.unwrap();
    assert_eq!(cs_16(16), 0.0);
    assert!((1.72e-2..1.7277e-2).contains(&cs_16(65536)), "{}", cs_16(65536));
    // Of the cubics the sup over n ≥ 16 is what fits/kernels-cosn.csv states; from 64 on it is no larger.
    let table = std::fs::read_to_string("fits/kernels-cosn.csv").unwrap();
    let mut reader = csv::Reader::from_reader(table.as_bytes());
    let header = reader.headers().unwrap().clone();
    let column = |name: &str| header.iter().position(|h| h == name).unwrap();
    let rows: Vec<csv::StringRecord> = reader.records().map(Result::unwrap).collect();
    for (stand_in, power) in [(StandIn::Cubic2, "2"), (StandIn::Cubic4, "4"), (StandIn::Cubic8, "8")] {
        let cubic =
            |row: &&csv::StringRecord| &row[column("power")] == power && &row[column("degree")] == "3";
        let stated: f64 = rows.iter().find(cubic).unwrap()[column("max_error")].parse().unwrap();
        let found = proven(Subject::StandIn(stand_in), 64, Format::Double).approximation.unwrap();
        assert!(found <= 1.003 * stated && found > 0.3 * stated, "{power}: {found} of {stated}");
    }
}

#[test]
fn a_record_comes_back_as_it_went() {
    let record = record();
    let text = record.json().unwrap();
    assert_eq!(Record::parse(&text).as_ref(), Ok(record));
    let value: serde_json::Value = serde_json::from_str(&text).unwrap();
    assert_eq!(value["version"], 1);
    let row = &value["rows"][0];
    assert_eq!(
        (&row["subject"], &row["format"], &row["place"]),
        (&"cs-16".into(), &"f32".into(), &"single".into())
    );
    assert!(row["nanoseconds"].is_f64() && row["operations"] == 6);
}

#[test]
fn bad_records_are_told_with_their_place() {
    let text = record().json().unwrap();
    let said = |text: &str| Record::parse(text).unwrap_err().to_string();
    let with = |from: &str, to: &str| {
        assert!(text.contains(from), "{from}");
        said(&text.replacen(from, to, 1))
    };
    let line_of = |what: &str| text.lines().position(|line| line.contains(what)).unwrap() + 1;
    assert_eq!(said(""), "line 1, column 0: EOF while parsing a value");
    assert_eq!(with("\"version\": 1", "\"version\": 2"), "version 2 of a trade record, where 1 is known");
    assert_eq!(with("\"n\": 64", "\"n\": 7"), "n = 7 is not in 16..=65536");
    let unknown = with("\"rounds\"", "\"round\"");
    let line = line_of("\"rounds\"");
    assert!(unknown.starts_with(&format!("line {line}, column ")), "{unknown}");
    assert!(unknown.contains("unknown field `round`"), "{unknown}");
    for (from, to, names) in [
        ("\"cs-16\"", "\"cs-17\"", "subject \"cs-17\""),
        ("\"f64\"", "\"f16\"", "format \"f16\", where f32 and f64 are known"),
        ("\"memory\",", "\"disk\",", "place \"disk\""),
        ("\"nanoseconds\": ", "\"nanoseconds\": -", "0 < least <= nanoseconds <= most"),
        ("\"sup_error\": ", "\"sup_error\": -", "0 <= mean_error <= sup_error"),
        ("\"bound\": 0.", "\"bound\": -0.", "is below 0"),
        ("\"sup_at\": 0.", "\"sup_at\": 7.", "is no cosine"),
    ] {
        let error = with(from, to);
        assert!(error.starts_with("line ") && error.contains(names), "{error}");
    }
    // The same row again.
    let (rows, row) = text.split_once("\"rows\": [").unwrap();
    let first = row.split_once("},").unwrap().0;
    let twice = format!("{rows}\"rows\": [{first}}},{row}");
    assert_eq!(said(&twice), "two rows for cs-16, f32, single");
    for cut in [text.len() / 4, text.len() / 2, text.len() - 3] {
        assert!(matches!(Record::parse(&text[..cut]), Err(TradeError::Text { .. })));
    }
}

#[test]
fn plans_outside_their_domain_are_refused() {
    let said = |plan: Plan| measure(&plan, &|_| ()).unwrap_err().to_string();
    assert_eq!(said(Plan { n: 15, ..small() }), "n = 15 is not in 16..=65536");
    assert_eq!(said(Plan { n: 65_537, ..small() }), "n = 65537 is not in 16..=65536");
    assert_eq!(said(Plan { rounds: 0, ..small() }), "rounds = 0 is not 1 or more");
    assert_eq!(said(Plan { elements: 0, ..small() }), "elements = 0 is not 1 or more");
    assert_eq!(said(Plan { window: 0, ..small() }), "window = 0 is not 1 or more");
    assert!(said(Plan { memory: 64, ..small() }).contains("8 bytes or more for each element of a window"));
    assert!(said(Plan { sample: f64::NAN, ..small() }).starts_with("sample = NaN"));
    assert!(said(Plan { sample: -1.0, ..small() }).starts_with("sample = -1"));
}

/// A record with made-up times: what the words say follows from the numbers alone.
#[test]
fn the_words_are_the_record_s() {
    let mut record = record().clone();
    record.machine.processor = "Made Up 3000".to_owned();
    record.reference = Spread { median: 100.0, least: 99.0, most: 101.0 };
    for row in &mut record.rows {
        let time = match row.subject.id().as_str() {
            "cubic-4" => 0.1,
            "cs-16" => 0.2,
            "pow" => 0.5,
            "powf" => 20.0,
            _ => 50.0,
        };
        row.time = Spread { median: time, least: time, most: time };
        row.sup_error = match row.subject.id().as_str() {
            "cubic-4" => 4e-4,
            "pow" => 2e-8,
            "powf" => 6e-8,
            "cs-16" => 1.3e-2,
            _ => 0.5,
        };
    }
    for floor in &mut record.floors {
        floor.time = Spread { median: 0.095, least: 0.095, most: 0.095 };
    }
    let text = trade_lines(&record);
    let words =
        text.split_once("f32, slice in cache").unwrap().1.split_once("f32, slice in memory").unwrap().0;
    let lines: Vec<&str> = words.trim().lines().map(str::trim).collect();
    assert!(lines[0].starts_with("On the frontier: cubic-4 (0.100 ns, error 4.0e-4, proved "), "{words}");
    assert!(lines[0].ends_with("; pow (0.500 ns, error 2.0e-8)."), "{words}");
    assert!(
        lines[1].contains("powf (20.0 ns, error 6.0e-8) by pow, 40 times as fast and 3.0 times as accurate"),
        "{words}"
    );
    assert!(lines[1].contains(" by cubic-4, 2.0 times as fast and 32 times as accurate"), "{words}");
    assert!(
        lines[2].ends_with("within a tenth of it, so that their own time is not told: cubic-4."),
        "{words}"
    );
    assert!(text.contains("The machine was quiet") && text.contains("a spread of 2.0 %"), "{text}");
    record.reference.least = 60.0;
    assert!(trade_lines(&record).contains("The machine was noisy"));
    // The files: all numbers as a table, the record itself, a page and the plot with the machine's name.
    let files = trade_files(&record).unwrap();
    let file = |name: &str| files.files().find(|(path, _)| *path == name).unwrap().1;
    let table = file("trade-made-up-3000.csv");
    assert_eq!(csv::Reader::from_reader(table).records().map(Result::unwrap).count(), record.rows.len());
    let json = std::str::from_utf8(file("trade-made-up-3000.json")).unwrap();
    assert_eq!(Record::parse(json).unwrap(), record);
    let plot = std::str::from_utf8(file("trade.svg")).unwrap();
    assert!(plot.contains("Made Up 3000") && plot.contains("cubic-4"));
    let page = std::str::from_utf8(file("trade.md")).unwrap();
    assert!(page.contains("Made Up 3000") && page.contains("**0.100 (0.100 to 0.100)**"));
    assert_eq!(files.files().count(), 5);
    // The same record, the same bytes.
    assert_eq!(trade_files(&record).unwrap(), files);
}

/// The record that the report links to can be read.
#[test]
fn the_committed_records_can_be_read() {
    let mut count = 0;
    for entry in std::fs::read_dir("reports/measured").unwrap() {
        let path = entry.unwrap().path();
        let name = path.file_name().unwrap().to_str().unwrap().to_owned();
        if name.starts_with("trade-") && name.ends_with(".json") {
            let record = Record::parse(&std::fs::read_to_string(&path).unwrap()).unwrap();
            assert!(record.rounds >= 9 && record.rows.len() == Subject::all().count() * 6, "{name}");
            count += 1;
        }
    }
    assert!(count > 0);
}
