//! `[shaft]`: what the journal is beside a cylinder. It turns, so that its shape does not depend on the angle.

use std::path::{Path, PathBuf};

use crate::reader::TableReader;

keys! {
    "shaft" = Table; "", "the journal is a cylinder", "one of `crown` and `file`",
        "the axisymmetric shape of the journal: how much smaller than that of the cylinder its radius is";
    "shaft.crown" = Quantity(Length); "3 um", "no crown", "any",
        "how much smaller the radius is at both ends of a barrel-shaped journal, as (z/b)^2, b half of the length; negative where it is larger";
    "shaft.file" = Text; "shafts/measured.csv", "no measured shape", "a table with units in its header: `z [mm], depth [um]`",
        "path of a table of measured depths along the journal, counted from the folder of the scene";
}

/// The shape of a journal.
#[derive(Debug, Clone, PartialEq)]
pub enum JournalShape {
    /// How much smaller its radius is at the ends [m].
    Crown(f64),
    /// Depths of a table in this file.
    Measured(PathBuf),
}

/// Reads the table; a file counts from the folder of the `scene`.
pub(crate) fn read(mut table: TableReader<'_>, scene: &Path) -> JournalShape {
    let crown = table.given("crown");
    let file = table.text_if_given("file");
    table.refuse_if(
        table.has("crown") && table.has("file"),
        "file",
        "stands beside crown",
        "keep one of them: a measured shape contains its crown",
    );
    if !table.has("crown") && !table.has("file") && table.is_readable() {
        table.complain_here(
            "has no shape",
            "give crown = \"3 um\" or file = \"shaft.csv\", or remove the table: the journal is a cylinder",
        );
    }
    match (crown, file) {
        (Some(crown), _) => JournalShape::Crown(crown),
        (None, Some(file)) => JournalShape::Measured(scene.parent().unwrap_or(Path::new("")).join(file)),
        (None, None) => JournalShape::Crown(f64::NAN),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::tests::{STUDY, read};

    #[test]
    fn the_shape_of_the_journal_is_read_or_refused() {
        let scene = |keys: &str| read(&format!("{STUDY}\n[shaft]\n{keys}\n"));
        let shaft = |keys: &str| scene(keys).expect("a scene").shaft;
        assert_eq!(shaft("crown = \"3 um\""), Some(JournalShape::Crown(3e-6)));
        assert!(matches!(shaft("file = \"s.csv\""), Some(JournalShape::Measured(path)) if path.ends_with("s.csv")));
        for (keys, wanted) in [
            ("", "shaft: has no shape"),
            ("crown = \"1 um\"\nfile = \"s.csv\"", "shaft.file: stands beside crown"),
            ("oval = { depth = \"1 um\" }", "shaft.oval: this table is not known"),
        ] {
            let error = scene(keys).expect_err(keys).to_string();
            assert!(error.contains(wanted), "{error}");
        }
    }
}
