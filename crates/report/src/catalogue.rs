//! All that this program has words for, in one list: keys of scenes, quantities, effects, fields and kinds of warnings.

use oilwedge_scene::catalogue::keys;
use oilwedge_scene::keys::Key;
use oilwedge_scene::spelling::nearest;
use oilwedge_study::effects::{EFFECTS, Effect};
use oilwedge_study::fields::{FieldRow, file_fields};
use oilwedge_study::quantities::{
    BOLT_PRELOAD, CATALOGUE, CONTACT_SHARE, CRITICAL_MASS, CYCLE_POWER_LOSS, CYCLE_SIDE_FLOW, FEED_FLOW,
    FRICTION_COEFFICIENT, FRICTION_POWER, INLET_FLOW, LOGARITHMIC_DECREMENT, Row, SIDE_FLOW, SIDE_FLOW_HIGH,
    SIDE_FLOW_LOW, SOMMERFELD_NUMBER, WHIRL_RATIO,
};
use oilwedge_study::warning::{HALF_SPEED, KINDS, Kind};
use serde::{Serialize, Serializer};

/// Stands for the name of a region in that of a family.
const REGION: &str = "GROUP";

/// Column of symbols.
const SYMBOL: &str = "symbol";
/// Fewest letters by which a part of a name is recognised.
const PART: usize = 3;

/// Words that others use, and the names of what they mean here.
static WORDS: [(&str, &[&str]); 8] = [
    ("lemon", &["bore.oval"]),
    ("elliptical", &["bore.oval"]),
    ("preload", &["bore.oval", BOLT_PRELOAD.name]),
    ("oil flow", &[SIDE_FLOW.name, INLET_FLOW.name, FEED_FLOW.name, CYCLE_SIDE_FLOW.name]),
    ("power loss", &[FRICTION_POWER.name, CYCLE_POWER_LOSS.name]),
    ("leakage", &[SIDE_FLOW.name, SIDE_FLOW_LOW.name, SIDE_FLOW_HIGH.name]),
    ("whirl", &["dynamics.whirl", WHIRL_RATIO.name, CRITICAL_MASS.name, LOGARITHMIC_DECREMENT.name, HALF_SPEED.code]),
    ("stribeck", &[FRICTION_COEFFICIENT.name, SOMMERFELD_NUMBER.name, CONTACT_SHARE.name, "contact"]),
];

/// What stands beside the value of a quantity in results, with its parts.
static BESIDE_VALUES: [(&str, &str, &str); 2] = [
    (
        "spread",
        "how far a quantity is spread by the tolerances of the scene; the effect of a tolerance is its half width times the derivative",
        "worst_case: the sum of all effects; rss: the root of the sum of their squares; shares: the part of each key in that sum of squares; nonlinearity: how far films at the worst corners miss the sum of the effects, of the main numbers; corners: the values there where that is more than 0.2",
    ),
    (
        "sensitivity",
        "the derivative of a quantity by the number of a key that has a tolerance, of all keys with `solve --sensitivity`",
        "value: in units of quantity and key; log: the relative change over that of the number; is_by_films: by two films solved again, which is less exact; has_kink: the derivatives on both sides of the number differ",
    ),
];

/// One row of a catalogue in words.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct CatalogueEntry {
    /// The catalogue that the entry is of: `key`, `quantity`, `effect`, `field`, `warning` or `result`.
    pub kind: &'static str,
    /// Name of the entry in its catalogue.
    pub name: String,
    /// What it is, in a sentence.
    pub what: String,
    /// Further columns of its row, each with its name; those without a content are absent.
    #[serde(serialize_with = "as_map")]
    pub columns: Vec<(&'static str, String)>,
}

