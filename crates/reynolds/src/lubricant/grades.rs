//! # Grades: typical oils of the classes by which oils are sold
//!
//! **Equation.** `nu(T)` by [`Walther`] through nu at 40 and at 100 degrees C; `rho(T)` by [`Density`] from that at 15
//! degrees C. A class is a window: of nu at 100 degrees C for engine oils, of nu at 40 degrees C within 10 % for ISO
//! VG. **What stands here is one typical oil of its class**, not the class: another one differs by some 10 %, and its
//! data sheet is better.
//!
//! | symbol | unit | code |
//! |---|---|---|
//! | nu_40, nu_100 | mm2/s | `nu_40`, `nu_100` |
//! | rho_15 | kg/m3 | `rho_15` |
//!
//! **Source.** Windows: SAE J300 (2021), table 1 (low-shear kinematic viscosity at 100 degrees C); ISO 3448 (1992).
//! Values: typical of data sheets of mineral (20W-50, 15W-40, monogrades, ISO VG, viscosity index 95 to 100) and
//! synthetic oils (0W, 5W). **Range.** Fresh oils at low shear: multigrade oils lose some 20 to 30 % at the shear rates
//! of engine bearings, which J300 limits by the viscosity at 150 degrees C.
//! **Verified by** `every_grade_lies_in_the_window_of_its_class` and `indices_are_those_of_such_oils` below.

use super::density::{EXPANSION, ZERO_CELSIUS};
use super::{Density, TemperatureLaw, ThermalOil, Walther};

/// A typical oil of a class.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Grade {
    /// Name of the class, as `SAE 10W-40`.
    pub name: &'static str,
    /// Kinematic viscosity [mm2/s] at 40 degrees C.
    pub nu_40: f64,
    /// Kinematic viscosity at 100 degrees C.
    pub nu_100: f64,
    /// Density [kg/m3] at 15 degrees C.
    pub rho_15: f64,
    /// The window of its class.
    pub window: Window,
}

/// The window of a class: `least <= nu < most` [mm2/s].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Window {
    /// The standard.
    pub standard: &'static str,
    /// Temperature [degrees C] at which the class is measured.
    pub celsius: f64,
    /// Least kinematic viscosity [mm2/s].
    pub least: f64,
    /// Kinematic viscosity [mm2/s] that is not reached (ISO VG: reached at most).
    pub most: f64,
}

const fn sae(name: &'static str, [nu_40, nu_100]: [f64; 2], rho_15: f64, [least, most]: [f64; 2]) -> Grade {
    let window = Window { standard: "SAE J300", celsius: 100.0, least, most };
    Grade { name, nu_40, nu_100, rho_15, window }
}

const fn iso(name: &'static str, [nu_40, nu_100]: [f64; 2], rho_15: f64) -> Grade {
    let window = Window { standard: "ISO 3448", celsius: 40.0, least: 0.9 * nu_40, most: 1.1 * nu_40 };
    Grade { name, nu_40, nu_100, rho_15, window }
}

const SAE_16: [f64; 2] = [6.1, 8.2];
const SAE_20: [f64; 2] = [6.9, 9.3];
const SAE_30: [f64; 2] = [9.3, 12.5];
const SAE_40: [f64; 2] = [12.5, 16.3];
const SAE_50: [f64; 2] = [16.3, 21.9];
const SAE_60: [f64; 2] = [21.9, 26.1];

/// All grades.
pub const GRADES: [Grade; 31] = [
    sae("SAE 0W-16", [36.0, 7.2], 843.0, SAE_16),
    sae("SAE 0W-20", [44.0, 8.4], 845.0, SAE_20),
    sae("SAE 0W-30", [55.0, 10.2], 846.0, SAE_30),
    sae("SAE 0W-40", [75.0, 13.5], 848.0, SAE_40),
    sae("SAE 5W-20", [48.0, 8.5], 852.0, SAE_20),
    sae("SAE 5W-30", [66.0, 11.3], 853.0, SAE_30),
    sae("SAE 5W-40", [85.0, 14.0], 855.0, SAE_40),
    sae("SAE 10W-30", [69.0, 10.6], 870.0, SAE_30),
    sae("SAE 10W-40", [95.0, 14.3], 870.0, SAE_40),
    sae("SAE 15W-40", [108.0, 14.5], 880.0, SAE_40),
    sae("SAE 20W-50", [160.0, 18.0], 887.0, SAE_50),
    sae("SAE 20", [58.0, 8.0], 883.0, SAE_20),
    sae("SAE 30", [93.0, 10.8], 888.0, SAE_30),
    sae("SAE 40", [138.0, 14.2], 892.0, SAE_40),
    sae("SAE 50", [205.0, 18.6], 897.0, SAE_50),
    sae("SAE 60", [300.0, 24.0], 900.0, SAE_60),
    iso("ISO VG 10", [10.0, 2.6], 850.0),
    iso("ISO VG 15", [15.0, 3.4], 855.0),
    iso("ISO VG 22", [22.0, 4.3], 862.0),
    iso("ISO VG 32", [32.0, 5.4], 868.0),
    iso("ISO VG 46", [46.0, 6.8], 873.0),
    iso("ISO VG 68", [68.0, 8.7], 878.0),
    iso("ISO VG 100", [100.0, 11.3], 882.0),
    iso("ISO VG 150", [150.0, 14.8], 887.0),
    iso("ISO VG 220", [220.0, 19.1], 892.0),
    iso("ISO VG 320", [320.0, 24.3], 896.0),
    iso("ISO VG 460", [460.0, 30.7], 901.0),
    iso("ISO VG 680", [680.0, 39.0], 907.0),
    iso("ISO VG 1000", [1000.0, 49.5], 914.0),
    iso("ISO VG 1500", [1500.0, 64.0], 922.0),
    iso("ISO VG 2200", [2200.0, 83.0], 930.0),
];

