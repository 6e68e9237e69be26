//! `oilwedge explain`: what a name means.

use crate::complain::Failure;
use crate::terminal::output;
use oilwedge_report::catalogue::{CatalogueEntry, entries, explain};
use oilwedge_report::json;
use std::process::ExitCode;

/// Arguments of `oilwedge explain`.
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Explain {
    /// The name of a quantity, effect, key of a scene, field or warning, whole or its last part, a symbol, or words
    /// that others use or that its sentence has.
    #[arg(value_name = "NAME", required_unless_present = "all")]
    name: Option<String>,

    /// All names.
    #[arg(long, conflicts_with = "name")]
    all: bool,

    /// Print JSON instead of words.
    #[arg(long)]
    json: bool,
}

/// Most entries that are shown with all that is known of them; more are a line each.
const MOST_IN_FULL: usize = 6;

const EXAMPLES: &str = "\
Examples:
  oilwedge explain side_flow                a quantity
  oilwedge explain bearing.arc.from         a key of a scene
  oilwedge explain jfo                      an effect
  oilwedge explain \"oil flow\"               what others call so
  oilwedge explain --all --json             the whole catalogue, for a script

Exit status: 0 done; 2 there is no such name.";

impl Explain {
    /// Prints what is known of the name.
    ///
    /// # Errors
    /// [`Failure`]: there is no such name.
    pub(crate) fn run(&self) -> Result<ExitCode, Failure> {
        let meant = match &self.name {
            None => entries(),
            Some(name) => explain(name.trim()).map_err(|near| {
                let hint = near.map_or(String::new(), |near| format!("did you mean \"{near}\"? "));
                Failure::Message(format!("nothing is called \"{name}\"; {hint}oilwedge explain --all lists all names"))
            })?,
        };
        let text = || match self.all || meant.len() > MOST_IN_FULL {
            true => meant.iter().map(CatalogueEntry::line).collect(),
            false => meant.iter().map(CatalogueEntry::in_words).collect::<Vec<_>>().join("\n"),
        };
        output(self.json, || json(&meant), text, None)?;
        Ok(ExitCode::SUCCESS)
    }
}
