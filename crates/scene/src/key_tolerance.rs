//! Tolerances of keys: a number as a drawing has it, `"27 um +- 3 um"` or `"24 um .. 30 um"`.
//!
//! A scene holds the nominal number, which is the middle of a range, and the list of all tolerances beside. Keys of
//! numerics, limits and whole numbers have none.

use std::ops::Range;

use crate::bounds::Bounds;
use crate::complaint::Complaints;
use crate::criteria::SHARED;
use crate::keys::Key;
use crate::unit::{self, Dimension};
use crate::{Check, Complaint, Scene, SceneError};

/// How a tolerance is written, in a message.
const EXAMPLES: &str = "\"27 um +- 3 um\", \"27 +- 3 um\", \"27 um +- 10 %\" or \"24 um .. 30 um\"";
/// Signs between a number and its half width.
const SIGNS: [&str; 3] = ["+-", "\u{b1}", "+/-"];
/// The sign between the ends of a range.
const RANGE: &str = "..";
/// Whole numbers whose rows list them.
const COUNTS: [&str; 2] = ["cap.bolts.count", "load.harmonics.order"];
/// Tables whose numbers have no tolerance, and why.
const EXACT: [(&str, &str); 6] = [
    ("mesh", "is a choice of the mesh, and no dimension of the bearing"),
    ("orbit", "is a choice of the method, and no dimension of the bearing"),
    ("criteria", "is a limit, with which answers are compared"),
    ("limits", "is a limit, with which answers are compared"),
    ("sweep", "is the value of an axis, which a sweep takes as it is"),
    ("crankshaft", "stands in a scene of a crankshaft, and only single bearings have tolerances"),
];

/// The tolerance of one key: its number lies within the half width of the nominal one.
#[derive(Debug, Clone, PartialEq)]
pub struct KeyTolerance {
    /// The key with its tables, as an axis of a sweep names it: `feed.feed_hole.pressure`, `bore.worn.depth`.
    pub key: String,
    /// The nominal number, in SI.
    pub nominal: f64,
    /// Half of the width, in SI.
    pub half_width: f64,
    /// Unit in which it is written; empty for plain numbers.
    pub unit: String,
    /// Kind of quantity; `None` for plain numbers.
    pub dimension: Option<Dimension>,
    /// Bytes of the scene's text where it is written.
    pub span: Range<usize>,
}

impl KeyTolerance {
    /// A number without a tolerance, of a key that may have one: its width is zero.
    pub(crate) fn exact(row: &Key, (number, text): (f64, Option<&str>), dimension: Option<Dimension>) -> Option<Self> {
        let unit = text.map_or("", |text| parts(text).1).to_owned();
        let is_known = number.is_finite() && no_tolerance(row).is_none();
        is_known.then(|| Self { key: String::new(), nominal: number, half_width: 0.0, unit, dimension, span: 0..0 })
    }

    /// A value in SI in the unit of the key.
    pub fn in_unit(&self, value: f64) -> f64 {
        let zero = self.dimension.map_or(0.0, |dimension| dimension.zero(&self.unit));
        (value - zero) / self.unit_size()
    }

    /// One unit of the key in SI; of a temperature that of a difference.
    pub fn unit_size(&self) -> f64 {
        self.dimension.and_then(|dimension| unit::unit_size(&self.unit, dimension).ok()).unwrap_or(1.0)
    }

    /// Both ends, in SI.
    pub(crate) fn ends(&self) -> [f64; 2] {
        [self.nominal - self.half_width, self.nominal + self.half_width]
    }
}

impl Scene {
    /// This scene with other numbers, in SI, of keys that have tolerances; all others have their nominal ones.
    ///
    /// # Errors
    /// The numbers make no scene that can be computed.
    pub fn with_values(&self, values: &[(&KeyTolerance, f64)], checks: &[Check]) -> Result<Self, SceneError> {
        let fail = |complaints| SceneError::Complaints { path: self.path.clone(), text: self.text.clone(), complaints };
        crate::sweep::of_values(&self.text, &self.path, values, checks).map_err(fail)
    }
}

