//! `oilwedge oil`: the oils that a scene may name, and their viscosity and density by temperature.

use crate::complain::Failure;
use crate::readable::significant;
use crate::terminal::{align_right, print, table};
use oilwedge_report::Error;
use oilwedge_report::oil_sheet::{GRADES, OilSheet};
use std::process::ExitCode;

/// Arguments of `oilwedge oil`.
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Oil {
    /// The grade, as "SAE 10W-40" or "ISO VG 46"; without it all grades are listed.
    #[arg(value_name = "NAME", num_args = 0..)]
    name: Vec<String>,

    /// Temperature, as "80 C"; without it a table over temperatures.
    #[arg(long, value_name = "TEMPERATURE", requires = "name", allow_hyphen_values = true)]
    at: Option<String>,

    /// Print one JSON object instead of a table.
    #[arg(long, requires = "name")]
    json: bool,
}

const EXAMPLES: &str = "\
Examples:
  oilwedge oil                                     all grades
  oilwedge oil SAE 10W-40                          its viscosity and density over temperatures
  oilwedge oil \"ISO VG 46\" --at \"65 C\"             the same at one temperature
  oilwedge oil 10W-40 --at 100C --json

A scene names its oil with [oil] grade = \"SAE 10W-40\" and temperature = \"80 C\".
Exit status: 0 done; 2 no such grade or temperature.";

impl Oil {
    /// Prints what is known of a grade, or which there are.
    ///
    /// # Errors
    /// [`Failure`]: there is no such grade or temperature.
    pub(crate) fn run(&self) -> Result<ExitCode, Failure> {
        if self.name.is_empty() {
            print(&all(), None)?;
            return Ok(ExitCode::SUCCESS);
        }
        let sheet = OilSheet::of(&self.name.join(" "), self.at.as_deref()).map_err(|complaint| Failure::Argument {
            message: format!("{complaint}; {}", complaint.help),
        })?;
        match self.json {
            true => print(&sheet.to_json().map_err(Error::from)?, None)?,
            false => print(&told(&sheet), None)?,
        }
        Ok(ExitCode::SUCCESS)
    }
}

fn told(sheet: &OilSheet) -> String {
    let mut rows = table(["t [C]", "nu [mm2/s]", "mu [mPa.s]", "rho [kg/m3]"]);
    for at in &sheet.at {
        rows.add_row([
            format!("{}", (1e6 * at.temperature).round() * 1e-6),
            significant(1e6 * at.kinematic_viscosity, 4),
            significant(1e3 * at.viscosity, 4),
            format!("{:.1}", at.density),
        ]);
    }
    (0..4).for_each(|column| align_right(&mut rows, column));
    format!("{}\n\n{rows}\n\nsource    {}\n", sheet.grade, sheet.source)
}

fn all() -> String {
    let mut rows = table([
        "grade",
        "nu 40 C [mm2/s]",
        "nu 100 C [mm2/s]",
        "rho 15 C [kg/m3]",
        "class",
    ]);
    for grade in GRADES {
        rows.add_row([
            grade.name.to_owned(),
            format!("{}", grade.nu_40),
            format!("{}", grade.nu_100),
            format!("{}", grade.rho_15),
            grade.window.standard.to_owned(),
        ]);
    }
    (1..4).for_each(|column| align_right(&mut rows, column));
    format!(
        "{rows}\n\nOne typical oil of each class; another one differs by some 10 %, and its data sheet is better ([oil] walther).\n"
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
        let sheet = OilSheet::of("SAE 10W-40", Some("40 C")).expect("a sheet");
        assert!(told(&sheet).contains("40 ┆      95.00 ┆"), "{}", told(&sheet));
    }
}
