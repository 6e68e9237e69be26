//! A scene of a crankshaft with one thing changed, in its text too, so that it can be run again by itself.

use sha2::{Digest, Sha256};
use toml::{Table, Value};

use super::{Counterweight, ShaftScene, Statics};

impl ShaftScene {
    /// The scene with the shaft cut at its bearings.
    ///
    /// # Panics
    /// If `text` was replaced by one that is not the text of a crankshaft's scene.
    pub fn cut(&self) -> Self {
        let mut changed = self.with("statics", Value::from("cut"));
        changed.crankshaft.statics = Statics::Cut;
        changed
    }

    /// The scene with these counterweights in place of its own.
    ///
    /// # Panics
    /// If `text` was replaced by one that is not the text of a crankshaft's scene.
    pub fn with_counterweights(&self, weights: Vec<Counterweight>) -> Self {
        let tables: Vec<Value> = weights.iter().map(|weight| Value::Table(table(weight))).collect();
        let mut changed = self.with("counterweight", Value::from(tables));
        changed.crankshaft.counterweights = weights;
        changed
    }

    /// This scene with another value of a key of `[crankshaft]` in its text; comments are lost.
    fn with(&self, key: &str, value: Value) -> Self {
        let mut table: Table = self.text.parse().expect("a scene was read from this text");
        let shaft = table.get_mut("crankshaft").and_then(Value::as_table_mut);
        shaft.expect("a scene of a crankshaft has [crankshaft]").insert(key.to_owned(), value);
        let text = toml::to_string(&table).expect("a table that was read is written");
        Self { sha256: sum_of(&text), text, ..self.clone() }
    }
}

/// SHA-256 of a text, 64 hexadecimal digits.
pub(super) fn sum_of(text: &str) -> String {
    Sha256::digest(text).iter().map(|byte| format!("{byte:02x}")).collect()
}

/// A counterweight as it is written: its mass at a radius of 1 m.
fn table(weight: &Counterweight) -> Table {
    let number = |from_zero: usize| Value::Integer(i64::try_from(from_zero + 1).unwrap_or(i64::MAX));
    let texts = [
        ("mass", format!("{} kg", weight.moment)),
        ("radius", "1 m".to_owned()),
        ("angle", format!("{} deg", weight.angle.to_degrees())),
    ];
    let numbers = [("throw", number(weight.throw)), ("web", number(weight.web))];
    let texts = texts.map(|(key, text)| (key, Value::String(text)));
    numbers.into_iter().chain(texts).map(|(key, value)| (key.to_owned(), value)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::path::Path;

    const SCENE: &str = include_str!("../../../../scenes/engines/in_line_four.toml");

    fn read(text: &str) -> ShaftScene {
        ShaftScene::parse(text, Path::new("scene.toml")).unwrap_or_else(|error| panic!("{error}\n{text}"))
    }

    #[test]
    fn a_changed_scene_is_what_its_text_says() {
        let scene = read(SCENE);
        let cut = scene.cut();
        assert_eq!(cut.crankshaft.statics, Statics::Cut);
        assert_eq!(read(&cut.text), cut);
        let weights = vec![Counterweight { throw: 2, web: 1, moment: 0.0125, angle: 2.0 }];
        let changed = scene.with_counterweights(weights);
        let again = read(&changed.text);
        let [found, wanted] = [&again, &changed].map(|scene| scene.crankshaft.counterweights.clone());
        assert_eq!(found.len(), 1);
        assert_eq!((found[0].throw, found[0].web), (2, 1));
        assert!((found[0].moment - wanted[0].moment).abs() < 1e-15 && (found[0].angle - wanted[0].angle).abs() < 1e-12);
        assert_eq!(again.sha256, changed.sha256);
        assert_eq!(again.crankshaft.pieces, scene.crankshaft.pieces);
    }
}
