//! The data sheet of a grade: viscosity and density by temperature, and where they come from.

use oilwedge_reynolds::lubricant::Grade;
use oilwedge_reynolds::lubricant::density::ZERO_CELSIUS;
pub use oilwedge_reynolds::lubricant::grades::GRADES;
use serde::Serialize;

use crate::json::{ReportError, json};
use oilwedge_scene::Complaint;
use oilwedge_scene::spelling::nearest;
use oilwedge_scene::unit::{self, Dimension};
use oilwedge_scene::wording::celsius;

/// Name and version of the form of what `oilwedge oil --json` prints.
pub const OIL_FORMAT: &str = "oilwedge-oil/1";
/// Temperatures [degrees C] of a sheet where none is asked for.
const USUAL: [f64; 9] = [0.0, 20.0, 40.0, 60.0, 80.0, 100.0, 120.0, 140.0, 150.0];
/// Temperatures [degrees C] between which such oils are liquids.
const LIQUID: [f64; 2] = [-40.0, 250.0];

/// What is known of one grade.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct OilSheet {
    /// [`OIL_FORMAT`].
    pub format: &'static str,
    /// Name of the grade.
    pub grade: &'static str,
    /// The window of its class, and that the values are typical ones within.
    pub source: String,
    /// The oil at each temperature.
    pub at: Vec<OilAt>,
}

/// The oil at one temperature.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct OilAt {
    /// Temperature [degrees C].
    pub temperature: f64,
    /// Kinematic viscosity [m2/s].
    pub kinematic_viscosity: f64,
    /// Dynamic viscosity [Pa.s].
    pub viscosity: f64,
    /// Density [kg/m3].
    pub density: f64,
}

impl OilSheet {
    /// The sheet of the grade `name`, at the temperature `at` (as `80 C`) or at usual ones.
    ///
    /// # Errors
    /// The grade is not known, or `at` is no temperature at which it is a liquid; with the way out.
    pub fn of(name: &str, at: Option<&str>) -> Result<Self, Complaint> {
        let complaint = |key: &str, value: &str, message: String, help: String| Complaint {
            key: key.to_owned(),
            value: value.to_owned(),
            message,
            help,
            span: None,
        };
        let grade = Grade::named(name);
        let Some((grade, oil)) = grade.and_then(|grade| Some((grade, grade.oil()?))) else {
            let near = nearest(name, GRADES.iter().map(|grade| grade.name));
            let help = near.map_or("oilwedge oil lists all".to_owned(), |near| {
                format!("did you mean \"{near}\"? oilwedge oil lists all")
            });
            return Err(complaint(
                "",
                name,
                format!("\"{name}\" is no grade that is known"),
                help,
            ));
        };
        let temperatures = match at {
            None => USUAL.map(|celsius| celsius + ZERO_CELSIUS).to_vec(),
            Some(text) => {
                let found = unit::parse(text, Dimension::Temperature)
                    .map_err(|error| complaint("--at", text, error.to_string(), error.help("80 C")))?;
                let [least, most] = LIQUID.map(|celsius| celsius + ZERO_CELSIUS);
                if !(least..=most).contains(&found) {
                    let message = format!(
                        "{} is not between {} and {}",
                        celsius(found),
                        celsius(least),
                        celsius(most)
                    );
                    return Err(complaint(
                        "--at",
                        text,
                        message,
                        "give for example --at \"80 C\"".to_owned(),
                    ));
                }
                vec![found]
            }
        };
        let rows = temperatures.into_iter().map(|temperature| OilAt {
            temperature: temperature - ZERO_CELSIUS,
            kinematic_viscosity: oil.kinematic_viscosity(temperature),
            viscosity: oil.viscosity(temperature),
            density: oil.density.at(temperature),
        });
        Ok(Self {
            format: OIL_FORMAT,
            grade: grade.name,
            source: source(&grade),
            at: rows.collect(),
        })
    }

    /// The sheet as JSON, with a line break at its end.
    ///
    /// # Errors
    /// The writer of JSON failed.
    pub fn to_json(&self) -> Result<String, ReportError> {
        json(self)
    }
}

/// Where the numbers of a grade come from.
fn source(grade: &Grade) -> String {
    let window = grade.window;
    format!(
        "typical of the class, whose window in {} is {} to {} mm2/s at {} C; {} mm2/s at 40 C, {} mm2/s at 100 C (ASTM D341 between), {} kg/m3 at 15 C",
        window.standard,
        tidy(window.least),
        tidy(window.most),
        window.celsius,
        grade.nu_40,
        grade.nu_100,
        grade.rho_15
    )
}

/// Without the rounding of a tenth.
fn tidy(value: f64) -> f64 {
    format!("{value:.5e}").parse().unwrap_or(value)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_sheet_gives_the_points_back() {
        let sheet = OilSheet::of("10w-40", Some("313.15 K")).expect("a sheet");
        let [at] = sheet.at[..] else { panic!("one row") };
        assert!((at.kinematic_viscosity - 95e-6).abs() < 1e-15 && (at.temperature - 40.0).abs() < 1e-9);
        assert!((at.viscosity - at.kinematic_viscosity * at.density).abs() < 1e-15);
        assert!(
            sheet.source.contains("SAE J300 is 12.5 to 16.3 mm2/s at 100 C"),
            "{}",
            sheet.source
        );
        let usual = OilSheet::of("VG 46", None).expect("a sheet");
        assert!(usual.at.len() == USUAL.len() && usual.source.contains("41.4 to 50.6 mm2/s at 40 C"));
        assert!(usual.to_json().expect("JSON").contains("\"grade\": \"ISO VG 46\""));
    }

    #[test]
    fn what_is_no_grade_or_temperature_is_told() {
        let told = |name: &str, at: Option<&str>| {
            let complaint = OilSheet::of(name, at).expect_err("no sheet");
            format!("{complaint} ({})", complaint.help)
        };
        assert!(told("SAE 10W-41", None).contains("did you mean \"SAE 10W-40\"?"));
        assert!(told("honey", None).contains("oilwedge oil lists all"));
        assert!(told("VG 46", Some("80")).starts_with("--at: \"80\" has no unit; a temperature is wanted"));
        assert!(told("VG 46", Some("80 K")).starts_with("--at: -193.15 C is not between -40 C and 250 C"));
    }
}
