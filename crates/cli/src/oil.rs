//! `oilwedge oil`: the oils that a scene may name, and their viscosity and density by temperature.

use crate::complain::Failure;
use crate::readable::significant;
use crate::terminal::{output, print};
use oilwedge_report::json;
use oilwedge_report::oil_sheet::{GRADES, NoSheet, OilSheet};
use oilwedge_report::sheet::{Sheet, number_as, numeral, text};
use oilwedge_scene::unit::{self, Dimension};
use std::process::ExitCode;

/// Arguments of `oilwedge oil`.
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct OilCommand {
    /// The grade, as "SAE 10W-40" or "ISO VG 46"; without it all grades are listed.
    #[arg(value_name = "NAME", num_args = 0..)]
    name: Vec<String>,

    /// Temperature, as "80 C"; without it a table over temperatures.
    #[arg(long, value_name = "TEMPERATURE", requires = "name", allow_hyphen_values = true, value_parser = temperature)]
    at: Option<f64>,

    /// Print one JSON object instead of a table.
    #[arg(long, requires = "name")]
    json: bool,
}

const EXAMPLES: &str = "\
Examples:
  oilwedge oil                                     all grades
  oilwedge oil SAE 10W-40                          its viscosity and density by temperature
  oilwedge oil \"ISO VG 46\" --at \"65 C\"             those at one temperature
  oilwedge oil 10W-40 --at 100C --json

A scene names its oil with [oil] grade = \"SAE 10W-40\" and temperature = \"80 C\".
Exit status: 0 done; 2 no such grade or temperature.";

fn temperature(text: &str) -> Result<f64, String> {
    unit::parse(text, Dimension::Temperature).map_err(|error| format!("{error}; {}", error.help("80 C")))
}

impl OilCommand {
    /// Prints what is known of a grade, or which there are.
    ///
    /// # Errors
    /// [`Failure`]: there is no such grade or temperature.
    pub(crate) fn run(&self) -> Result<ExitCode, Failure> {
        if self.name.is_empty() {
            print(&all(), None)?;
            return Ok(ExitCode::SUCCESS);
        }
        let sheet = OilSheet::of(&self.name.join(" "), self.at).map_err(|error| {
            let help = match &error {
                NoSheet::Grade { near: Some(near), .. } => format!("did you mean \"{near}\"? oilwedge oil lists all"),
                NoSheet::Grade { near: None, .. } => "oilwedge oil lists all".to_owned(),
                NoSheet::Temperature { .. } => "give for example --at \"80 C\"".to_owned(),
            };
            Failure::Message(format!("{error}; {help}"))
        })?;
        output(self.json, || json(&sheet), || in_words(&sheet), None)?;
        Ok(ExitCode::SUCCESS)
    }
}

fn in_words(sheet: &OilSheet) -> String {
    let rows = sheet.at.iter().map(|at| {
        let cells = [
            format!("{}", (1e6 * at.temperature).round() * 1e-6),
            significant(1e6 * at.kinematic_viscosity, 4),
            significant(1e3 * at.viscosity, 4),
            format!("{:.1}", at.density),
        ];
        cells.map(numeral).to_vec()
    });
    let table = Sheet::new("", ["t [C]", "nu [mm2/s]", "mu [mPa.s]", "rho [kg/m3]"], rows.collect()).terminal();
    format!("{}\n\n{table}\n\nsource    {}\n", sheet.grade, sheet.source)
}

fn all() -> String {
    let header = ["grade", "nu 40 C [mm2/s]", "nu 100 C [mm2/s]", "rho 15 C [kg/m3]", "class"];
    let rows = GRADES.iter().map(|grade| {
        let [nu_40, nu_100, rho] = [grade.nu_40, grade.nu_100, grade.rho_15].map(|it| number_as(it, format!("{it}")));
        vec![text(grade.name), nu_40, nu_100, rho, text(grade.window.standard)]
    });
    let table = Sheet::new("", header, rows.collect()).terminal();
    format!(
        "{table}\n\nOne typical oil of each class. Others differ by some 10 %: prefer the data sheet of yours ([oil] walther).\n"
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_grade_is_listed_and_has_a_sheet() {
        let list = all();
        for grade in GRADES {
            assert!(list.contains(grade.name));
            assert!(OilSheet::of(grade.name, None).is_ok());
        }
        let sheet = OilSheet::of("SAE 10W-40", Some(313.15)).expect("a sheet");
        assert!(in_words(&sheet).contains("40 ┆      95.00 ┆"), "{}", in_words(&sheet));
    }
}