fn as_map<S: Serializer>(columns: &[(&'static str, String)], serializer: S) -> Result<S::Ok, S::Error> {
    serializer.collect_map(columns.iter().map(|(name, text)| (name, text)))
}

/// All entries, catalogue by catalogue.
pub fn entries() -> Vec<CatalogueEntry> {
    let keys = keys().map(of_key);
    let quantities = CATALOGUE.iter().map(|row| of_quantity(row));
    let effects = EFFECTS.iter().map(|effect| of_effect(effect));
    let fields = file_fields().map(of_field);
    let warnings = KINDS.iter().map(|kind| of_warning(kind));
    let beside = BESIDE_VALUES.iter();
    let beside =
        beside.map(|(name, what, parts)| CatalogueEntry::new("result", name, what, [("parts", (*parts).to_owned())]));
    keys.chain(quantities).chain(effects).chain(fields).chain(warnings).chain(beside).collect()
}

impl CatalogueEntry {
    fn new<const N: usize>(kind: &'static str, name: &str, what: &str, columns: [(&'static str, String); N]) -> Self {
        Self {
            kind,
            name: name.to_owned(),
            what: what.to_owned(),
            columns: columns.into_iter().filter(|(_, text)| !text.is_empty()).collect(),
        }
    }

    /// Kind, name and sentence of the entry, in a line.
    pub fn line(&self) -> String {
        format!("{:8}  {:34}  {}\n", self.kind, self.name, self.what)
    }

    /// All of it, in lines.
    pub fn in_words(&self) -> String {
        let mut text = format!("{} ({})\n  {}\n", self.name, self.kind, self.what);
        for (name, column) in &self.columns {
            text += &format!("  {name:10}  {column}\n");
        }
        text
    }

    /// Whether it is meant by `name`: its whole name, the last part of it, as `clearance` of `bearing.clearance` or
    /// `jfo` of `cavitation: jfo`, or its symbol.
    fn is_meant_by(&self, name: &str) -> bool {
        let is_member = |family: &str| name.strip_prefix(family).is_some_and(|region| !region.is_empty());
        let is_of_family = self.name.strip_suffix(REGION).is_some_and(is_member);
        self.name == name
            || is_of_family
            || self.short_name() == name
            || self.columns.contains(&(SYMBOL, name.to_owned()))
    }

    /// Name of the entry, without the region for a family.
    fn family(&self) -> &str {
        self.name.strip_suffix(REGION).unwrap_or(&self.name)
    }

    fn short_name(&self) -> &str {
        // Fields have their unit in their name, regions stand in that of a family.
        let own = self.name.split(" [").next().unwrap_or_default();
        let own = own.strip_suffix(REGION).unwrap_or(own).trim_end_matches('.');
        own.rsplit(['.', ' ']).next().unwrap_or(own)
    }
}

fn of_key(key: &Key) -> CatalogueEntry {
    let columns = [
        ("form", key.forms_in_words()),
        ("range", key.range_in_words()),
        ("if absent", key.absent.to_owned()),
        ("example", key.example.to_owned()),
        ("keys", keys_below(key)),
    ];
    CatalogueEntry::new("key", key.path, key.what, columns)
}

/// The names of the keys of a table.
fn keys_below(table: &Key) -> String {
    let names = keys().filter_map(|key| {
        let (path, name) = key.table_and_name();
        (path == table.path).then_some(name)
    });
    names.collect::<Vec<_>>().join(", ")
}

fn of_quantity(row: &Row) -> CatalogueEntry {
    let columns = [
        (SYMBOL, row.symbol.to_owned()),
        ("unit", row.unit.name().to_owned()),
        ("definition", row.definition.to_owned()),
        ("error bar", row.error.sentence().to_owned()),
        ("tolerance", if row.may_be_tolerance { "may be one" } else { "" }.to_owned()),
    ];
    let region = if row.is_family() { REGION } else { "" };
    CatalogueEntry::new("quantity", &format!("{}{region}", row.name), row.what, columns)
}

fn of_effect(effect: &Effect) -> CatalogueEntry {
    let instead = match effect.instead {
        "" => "another question is asked, so it is not left out for comparison",
        instead => instead,
    };
    CatalogueEntry::new("effect", effect.name, effect.sentence, [("without it", instead.to_owned())])
}

