//! Factors, footprints and weights against the kernels in double precision.

use crate::adapter::Adapter;
use crate::lobes::EPSILON;
use crate::measure::Measure;
use bellfit::bound::Format;
use bellfit::kernel::exact::cs_16_factor_exact;
use bellfit::kernel::factor::{cos_n_factor, cs_16_factor_one_sided, cubic_factor};
use bellfit::kernel::model::{LobeAngle, Model};
use bellfit::kernel::pixel::{Footprint, Jacobian, Padding, PaperReading, PixelWeight};
use bellfit::kernel::real::Real;
use bellfit::kernel::stand_in::StandIn;
use bellfit::shader::{Language, Piece, emit};

fn code(piece: Piece) -> String {
    emit(&[piece], Format::Single, Language::Wgsl).expect("WGSL has it")
}

pub fn factors(adapter: &Adapter) -> usize {
    let mut count = 0;
    for model in Model::ALL {
        let id = model.id().replace('-', "_");
        let edge = if model.angle() == LobeAngle::Half { 54.7 } else { 16.0 };
        let line = move |n| cs_16_factor_one_sided::<f64>(model).at(n);
        // A division of 2.5 ulp and the roundings of the line, in ε; 10.29 of the exact form and two divisions;
        // two divisions more and two sums; exp2 of (3 + n) ulp, beside n, and a division.
        let cases: [(StandIn, String, f32, f64, Box<dyn Fn(f64) -> f64>); 4] = [
            (StandIn::Cs16, format!("cs_16_factor_line_{id}"), 16.0, 5.0, Box::new(line)),
            (
                StandIn::Cs16,
                format!("cs_16_factor_exact_{id}"),
                edge,
                15.0,
                Box::new(move |n| cs_16_factor_exact(model, n)),
            ),
            (
                StandIn::Cubic4,
                format!("cubic_4_factor_{id}"),
                16.0,
                10.0,
                Box::new(move |n| cubic_factor::<4, f64>(model, n)),
            ),
            (
                StandIn::Power,
                format!("cos_n_factor_{id}"),
                16.0,
                10.0,
                Box::new(move |n| cos_n_factor(model, n)),
            ),
        ];
        for (stand_in, name, from, times, kernel) in cases {
            let rows: Vec<[f32; 1]> =
                (0..=65_535).map(|i| [from + (1024.0 - from) * i as f32 / 65_535.0]).collect();
            let found = adapter.run(
                &code(Piece::Factor { model, stand_in, nudge: 0.0 }),
                &format!("{name}(x0)"),
                &rows,
            );
            let mut measure = Measure::new(name);
            for (row, found) in rows.iter().zip(found) {
                let value = kernel(f64::from(row[0]));
                measure.add(row, found, value, times * EPSILON * value);
            }
            count += measure.report();
        }
    }
    count
}

/// Splitmix64: the same numbers in every run.
struct Draw(u64);

impl Draw {
    fn real(&mut self, lo: f64, hi: f64) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        lo + (hi - lo) * ((z ^ (z >> 31)) >> 11) as f64 / (1_u64 << 53) as f64
    }
}

/// Aspect of the ellipse of M from its trace and determinant.
fn aspect(f: &Footprint<f64>) -> f64 {
    let half = 0.5 * (f.uu + f.vv);
    let major = half + (half * half - f.determinant).max(0.0).sqrt();
    major / f.determinant.sqrt() // a/b = a²/(a b)
}

