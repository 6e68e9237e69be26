//! Oils that there can be.

use oilwedge_reynolds::Form;
use oilwedge_reynolds::lubricant::density::ZERO_CELSIUS;
use oilwedge_reynolds::lubricant::{TemperatureLaw, ThermalOil};

use super::Checks;
use crate::lubricant::{form, lubricant};
use crate::scene::{PressureLaw, RoelandsExponent, Scene};
use crate::wording::celsius;

/// Temperatures [K] at which no film is of liquid oil.
pub(super) const LIQUID: [f64; 2] = [ZERO_CELSIUS - 60.0, ZERO_CELSIUS + 350.0];
/// Densities [kg/m3] of liquids that are used as oils.
const DENSITIES: [f64; 2] = [500.0, 2500.0];
/// A given pressure must be known from its reduced one to this part.
const LOST: f64 = 1e-6;
/// Greatest expansion [1/K] of one.
const MOST_EXPANSION: f64 = 2e-3;

impl Checks<'_> {
    pub(super) fn oil(&mut self, scene: &Scene) {
        let viscosity = scene.oil.viscosity;
        self.density(scene);
        let source = match &scene.oil.thermal {
            Some(thermal) => {
                self.law(thermal, scene);
                if scene.heat.is_some() {
                    "heat.inlet"
                } else {
                    "oil.temperature"
                }
            }
            None => {
                self.positive(viscosity, "oil.viscosity");
                "oil.viscosity"
            }
        };
        let reason = "is negative, so the oil would grow thinner under pressure";
        let help = "give a value that is not negative, about 1e-8 to 4e-8 1/Pa for mineral oil";
        match scene.oil.pressure_law {
            PressureLaw::Constant => {}
            PressureLaw::Barus { alpha, .. } => self.refuse_if(alpha < 0.0, "oil.barus.alpha", reason, help),
            PressureLaw::Roelands {
                exponent,
                reference_pressure,
            } => {
                self.positive(reference_pressure, "oil.roelands.reference_pressure");
                self.refuse_if(
                    viscosity > 0.0 && viscosity.ln() + 9.67 <= 0.0,
                    source,
                    "is below the range of Roelands' law, which needs ln(viscosity in Pa.s) + 9.67 > 0",
                    "give more than 0.0632 mPa.s (is it in mPa.s?), or take barus",
                );
                match exponent {
                    RoelandsExponent::Alpha(alpha) => self.refuse_if(alpha < 0.0, "oil.roelands.alpha", reason, help),
                    RoelandsExponent::Z(z) => {
                        let help = "give z >= 0, about 0.4 to 0.8 for mineral oil";
                        self.refuse_if(z < 0.0, "oil.roelands.z", reason, help);
                    }
                }
            }
        }
    }

    /// The equation is one of reduced pressures, all of which lie below the limit of the law; a pressure that rounding puts there is lost.
    pub(super) fn pressures(&mut self, scene: &Scene) {
        if form(&scene.oil) != Form::Conservative {
            return;
        }
        let law = lubricant(&scene.oil).pressure_law;
        let fed = scene.feeds.iter().enumerate();
        let fed = fed.filter_map(|(index, feed)| Some((format!("feed[{index}].pressure"), feed.pressure?)));
        for (key, pressure) in fed.chain([("ends.pressure".to_owned(), scene.ends.pressure)]) {
            let (told, ratio) = (
                law.pressure(law.reduced_pressure(pressure)),
                law.viscosity_ratio(pressure),
            );
            let is_lost = (told / pressure - 1.0).abs() > LOST;
            self.refuse_if(
                pressure > 0.0 && is_lost && !ratio.is_nan(),
                &key,
                format!(
                    "makes the oil {ratio:.1e} times as viscous, so near to solid that rounding hides the pressure"
                ),
                "give a lower pressure, or a law that grows slower (oil.roelands)",
            );
        }
    }

    fn density(&mut self, scene: &Scene) {
        let Some(density) = scene.oil.density else { return };
        let key = match self.marks.has("oil.density.value") {
            true => "oil.density.value",
            false => "oil.density",
        };
        let [least, most] = DENSITIES;
        self.refuse_if(
            density.at_20 < least || density.at_20 > most,
            key,
            format!("is no density of an oil: {least} to {most} kg/m3"),
            "give some 850 to 900 kg/m3 for mineral oil; is it in kg/m3?",
        );
        self.refuse_if(
            !(0.0..=MOST_EXPANSION).contains(&density.expansion) && !density.expansion.is_nan(),
            "oil.density.expansion",
            format!("is no expansion of an oil: 0 to {MOST_EXPANSION} 1/K"),
            "give some 65e-5 to 75e-5 1/K for mineral oil, or remove it",
        );
    }

    /// A law must have a meaning at the temperature of the film.
    fn law(&mut self, oil: &ThermalOil, scene: &Scene) {
        if let TemperatureLaw::Vogel(law) = &oil.law {
            self.positive(law.factor, "oil.vogel.a");
            let help = "give a constant that is not negative, some 600 to 1500 K for mineral oil";
            self.refuse_if(law.exponent < 0.0, "oil.vogel.b", "is negative", help);
        }
        let Some(temperature) = scene.oil.temperature.filter(|_| self.complaints.is_empty()) else {
            return;
        };
        let before = self.complaints.len();
        // Where the temperature is found the law must hold at that of the oil that is fed.
        let (temperature, key) = match &scene.heat {
            Some(heat) => (heat.inlet, "heat.inlet"),
            None => (temperature, "oil.temperature"),
        };
        match scene.heat.is_none() {
            true => self.temperature(temperature, key),
            // That is told of [heat].
            false if !(LIQUID[0]..=LIQUID[1]).contains(&temperature) => return,
            false => {}
        }
        match &oil.law {
            TemperatureLaw::Vogel(law) => {
                let message = format!(
                    "is not above {}, where Vogel's law has no meaning any more",
                    celsius(law.singular)
                );
                let help = "give a higher temperature, or a greater oil.vogel.c";
                self.refuse_if(temperature <= law.singular, key, message, help);
            }
            TemperatureLaw::Table(table) => {
                let [from, to] = table.range();
                let message = format!(
                    "lies outside oil.table, which reaches from {} to {}",
                    celsius(from),
                    celsius(to)
                );
                let help = "give a temperature within, or a point of the table beyond";
                let outside = temperature < from || temperature > to;
                self.refuse_if(outside, key, message, help);
            }
            TemperatureLaw::Walther(_) => {}
        }
        let viscosity = oil.viscosity(temperature);
        let none = (viscosity <= 0.0 || viscosity.is_infinite()) && self.complaints.len() == before;
        let help = "give a temperature at which the oil is a liquid, and check the numbers of its law";
        self.refuse_if(
            none,
            key,
            format!("leaves the oil a viscosity of {viscosity} Pa.s"),
            help,
        );
    }

    /// A temperature of oil.
    pub(super) fn temperature(&mut self, temperature: f64, key: &str) {
        let [least, most] = LIQUID;
        self.refuse_if(
            temperature < least || temperature > most,
            key,
            format!(
                "is {}, but oil films live between {} and {}",
                celsius(temperature),
                celsius(least),
                celsius(most)
            ),
            "give for example \"80 C\"; a value in K counts from the absolute zero",
        );
    }
}

