//! `oilwedge schema`: the JSON schema of scenes.

use crate::complain::Failure;
use crate::terminal::print;
use oilwedge_report::{json, schema::schema};
use std::process::ExitCode;

/// Arguments of `oilwedge schema`.
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Schema {}

const EXAMPLES: &str = "\
Example:
  oilwedge schema > oilwedge.schema.json

Editors use it where the first line of a scene is #:schema ./oilwedge.schema.json (Even Better TOML, taplo).
It knows keys, units and words; oilwedge check SCENE also checks ranges, and keys that must fit each other.";

impl Schema {
    /// Prints the schema.
    ///
    /// # Errors
    /// [`Failure`]: stdout cannot be written to.
    pub(crate) fn run(&self) -> Result<ExitCode, Failure> {
        print(&json(&schema())?, None)?;
        Ok(ExitCode::SUCCESS)
    }
}
