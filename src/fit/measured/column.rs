//! The header of a file of samples: which column holds what.

use super::{DataError, Unit};

/// What a column holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Role {
    Angle(Unit),
    /// An angle whose name says no unit.
    Unitless,
    Value,
    Weight,
    Sigma,
}

/// Names, the first of a role the one that is written; letters' case does not count.
const NAMES: [(Role, &[&str]); 8] = [
    (
        Role::Angle(Unit::Degrees),
        &["theta_deg", "angle_deg", "theta_degrees", "angle_degrees", "degrees", "deg"],
    ),
    (
        Role::Angle(Unit::Radians),
        &["theta_rad", "angle_rad", "theta_radians", "angle_radians", "radians", "rad"],
    ),
    (Role::Angle(Unit::Cosine), &["cos_theta", "cosine", "cos"]),
    (Role::Angle(Unit::Versine), &["one_minus_cos", "versine"]),
    (Role::Unitless, &["theta", "angle"]),
    (Role::Value, &["value", "intensity", "radiance", "reflectance"]),
    (Role::Weight, &["weight"]),
    (Role::Sigma, &["sigma", "std"]),
];

/// What [`DataError`] says is known.
pub(super) const KNOWN: &str =
    "known are theta_deg, theta_rad, cos_theta or one_minus_cos; value; weight or sigma";

/// A column's place and its name as the file has it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Column {
    pub(super) at: usize,
    pub(super) name: String,
}

/// The columns of one file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Columns {
    pub(super) count: usize,
    pub(super) delimiter: char,
    pub(super) unit: Unit,
    pub(super) angle: Column,
    pub(super) value: Column,
    pub(super) weight: Option<Column>,
    pub(super) sigma: Option<Column>,
}

/// The fields of a line, spaces and one pair of quotes around each taken off.
pub(super) fn fields(line: &str, delimiter: char) -> impl Iterator<Item = &str> {
    line.split(delimiter).map(|field| {
        let field = field.trim();
        let inner = field.strip_prefix('"').and_then(|field| field.strip_suffix('"'));
        inner.map_or(field, str::trim)
    })
}

/// A file's own words in a message: one line, not too long, a terminal's escapes shown and not sent.
pub(super) fn shown(text: &str) -> String {
    const MOST: usize = 40;
    let show = |c: char| if c.is_control() { c.escape_default().to_string() } else { c.to_string() };
    let mut shown: String = text.chars().take(MOST).map(show).collect();
    if text.chars().nth(MOST).is_some() {
        shown.push('…');
    }
    shown
}

impl Columns {
    /// Reads the header; `unit` is that of an angle whose column says none.
    pub(super) fn parse(row: usize, line: &str, unit: Option<Unit>) -> Result<Self, DataError> {
        // The first of these that the header has; a comma inside numbers is told where it is met.
        let delimiter = ['\t', ';', ','].into_iter().find(|&c| line.contains(c)).unwrap_or(',');
        let mut names: Vec<&str> = fields(line, delimiter).collect();
        if names.len() > 1 && names.last() == Some(&"") {
            names.pop();
        }
        if names.iter().all(|name| name.parse::<f64>().is_ok()) {
            return Err(DataError::NoHeader { row, found: shown(line.trim()) });
        }
        let (mut angle, mut value, mut weight, mut sigma) = (None, None, None, None);
        for (at, name) in names.iter().enumerate() {
            let lower = name.to_ascii_lowercase();
            let Some((role, _)) = NAMES.iter().find(|(_, known)| known.contains(&lower.as_str())) else {
                return Err(DataError::UnknownColumn { row, name: shown(name) });
            };
            let column = Column { at, name: shown(name) };
            let twice = |first: &Column| DataError::ColumnTwice {
                row,
                first: first.name.clone(),
                second: column.name.clone(),
            };
            let place = match role {
                Role::Angle(_) | Role::Unitless => &mut angle,
                Role::Value => &mut value,
                Role::Weight => &mut weight,
                Role::Sigma => &mut sigma,
            };
            if let Some((_, first)) = place {
                return Err(twice(first));
            }
            *place = Some((*role, column));
        }
        if let (Some((_, first)), Some((_, second))) = (&weight, &sigma) {
            let (first, second) = (first.name.clone(), second.name.clone());
            return Err(DataError::ColumnTwice { row, first, second });
        }
        let missing = |what| DataError::NoColumn { row, what };
        let (role, angle) = angle.ok_or_else(|| missing("angle"))?;
        let unit = match (role, unit) {
            (Role::Angle(named), Some(asked)) if named != asked => {
                return Err(DataError::UnitTwice { row, name: angle.name, asked: asked.id() });
            }
            (Role::Angle(named), _) => named,
            (_, Some(asked)) => asked,
            (_, None) => return Err(DataError::NoUnit { row, name: angle.name }),
        };
        let (_, value) = value.ok_or_else(|| missing("value"))?;
        let only = |found: Option<(Role, Column)>| found.map(|(_, column)| column);
        Ok(Columns {
            count: names.len(),
            delimiter,
            unit,
            angle,
            value,
            weight: only(weight),
            sigma: only(sigma),
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_name_is_known_once_and_the_message_has_the_first_of_each() {
        let all: Vec<&str> = NAMES.iter().flat_map(|(_, names)| names.iter().copied()).collect();
        for (i, name) in all.iter().enumerate() {
            assert!(!all[..i].contains(name), "{name}");
        }
        for (role, names) in NAMES {
            let is_told = KNOWN.split([' ', ',', ';']).any(|word| word == names[0]);
            assert_eq!(is_told, role != Role::Unitless, "{}", names[0]);
            if let Role::Angle(unit) = role {
                assert_eq!(names[0], unit.column());
            }
        }
    }

    #[test]
    fn a_unit_is_told_once_or_twice_alike() {
        let header = |line, unit| Columns::parse(1, line, unit).map(|columns| columns.unit);
        assert_eq!(header("theta_deg,value", None).unwrap(), Unit::Degrees);
        assert_eq!(header("theta_deg,value", Some(Unit::Degrees)).unwrap(), Unit::Degrees);
        let twice = header("theta_deg,value", Some(Unit::Radians));
        assert!(matches!(twice, Err(DataError::UnitTwice { row: 1, .. })), "{twice:?}");
    }

    #[test]
    fn a_header_in_three_delimiters() {
        for delimiter in [',', ';', '\t'] {
            let line = format!(" Weight {delimiter}\"theta_deg\"{delimiter} VALUE");
            let columns = Columns::parse(1, &line, None).unwrap();
            assert_eq!((columns.angle.at, columns.value.at, columns.delimiter), (1, 2, delimiter));
            assert_eq!(columns.weight.unwrap().name, "Weight");
        }
        assert_eq!(shown("a\u{1b}[1m"), "a\\u{1b}[1m");
    }
}