fn of_field(field: &FieldRow) -> CatalogueEntry {
    let columns = [(SYMBOL, field.symbol.to_owned()), ("unit", field.unit.to_owned())];
    CatalogueEntry::new("field", field.name, field.what, columns)
}

fn of_warning(kind: &Kind) -> CatalogueEntry {
    CatalogueEntry::new("warning", kind.code, kind.sentence, [])
}

/// The entries that `name` means: those of this name, and those that others call so; else those whose name and sentence
/// have all its words.
///
/// # Errors
/// There is none; the nearest name, if one looks alike.
pub fn explain(name: &str) -> Result<Vec<CatalogueEntry>, Option<String>> {
    let all = entries();
    let plain = |text: &str| text.to_lowercase().replace(['_', '.'], " ");
    let asked = plain(name);
    let called = WORDS.iter().find(|(word, _)| *word == asked);
    let is_called = |entry: &CatalogueEntry| called.is_some_and(|(_, names)| names.contains(&entry.family()));
    let joined = name.replace(' ', "_");
    let is_meant = |entry: &CatalogueEntry| entry.is_meant_by(name) || entry.is_meant_by(&joined) || is_called(entry);
    let has_all = |entry: &CatalogueEntry| {
        let text = plain(&format!("{} {}", entry.name, entry.what));
        asked.len() >= PART && asked.split_whitespace().all(|word| text.contains(word))
    };
    let of = |is: &dyn Fn(&CatalogueEntry) -> bool| all.iter().filter(|entry| is(entry)).cloned().collect::<Vec<_>>();
    let meant = of(&is_meant);
    if !meant.is_empty() {
        return Ok(meant);
    }
    let names = || all.iter().flat_map(|entry| [entry.name.as_str(), entry.short_name()]);
    match of(&has_all) {
        none if none.is_empty() => Err(nearest(name, names()).map(str::to_owned)),
        found => Ok(found),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_row_has_a_name_of_its_own_and_a_sentence() {
        let entries = entries();
        for (place, entry) in entries.iter().enumerate() {
            assert!(!entry.name.is_empty() && !entry.what.is_empty(), "{entry:?}");
            let is_same = |other: &CatalogueEntry| other.kind == entry.kind && other.name == entry.name;
            assert!(!entries[..place].iter().any(is_same), "{entry:?}");
        }
    }

    #[test]
    fn words_of_others_mean_names_of_the_catalogue() {
        let all = entries();
        for (word, names) in &WORDS {
            let found = explain(&word.to_uppercase()).unwrap_or_else(|near| panic!("{word}: {near:?}"));
            for name in *names {
                assert!(all.iter().any(|entry| entry.family() == *name), "{name}");
                assert!(found.iter().any(|entry| entry.family() == *name), "{word}: {name}");
            }
        }
    }

    #[test]
    fn names_are_found_whole_and_by_their_last_part() {
        let found = |name: &str| {
            let entries = explain(name).unwrap_or_else(|near| panic!("{name}: {near:?}"));
            entries.iter().map(|entry| format!("{} {}", entry.kind, entry.name)).collect::<Vec<_>>()
        };
        assert_eq!(found("bearing.clearance"), ["key bearing.clearance"]);
        assert_eq!(found("clearance"), ["key bearing.clearance"]);
        assert_eq!(found("load"), ["key load", "key crankshaft.load", "quantity load"]);
        assert_eq!(found("feed_flow.groove"), ["quantity feed_flow.GROUP"]);
        assert_eq!(found("jfo"), ["effect cavitation: jfo"]);
        assert_eq!(found("unresolved"), ["warning unresolved"]);
        assert_eq!(found("volume_flow"), ["field volume_flow [m2/s]"]);
        assert_eq!(found("beta"), ["key oil.exponential.beta", "quantity attitude_angle"]);
        assert_eq!(found("attitude")[0], "quantity attitude_angle");
        assert_eq!(found("attitude angle"), ["quantity attitude_angle"]);
        assert_eq!(explain("pressure_mx"), Err(Some("pressure_max".to_owned())));
        assert_eq!(explain("zeppelin"), Err(None));
    }
}