#[cfg(test)]
mod tests {
    use crate::validate::tests::{told, told_one};

    #[test]
    fn pressures_that_make_oil_solid_are_refused() {
        let alpha = "2.5e-8 1/Pa";
        // The ends have 0.98 bar, the feed 1.96 bar.
        assert!(told(alpha, "1e-4 1/Pa").is_empty());
        told_one(
            alpha,
            "2e-4 1/Pa",
            "feed[0].pressure: makes the oil 1.1e17 times as viscous",
        );
    }

    const OIL: &str = "viscosity = \"0.4 Pa.s\"";

    #[test]
    fn laws_of_temperature_are_checked() {
        let vogel = |numbers: &str| format!("vogel = {{ {numbers} }}");
        let table = "table = [{ t = \"40 C\", nu = \"95 mm2/s\" }, { t = \"100 C\", nu = \"14 mm2/s\" }]";
        for (oil, temperature, wanted) in [
            (
                "grade = \"VG 46\"",
                "80 K",
                "oil.temperature: is -193.15 C, but oil films live between -60 C and 350 C",
            ),
            ("grade = \"VG 46\"", "500 C", "oil.temperature: is 500 C, but"),
            (
                &vogel("a = \"0 Pa.s\", b = \"900 K\", c = \"95 K\""),
                "80 C",
                "oil.vogel.a: is not positive",
            ),
            (
                &vogel("a = \"1 mPa.s\", b = \"-900 K\", c = \"95 K\""),
                "80 C",
                "oil.vogel.b: is negative",
            ),
            (
                &vogel("a = \"1 mPa.s\", b = \"900 K\", c = \"-90 K\""),
                "80 C",
                "oil.temperature: is not above 90 C, where Vogel's law",
            ),
            (
                &vogel("a = \"1 mPa.s\", b = \"90000000 K\", c = \"95 K\""),
                "80 C",
                "oil.temperature: leaves the oil a viscosity of inf Pa.s",
            ),
            (
                table,
                "39 C",
                "oil.temperature: lies outside oil.table, which reaches from 40 C to 100 C",
            ),
            (table, "101 C", "oil.temperature: lies outside oil.table"),
            (
                "density = \"0.9 kg/m3\"\ngrade = \"VG 46\"",
                "80 C",
                "oil.density: is no density of an oil",
            ),
            (
                "density = { value = \"9 kg/m3\" }\ngrade = \"VG 46\"",
                "80 C",
                "oil.density.value: is no density of an oil",
            ),
            (
                "density = { value = \"900 kg/m3\", expansion = \"1 1/K\" }\ngrade = \"VG 46\"",
                "80 C",
                "oil.density.expansion: is no expansion",
            ),
        ] {
            told_one(OIL, &format!("{oil}\ntemperature = \"{temperature}\""), wanted);
        }
        assert!(told(OIL, &format!("{table}\ntemperature = \"40 C\"")).is_empty());
        assert!(told(OIL, "grade = \"SAE 5W-30\"\ntemperature = \"120 C\"").is_empty());
        assert!(told(OIL, &format!("{OIL}\ndensity = \"900 kg/m3\"")).is_empty());
    }
}
