use super::ChartError;

/// How an axis maps values to lengths.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Scale {
    /// Equal differences, equal lengths.
    #[default]
    Linear,
    /// Equal ratios, equal lengths; ticks at powers of two.
    Log2,
    /// Equal ratios, equal lengths; ticks at powers of ten.
    Log10,
}

impl Scale {
    // Not plotters' own logarithmic axes: theirs are std's logarithms, whose bits differ between machines.
    fn of(self, value: f64) -> f64 {
        match self {
            Self::Linear => value,
            Self::Log2 => libm::log2(value),
            Self::Log10 => libm::log10(value),
        }
    }
}

/// One axis of a chart.
#[derive(Clone, Debug, PartialEq)]
pub struct Axis {
    /// What is measured, with its unit.
    pub label: String,
    /// How values map to lengths.
    pub scale: Scale,
    /// The values at the two ends; the first is the smaller.
    pub range: (f64, f64),
    /// Ticks as value and label; empty: chosen, at round numbers. Those outside the range are left out.
    pub ticks: Vec<(f64, String)>,
}

impl Axis {
    /// An axis with ticks at round numbers.
    #[must_use]
    pub fn new(label: impl Into<String>, scale: Scale, range: (f64, f64)) -> Self {
        Self { label: label.into(), scale, range, ticks: Vec::new() }
    }

    /// The middles of `count` cells of equal length on the axis, from its first end on: where a heat
    /// map takes its values.
    ///
    /// # Errors
    ///
    /// Where the range cannot be drawn.
    pub fn centres(&self, count: usize) -> Result<Vec<f64>, ChartError> {
        let Span { from, to, .. } = self.span()?;
        let value = |i: usize| {
            let at = from + (to - from) * (i as f64 + 0.5) / count as f64;
            match self.scale {
                Scale::Linear => at,
                Scale::Log2 => libm::exp2(at),
                Scale::Log10 => libm::exp10(at),
            }
        };
        Ok((0..count).map(value).collect())
    }

    /// The axis' map to [0, 1], if its range can be drawn.
    pub(super) fn span(&self) -> Result<Span, ChartError> {
        let (lo, hi) = self.range;
        let axis = self.label.clone();
        // A difference that overflows is as undrawable as an infinite end.
        if !(lo < hi && (hi - lo).is_finite()) {
            return Err(ChartError::Range { axis, lo, hi });
        }
        if self.scale != Scale::Linear && lo <= 0.0 {
            return Err(ChartError::LogRange { axis, lo, hi });
        }
        let (from, to) = (self.scale.of(lo), self.scale.of(hi));
        // Neighbouring floats can have equal logarithms.
        if from < to {
            Ok(Span { scale: self.scale, from, to })
        } else {
            Err(ChartError::Range { axis, lo, hi })
        }
    }
}

/// A checked range: maps its ends to 0 and 1.
#[derive(Clone, Copy, Debug)]
pub(super) struct Span {
    scale: Scale,
    from: f64,
    to: f64,
}

impl Span {
    /// Far outside the frame; keeps the differences of positions finite.
    const FAR: f64 = 1e9;

    /// Where the value lies: in [0, 1] inside the range, none where the scale has no place for it.
    pub(super) fn place(&self, value: f64) -> Option<f64> {
        let at = (self.scale.of(value) - self.from) / (self.to - self.from);
        (value.is_finite() && !at.is_nan() && self.scale.of(value).is_finite())
            .then(|| at.clamp(-Self::FAR, Self::FAR))
    }

    /// As [`Span::place`], for an end of a band: infinite values, and those below a logarithm's domain,
    /// lie beyond the frame.
    pub(super) fn place_end(&self, value: f64) -> f64 {
        match self.place(value) {
            Some(at) => at.clamp(0.0, 1.0),
            None => f64::from(u8::from(value > 0.0)),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{Axis, Scale};

    #[test]
    fn cells_have_their_centres_on_the_axis_scale() {
        assert_eq!(Axis::new("", Scale::Linear, (0.0, 4.0)).centres(4).unwrap(), [0.5, 1.5, 2.5, 3.5]);
        assert_eq!(Axis::new("", Scale::Log2, (1.0, 16.0)).centres(2).unwrap(), [2.0, 8.0]);
    }

    #[test]
    fn values_without_a_place_have_none() {
        let span = Axis::new("", Scale::Log10, (1.0, 100.0)).span().unwrap();
        assert_eq!(span.place(10.0), Some(0.5));
        assert!([0.0, -1.0, f64::NAN, f64::INFINITY].iter().all(|&v| span.place(v).is_none()));
        assert_eq!([0.0, -1.0, f64::INFINITY].map(|v| span.place_end(v)), [0.0, 0.0, 1.0]);
    }
}