/// What is wrong with a scene at the ends of its tolerances, one after the other.
pub(crate) fn complaints_at_ends(scene: &Scene, text: &str, checks: &[Check]) -> Vec<Complaint> {
    let mut found: Vec<Complaint> = Vec::new();
    for tolerance in &scene.tolerances {
        let ends = tolerance.ends().into_iter();
        let refused =
            ends.filter_map(|end| crate::sweep::of_values(text, &scene.path, &[(tolerance, end)], checks).err());
        let first = refused.flatten().next();
        found.extend(first.map(|complaint| Complaint { key: tolerance.key.clone(), ..complaint }));
    }
    found
}

/// The two numbers of a tolerance, as they are written.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum WrittenTolerance<'t> {
    /// A number, and how far the true one may lie from it.
    HalfWidth([&'t str; 2]),
    /// The two ends.
    Range([&'t str; 2]),
}

impl<'t> WrittenTolerance<'t> {
    /// What a text says; `None` where it is no tolerance.
    pub(crate) fn of(text: &'t str) -> Option<Self> {
        let parts = |sign: &str| text.split_once(sign).map(|(first, second)| [first.trim(), second.trim()]);
        let half_width = SIGNS.into_iter().find_map(parts).map(Self::HalfWidth);
        half_width.or_else(|| parts(RANGE).map(Self::Range))
    }

    /// The tolerance of a key with this row.
    ///
    /// # Errors
    /// What is wrong with it, and the way out.
    pub(crate) fn read(self, row: &Key, dimension: Option<Dimension>) -> Result<KeyTolerance, [String; 2]> {
        if let Some(reason) = no_tolerance(row) {
            return Err([format!("has a tolerance, but {reason}"), "give one number".to_owned()]);
        }
        match self {
            Self::HalfWidth(written) => around(written, row, dimension),
            Self::Range(ends) => between(ends, row, dimension),
        }
    }
}

/// The tolerance of a number with a half width.
fn around([nominal, width]: [&str; 2], row: &Key, dimension: Option<Dimension>) -> Result<KeyTolerance, [String; 2]> {
    let (half, width_unit) = parts(width);
    let half = half.ok_or_else(|| no_number(width))?;
    let (_, own) = parts(nominal);
    let is_relative = width_unit == "%" && dimension != Some(Dimension::Ratio);
    // Behind one unit for both, the number has none.
    let shared = if own.is_empty() && !is_relative { width_unit } else { "" };
    let value = quantity(&format!("{nominal} {shared}"), row, dimension)?;
    let half_width = match dimension {
        _ if is_relative => relative(half, value, dimension)?,
        None if !width_unit.is_empty() => return Err(no_number(width)),
        None => half,
        Some(_) if width_unit.is_empty() => {
            let help = format!("write for example \"{nominal} +- {width} {own}\"");
            return Err([format!("\"{width}\", the half width, has no unit"), help]);
        }
        Some(dimension) => {
            let size = unit::unit_size(width_unit, dimension);
            half * size.map_err(|error| [error.to_string(), error.help(row.example)])?
        }
    };
    found(value, half_width, if own.is_empty() { shared } else { own }, dimension)
}

/// The tolerance of a number between two ends.
fn between([from, to]: [&str; 2], row: &Key, dimension: Option<Dimension>) -> Result<KeyTolerance, [String; 2]> {
    let [(_, first), (_, last)] = [from, to].map(parts);
    let shared = if first.is_empty() { last } else { "" };
    let least = quantity(&format!("{from} {shared}"), row, dimension)?;
    let most = quantity(to, row, dimension)?;
    if most < least {
        let help = format!("write \"{to} .. {from}\"");
        return Err(["has the greater end first".to_owned(), help]);
    }
    let unit = if first.is_empty() { shared } else { first };
    found(0.5 * (least + most), 0.5 * (most - least), unit, dimension)
}

/// The half width that so many per cent of a value are.
fn relative(percent: f64, value: f64, dimension: Option<Dimension>) -> Result<f64, [String; 2]> {
    let help = "give the half width with its unit, as \"40 C +- 5 K\" or \"0 mm +- 2 mm\"".to_owned();
    match dimension {
        Some(Dimension::Temperature | Dimension::Angle) => {
            Err(["is given in %, which has no meaning where the zero is one of many".to_owned(), help])
        }
        _ if value == 0.0 => Err(["is some % of zero".to_owned(), help]),
        _ => Ok(1e-2 * percent * value.abs()),
    }
}

fn found(nominal: f64, half_width: f64, unit: &str, dimension: Option<Dimension>) -> Result<KeyTolerance, [String; 2]> {
    if !(half_width > 0.0 && half_width.is_finite()) {
        let help = format!("give a half width above zero, as in {EXAMPLES}, or remove it");
        return Err(["has no width".to_owned(), help]);
    }
    let tolerance =
        KeyTolerance { key: String::new(), nominal, half_width, unit: unit.to_owned(), dimension, span: 0..0 };
    match dimension.filter(|dimension| !tolerance.ends().iter().all(|end| dimension.holds(*end))) {
        Some(dimension) => Err([
            format!(
                "has an end that no {} reaches",
                dimension.name().trim_start_matches("an ").trim_start_matches("a ")
            ),
            "check exponents and units of both numbers".to_owned(),
        ]),
        None => Ok(tolerance),
    }
}

/// A number in SI.
fn quantity(text: &str, row: &Key, dimension: Option<Dimension>) -> Result<f64, [String; 2]> {
    match dimension {
        Some(dimension) => unit::parse(text, dimension).map_err(|error| [error.to_string(), error.help(row.example)]),
        None => match parts(text.trim()) {
            (Some(number), "") => Ok(number),
            _ => Err(no_number(text.trim())),
        },
    }
}

fn no_number(text: &str) -> [String; 2] {
    [format!("\"{text}\" is no number of a tolerance"), format!("write for example {EXAMPLES}, or \"0.6 +- 0.05\"")]
}

/// The number and the unit of a text, which may have none.
fn parts(text: &str) -> (Option<f64>, &str) {
    match unit::split(text) {
        Some((number, unit)) => (Some(number), unit),
        None => (text.parse().ok().filter(|number: &f64| number.is_finite()), ""),
    }
}

impl Key {
    /// Whether its number may have a tolerance.
    pub fn may_have_tolerance(&self) -> bool {
        no_tolerance(self).is_none()
    }
}

/// Why a key has no tolerance; `None` where it may have one.
fn no_tolerance(row: &Key) -> Option<&'static str> {
    let (_, name) = row.table_and_name();
    let exact = EXACT.iter().find(|(exact, _)| row.path.split('.').next() == Some(exact));
    match exact {
        Some((_, reason)) => Some(reason),
        None if SHARED.contains(&name) => Some("is a limit, with which answers are compared"),
        None if Bounds::of(row).is_whole || COUNTS.contains(&row.path) => Some("is a whole number"),
        None => None,
    }
}

/// The numbers of a scene in the order of its text, with the names that axes of sweeps have; a complaint about each
/// with a tolerance that has none.
pub(crate) fn named(found: Vec<KeyTolerance>, scene: &Scene, complaints: &mut Complaints) -> Vec<KeyTolerance> {
    let mut list = Vec::with_capacity(found.len());
    for tolerance in found {
        match name(&tolerance.key, scene, complaints) {
            Some(key) => list.push(KeyTolerance { key, ..tolerance }),
            None if tolerance.half_width == 0.0 => {}
            None => complaints.add(
                &tolerance.key,
                "has a tolerance, but stands in a list by whose names it cannot be told from others",
                "give one number, or each feed a group of its own",
            ),
        }
    }
    list.sort_by_key(|tolerance: &KeyTolerance| tolerance.span.start);
    list
}

fn name(key: &str, scene: &Scene, complaints: &Complaints) -> Option<String> {
    let Some((list, rest)) = key.split_once('[') else { return Some(key.to_owned()) };
    let (number, rest) = rest.split_once("].")?;
    let number: usize = number.parse().ok().filter(|_| !rest.contains('['))?;
    match list {
        "feed" => {
            let group = &scene.feeds.get(number)?.group;
            let is_only = scene.feeds.iter().filter(|feed| feed.group == *group).count() == 1;
            is_only.then(|| format!("feed.{group}.{rest}"))
        }
        "bore" => {
            let shape = rest.split('.').next()?;
            let alike = (0..scene.bores.len()).filter(|other| complaints.has(&format!("bore[{other}].{shape}")));
            (alike.count() == 1).then(|| format!("bore.{rest}"))
        }
        _ => None,
    }
}

/// Refuses all tolerances of a scene of a crankshaft.
pub(crate) fn refuse_all(found: &[KeyTolerance], complaints: &mut Complaints) {
    for tolerance in found.iter().filter(|input| input.half_width > 0.0) {
        let message = "has a tolerance, but only single bearings have tolerances";
        complaints.add(&tolerance.key, message, "give one number");
    }
}

#[cfg(test)]
mod tests {
    use crate::scene::tests::{STUDY, good, read};
    use crate::{PositionTable, Scene};

    const CLEARANCE: &str = "clearance = \"37.5 um\"";

    fn with(from: &str, to: &str) -> Scene {
        assert!(STUDY.contains(from), "{from}");
        read(&STUDY.replacen(from, to, 1)).unwrap_or_else(|error| panic!("{to}: {error}"))
    }

    #[test]
    fn tolerances_are_read_in_all_their_forms() {
        for text in [
            "27 um +- 3 um",
            "27 +- 3 um",
            "27um\u{b1}3um",
            "27 \u{b1} 3 \u{b5}m",
            "27 um +/- 0.003 mm",
            "24 um .. 30 um",
            "24 .. 30 um",
            "24um..30um",
            "0.024 mm .. 30 um",
        ] {
            let scene = with(CLEARANCE, &format!("clearance = \"{text}\""));
            let [tolerance] = &scene.tolerances[..] else { panic!("{text}: {:?}", scene.tolerances) };
            assert_eq!(tolerance.key, "bearing.clearance");
            assert!((tolerance.nominal - 27e-6).abs() < 1e-18 && (tolerance.half_width - 3e-6).abs() < 1e-18, "{text}");
            assert!((scene.bearing.clearance - 27e-6).abs() < 1e-18, "{text}");
        }
        let [plain, scene] =
            [with(CLEARANCE, "clearance = \"27 um\""), with(CLEARANCE, "clearance = \"27 um +- 10 %\"")];
        assert_eq!(scene.bearing, plain.bearing);
        assert_eq!((scene.tolerances[0].half_width, plain.tolerances.len()), (0.1 * 27.0 * 1e-6, 0));
    }

    #[test]
    fn feeds_are_named_by_their_group_and_plain_numbers_have_no_unit() {
        let scene = with("eccentricity = 0.6", "eccentricity = \"0.6 +- 0.05\"");
        assert_eq!(scene.tolerances[0].key, "journal.eccentricity");
        assert!(matches!(scene.journal.position, PositionTable::Given { eccentricity: 0.6, .. }));
        let scene = with("pressure = \"1.96 bar\"", "pressure = \"1.96 bar +- 5 %\"");
        assert_eq!(scene.tolerances[0].key, format!("feed.{}.pressure", scene.feeds[0].group));
        let values = [(&scene.tolerances[0], 2e5)];
        let other = scene.with_values(&values, &[]).expect("a scene");
        assert!((other.feeds[0].pressure.unwrap_or_default() - 2e5).abs() < 1e-9);
        assert!(other.tolerances.is_empty() && other.bearing == scene.bearing);
    }

    #[test]
    fn what_is_no_tolerance_is_refused_with_the_reason() {
        for (value, wanted) in [
            ("27 um +- 3", "bearing.clearance: \"3\", the half width, has no unit"),
            ("27 um +- 3 bar", "bearing.clearance: \"bar\" is a unit of pressure"),
            ("27 +- 10 %", "bearing.clearance: \"27\" has no unit"),
            ("27 um +- 0 um", "bearing.clearance: has no width"),
            ("27 um +- -3 um", "bearing.clearance: has no width"),
            ("27 um +- wide", "bearing.clearance: \"wide\" is no number of a tolerance"),
            ("0 um +- 10 %", "bearing.clearance: is some % of zero"),
            ("27 um +- 30 um", "bearing.clearance: at an end of its tolerance is not positive"),
            ("30 um .. 24 um", "bearing.clearance: has the greater end first"),
            ("24 um .. wide", "bearing.clearance: \"wide\" does not begin with a number"),
        ] {
            good::told_one(CLEARANCE, &format!("clearance = \"{value}\""), wanted);
        }
        for (from, to, wanted) in [
            (
                "eccentricity = 0.6",
                "eccentricity = \"0.6 +- 0.5\"",
                "journal.eccentricity: with journal.eccentricity = 1.1, ",
            ),
            ("eccentricity = 0.6", "eccentricity = \"0.6 +- 0.1 mm\"", "journal.eccentricity: \"0.6 mm\" is no number"),
            (
                "file = \"liner.msh\"",
                "size = \"3 mm +- 1 mm\"",
                "mesh.size: has a tolerance, but is a choice of the mesh",
            ),
        ] {
            good::told_one(from, to, wanted);
        }
    }
}
