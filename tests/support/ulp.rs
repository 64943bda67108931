//! The rows of tests/references/slices.csv, and errors in units in the last place.
#![allow(dead_code)] // every file uses its part

/// A function's value beyond double precision: `value` + `rest`.
pub struct Row {
    /// 32 or 64.
    pub width: u32,
    /// `cosine`, `versine` or `exp`.
    pub function: String,
    pub x: f64,
    pub n: f64,
    pub value: f64,
    pub rest: f64,
}

pub fn references() -> Vec<Row> {
    let path = format!("{}/tests/references/slices.csv", env!("CARGO_MANIFEST_DIR"));
    let text = std::fs::read_to_string(&path).unwrap_or_else(|e| panic!("{path}: {e}"));
    let row = |line: &str| {
        let fields: Vec<&str> = line.split(',').collect();
        let number = |i: usize| fields[i].parse().unwrap_or_else(|e| panic!("{line}: {e}"));
        Row {
            width: number(0) as u32,
            function: fields[1].to_owned(),
            x: number(2),
            n: number(3),
            value: number(4),
            rest: number(5),
        }
    };
    text.lines().skip(1).map(row).collect()
}

impl Row {
    /// Whether the value is a normal number of its type.
    pub fn is_normal(&self) -> bool {
        self.value >= if self.width == 32 { f64::from(f32::MIN_POSITIVE) } else { f64::MIN_POSITIVE }
    }

    /// |x - the true value| in ulp of the true value's binade, the least subnormal number below; infinite for
    /// what is not finite.
    pub fn ulps(&self, x: f64) -> f64 {
        let (digits, least) = if self.width == 32 { (23, -126) } else { (52, -1022) };
        let exponent = if self.value == 0.0 { least } else { libm::ilogb(self.value).max(least) };
        let error = (x - self.value) - self.rest;
        // Scaled up first: an ulp may be the least double.
        let error = libm::scalbn(libm::scalbn(error, 60).abs(), digits - exponent - 60);
        if error.is_nan() { f64::INFINITY } else { error }
    }
}
