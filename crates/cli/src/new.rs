//! `oilwedge new`: a scene with comments to begin with, and its schema.

use crate::complain::Failure;
use crate::terminal::print;
use clap::builder::{PossibleValue, PossibleValuesParser};
use oilwedge_report::kinds::{KINDS, kind};
use oilwedge_report::{json, schema};
use std::fs::OpenOptions;
use std::io::{ErrorKind, Write};
use std::path::{Path, PathBuf};
use std::process::ExitCode;

/// Arguments of `oilwedge new`.
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct New {
    /// The file to write, NAME.toml; one that exists is not replaced.
    #[arg(value_name = "NAME.toml", value_parser = scene_name)]
    path: PathBuf,

    /// What kind of bearing it describes.
    #[arg(long, value_parser = kinds(), default_value = KINDS[0].0)]
    kind: String,
}

const EXAMPLES: &str = "\
Examples:
  oilwedge new bearing.toml
  oilwedge new main.toml --kind engine-main

Edit the file, then: oilwedge check bearing.toml, oilwedge solve bearing.toml. The schema beside it (oilwedge.schema.json) lets editors complete
and check keys and units.
Exit status: 0 done; 2 the file exists or cannot be written.";

/// File of the schema, beside the scene.
const SCHEMA_FILE: &str = "oilwedge.schema.json";

fn scene_name(text: &str) -> Result<PathBuf, String> {
    let path = PathBuf::from(text);
    let is_toml = path.extension().is_some_and(|extension| extension == "toml");
    match is_toml && path.file_stem().is_some() {
        true => Ok(path),
        false => Err("give a name that ends in .toml".to_owned()),
    }
}

fn kinds() -> PossibleValuesParser {
    let first_sentence =
        |text: &'static str| text.split(['.', '\n']).next().unwrap_or_default().trim_start_matches("# ");
    PossibleValuesParser::new(KINDS.map(|(name, text)| PossibleValue::new(name).help(first_sentence(text))))
}

impl New {
    /// Writes scene and schema.
    ///
    /// # Errors
    /// [`Failure`]: the file exists, or cannot be written.
    pub(crate) fn run(&self) -> Result<ExitCode, Failure> {
        let path = &self.path;
        if path.symlink_metadata().is_ok() {
            return Err(exists(path));
        }
        let schema = path.with_file_name(SCHEMA_FILE);
        if !is_ours(&schema) {
            return Err(Failure::Message(format!(
                "{} is no schema of oilwedge and is not replaced; choose another folder, or move it away",
                schema.display()
            )));
        }
        let own = kind(&self.kind).unwrap_or_default();
        let text = format!("#:schema ./{SCHEMA_FILE}\n{own}");
        let file = OpenOptions::new().write(true).create_new(true).open(path);
        let written = file.and_then(|mut file| file.write_all(text.as_bytes()));
        written.map_err(|error| match error.kind() {
            ErrorKind::AlreadyExists => exists(path),
            _ => cannot(path, &error),
        })?;
        std::fs::write(&schema, json(&schema::schema())?).map_err(|error| cannot(&schema, &error))?;
        let shown = path.display();
        let text =
            format!("wrote     {shown}, {SCHEMA_FILE}\nnext      edit {shown}, then: oilwedge solve {shown} --open\n");
        print(&text, Some(path))?;
        Ok(ExitCode::SUCCESS)
    }
}

/// Whether the schema may be written there: nothing is there, or one of this program.
fn is_ours(schema: &Path) -> bool {
    if schema.symlink_metadata().is_err() {
        return true;
    }
    #[derive(serde::Deserialize)]
    struct Titled {
        title: String,
    }
    let text = std::fs::read_to_string(schema).unwrap_or_default();
    serde_json::from_str::<Titled>(&text).is_ok_and(|it| it.title == schema::TITLE)
}

fn exists(path: &Path) -> Failure {
    Failure::Message(format!("{} exists and is not replaced; give another name, or move it away", path.display()))
}

fn cannot(path: &Path, error: &std::io::Error) -> Failure {
    Failure::Message(format!(
        "cannot write {}: {error}; give a file in a folder that can be written to",
        path.display()
    ))
}
