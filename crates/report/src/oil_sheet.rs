//! The data sheet of a grade: viscosity and density by temperature, and where they come from.

use oilwedge_reynolds::lubricant::Grade;
use oilwedge_reynolds::lubricant::density::ZERO_CELSIUS;
pub use oilwedge_reynolds::lubricant::grades::GRADES;
use serde::Serialize;

use oilwedge_scene::spelling::nearest;
use oilwedge_scene::wording::celsius;

/// Name and version of the form of what `oilwedge oil --json` prints.
pub const OIL_FORMAT: &str = "oilwedge-oil/1";
/// Temperatures [degrees C] of a sheet where none is given.
const USUAL: [f64; 9] = [0.0, 20.0, 40.0, 60.0, 80.0, 100.0, 120.0, 140.0, 150.0];
/// Temperatures [degrees C] between which such oils are liquids.
const LEAST: f64 = -40.0;
const GREATEST: f64 = 250.0;

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

/// Why there is no sheet.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum NoSheet {
    /// The grade is not known.
    #[error("\"{name}\" is not a known grade")]
    Grade {
        /// The name given.
        name: String,
        /// The known name nearest to it.
        near: Option<&'static str>,
    },
    /// The oil is not a liquid at this temperature.
    #[error("{} is not between {LEAST} C and {GREATEST} C", celsius(*temperature))]
    Temperature {
        /// The temperature given [K].
        temperature: f64,
    },
}

impl OilSheet {
    /// The sheet of the grade `name`, at a temperature [K] or at usual ones.
    ///
    /// # Errors
    /// The grade is not known, or not a liquid at that temperature.
    pub fn of(name: &str, at: Option<f64>) -> Result<Self, NoSheet> {
        let grade = Grade::named(name);
        let (grade, oil) = grade.and_then(|grade| Some((grade, grade.oil()?))).ok_or_else(|| NoSheet::Grade {
            name: name.to_owned(),
            near: nearest(name, GRADES.iter().map(|grade| grade.name)),
        })?;
        let range = LEAST + ZERO_CELSIUS..=GREATEST + ZERO_CELSIUS;
        let temperatures = match at {
            None => USUAL.map(|celsius| celsius + ZERO_CELSIUS).to_vec(),
            Some(temperature) if range.contains(&temperature) => vec![temperature],
            Some(temperature) => return Err(NoSheet::Temperature { temperature }),
        };
        let rows = temperatures.into_iter().map(|temperature| OilAt {
            temperature: temperature - ZERO_CELSIUS,
            kinematic_viscosity: oil.kinematic_viscosity(temperature),
            viscosity: oil.viscosity(temperature),
            density: oil.density.at(temperature),
        });
        Ok(Self { format: OIL_FORMAT, grade: grade.name, source: source(&grade), at: rows.collect() })
    }
}

/// Source of the numbers of a grade.
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

/// The value without the rounding of a tenth.
fn tidy(value: f64) -> f64 {
    format!("{value:.5e}").parse().unwrap_or(value)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_sheet_gives_the_points_back() {
        let sheet = OilSheet::of("10w-40", Some(313.15)).expect("a sheet");
        let [at] = sheet.at[..] else { panic!("one row") };
        assert!((at.kinematic_viscosity - 95e-6).abs() < 1e-15 && (at.temperature - 40.0).abs() < 1e-9);
        assert!((at.viscosity - at.kinematic_viscosity * at.density).abs() < 1e-15);
        assert!(sheet.source.contains("SAE J300 is 12.5 to 16.3 mm2/s at 100 C"), "{}", sheet.source);
        let usual = OilSheet::of("VG 46", None).expect("a sheet");
        assert!(usual.at.len() == USUAL.len() && usual.source.contains("41.4 to 50.6 mm2/s at 40 C"));
        assert!(crate::json(&usual).expect("JSON").contains("\"grade\": \"ISO VG 46\""));
    }

    #[test]
    fn unknown_grades_and_vapours_have_no_sheet() {
        let near = |name: &str| match OilSheet::of(name, None) {
            Err(NoSheet::Grade { near, .. }) => near,
            other => panic!("{other:?}"),
        };
        assert_eq!((near("SAE 10W-41"), near("honey")), (Some("SAE 10W-40"), None));
        let error = OilSheet::of("VG 46", Some(80.0)).expect_err("too cold");
        assert!(error.to_string().starts_with("-193.15 C is not between -40 C and 250 C"), "{error}");
    }
}