/// Q of points that lie about the ellipse of drawn Jacobians, of aspects up to thousands, and of lines.
pub fn footprints(adapter: &Adapter) -> usize {
    let mut count = 0;
    for (name, padding) in [("footprint_plain", Padding::Plain), ("footprint_padded", Padding::Padded)] {
        let mut draw = Draw(5);
        let mut rows: Vec<[f32; 6]> = Vec::new();
        for _ in 0..131_072 {
            let size = Real::exp2(draw.real(-6.0, 8.0));
            let j = [(); 4].map(|()| (size * draw.real(-1.0, 1.0)) as f32);
            let [r, angle] = [draw.real(0.0, 1.1), draw.real(0.0, 6.3)];
            let (x, y) = (r * Real::cos(angle), r * Real::sin(angle));
            let [ux, vx, uy, vy] = j.map(f64::from);
            rows.push([j[0], j[1], j[2], j[3], (ux * x + uy * y) as f32, (vx * x + vy * y) as f32]);
        }
        // Lines and points: parallel columns in whole numbers, whose products are exact.
        let lines = [
            [2.0, 4.0, 1.0, 2.0],
            [0.0; 4],
            [5.0, 0.0, 0.0, 0.0],
            [0.0, 3.0, 0.0, 1.0],
            [3.0, -6.0, -1.0, 2.0],
        ];
        rows.extend(lines.map(|[ux, vx, uy, vy]| [ux, vx, uy, vy, 1.0, 0.5]));
        let expression = format!("footprint_q({name}(x0, x1, x2, x3), x4, x5)");
        let found = adapter.run(&code(Piece::Footprint), &expression, &rows);
        let mut measure = Measure::new(expression);
        for (row, found) in rows.iter().zip(found) {
            let [ux, vx, uy, vy, u, v] = row.map(f64::from);
            let footprint = Footprint::of(Jacobian { ux, vx, uy, vy }, padding);
            let q = footprint.q(u, v);
            if q == f64::INFINITY {
                assert_eq!(found, 1e9, "{row:?}");
                continue;
            }
            // As the comment states: 16 u times the aspect, and as much again for det J, u = ε/2.
            measure.add(row, found, q, 16.0 * EPSILON * aspect(&footprint) * q.max(1.0));
        }
        count += measure.report();
    }
    count
}

pub fn weights(adapter: &Adapter) -> usize {
    let sigma = 1.0 / 3.0;
    let mut cases = vec![(PixelWeight::Gaussian(sigma), "gaussian_weight".to_owned())];
    cases.push((PixelWeight::Box, "box_weight".to_owned()));
    for (i, reading) in PaperReading::ALL.into_iter().enumerate() {
        cases.push((PixelWeight::Paper(reading), format!("paper_r{}_weight", i + 1)));
        cases.push((PixelWeight::PaperProduct(reading), format!("paper_r{}_weight_product", i + 1)));
    }
    for k in [2, 4, 8, 16, 32, 64] {
        cases.push((PixelWeight::Bell(k, sigma), format!("bell_{k}_weight")));
    }
    for k in [2, 4, 8] {
        cases.push((PixelWeight::Cubic(k, sigma), format!("cubic_{k}_weight")));
    }
    let mut count = 0;
    for (weight, name) in cases {
        let arguments = if weight.is_radial() { "x0" } else { "x0, x1" };
        let mut draw = Draw(9);
        let other = |draw: &mut Draw| if weight.is_radial() { 0.0 } else { draw.real(0.0, 2.0) as f32 };
        let mut rows: Vec<[f32; 2]> = Vec::new();
        for i in 0..=65_535 {
            rows.push([i as f32 / 8192.0, other(&mut draw)]);
        }
        for e in -126..30 {
            rows.push([2.0_f32.powi(e), other(&mut draw)]);
        }
        let found = adapter.run(&code(Piece::Weight(weight)), &format!("{name}({arguments})"), &rows);
        let mut measure = Measure::new(name);
        for (row, found) in rows.iter().zip(found) {
            let [a, b] = row.map(f64::from);
            let value = weight.at(a, b);
            let allowed = match weight {
                PixelWeight::Box => 0.0,
                // exp's (3 + 2 |x|) ulp and two roundings of its argument
                PixelWeight::Gaussian(_) => (3.0 + 4.0 * 4.5 * a) * EPSILON * value,
                // ε/2 a rounding: the factor of Q, the product, the difference, the cubic's, K p^(K - 1) times;
                // and K - 1 halves of the squarings.
                PixelWeight::Paper(_) | PixelWeight::PaperProduct(_) => 16.0 * EPSILON,
                PixelWeight::Bell(k, _) | PixelWeight::Cubic(k, _) => (f64::from(k) + 8.0) * EPSILON,
            };
            measure.add(row, found, value, allowed);
        }
        count += measure.report();
    }
    count
}