impl Grade {
    /// True of a multigrade oil, as `SAE 5W-30`, whose polymers yield to shear.
    pub fn is_multigrade(&self) -> bool {
        self.name.contains("W-")
    }

    /// The grade of this name; letter case, spaces and hyphens do not count, nor does a missing `SAE` or `ISO`.
    pub fn named(name: &str) -> Option<Self> {
        let wanted = folded(name);
        let is_meant = |grade: &&Self| {
            let own = folded(grade.name);
            let short = own.trim_start_matches("SAE").trim_start_matches("ISO");
            own == wanted || short == wanted && short.contains(|letter: char| letter.is_alphabetic())
        };
        GRADES.iter().find(is_meant).copied()
    }

    /// The oil by temperature.
    pub fn oil(self) -> Option<ThermalOil> {
        let at = |celsius: f64, nu: f64| (ZERO_CELSIUS + celsius, 1e-6 * nu);
        Some(ThermalOil {
            law: TemperatureLaw::Walther(Walther::through(at(40.0, self.nu_40), at(100.0, self.nu_100))?),
            density: Density::of(self.rho_15, ZERO_CELSIUS + 15.0, EXPANSION),
            sheared: 1.0,
        })
    }
}

fn folded(name: &str) -> String {
    let letters = name.chars().filter(|letter| letter.is_alphanumeric());
    letters.flat_map(char::to_uppercase).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_grade_lies_in_the_window_of_its_class() {
        for grade in GRADES {
            let window = grade.window;
            let nu = if window.celsius == 40.0 { grade.nu_40 } else { grade.nu_100 };
            assert!(nu >= window.least && nu < window.most, "{}", grade.name);
            let oil = grade.oil().expect(grade.name);
            let back = oil.kinematic_viscosity(ZERO_CELSIUS + window.celsius);
            assert!((1e6 * back / nu - 1.0).abs() < 1e-12, "{}: {back}", grade.name);
            if let Some(number) = grade.name.strip_prefix("ISO VG ") {
                assert_eq!(number.parse(), Ok(grade.nu_40));
            }
            assert!((840.0..940.0).contains(&grade.rho_15));
        }
    }

    #[test]
    fn names_are_found_as_they_are_written() {
        for (written, name) in [
            ("SAE 10W-40", Some("SAE 10W-40")),
            ("sae 10w40", Some("SAE 10W-40")),
            ("10W/40", Some("SAE 10W-40")),
            ("VG 46", Some("ISO VG 46")),
            ("iso-vg-46", Some("ISO VG 46")),
            ("SAE 30", Some("SAE 30")),
            ("30", None),
            ("", None),
            ("10W-41", None),
        ] {
            assert_eq!(Grade::named(written).map(|grade| grade.name), name, "{written}");
        }
        let mut names: Vec<_> = GRADES.iter().map(|grade| grade.name).collect();
        names.sort_unstable();
        names.dedup();
        assert_eq!(names.len(), GRADES.len());
    }

    /// Viscosity index after ASTM D2270, up to 100: with L and H of oils of index 0 and 100 that are as viscous at 100
    /// degrees C it is `100 (L - nu_40)/(L - H)`. Mineral oils of today have some 95 to 105.
    #[test]
    fn indices_are_those_of_such_oils() {
        for (name, low, high) in
            [("ISO VG 32", 47.31, 32.37), ("ISO VG 46", 73.46, 46.41), ("ISO VG 100", 182.11, 98.97)]
        {
            let grade = Grade::named(name).expect(name);
            let index = 100.0 * (low - grade.nu_40) / (low - high);
            assert!((95.0..105.0).contains(&index), "{name}: {index}");
        }
    }
}
