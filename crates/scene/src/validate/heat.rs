//! Heat balances that there can be.

use oilwedge_reynolds::Theory;

use super::Checks;
use crate::scene::{Mixing, Scene};

/// Heat capacities per volume [J/(m3 K)] of liquids that are used as oils.
const CAPACITIES: [f64; 2] = [5e5, 5e6];

impl Checks<'_> {
    pub(super) fn heat(&mut self, scene: &Scene) {
        let Some(heat) = &scene.heat else { return };
        let inlet = match self.marks.has("heat.inlet") {
            true => "heat.inlet",
            false => "heat.preset",
        };
        self.temperature(heat.inlet, inlet);
        let [least, most] = CAPACITIES;
        self.refuse_if(
            heat.heat_capacity < least || heat.heat_capacity > most,
            "heat.heat_capacity",
            format!("is no heat capacity of an oil: {least:e} to {most:e} J/(m3.K)"),
            "give some 1.8 MJ/(m3.K), density times specific heat, or remove it",
        );
        self.positive(heat.least_film, "heat.film_min");
        self.temperature(heat.greatest_temperature, "heat.temperature_max");
        if let Some(housing) = heat.housing {
            let key = match self.marks.has("heat.housing.conductance") {
                true => "heat.housing.conductance",
                false => "heat.housing.transfer",
            };
            self.positive(housing.conductance, key);
            self.temperature(housing.ambient, "heat.housing.ambient");
        }
        match heat.mixing {
            Some(Mixing::Ratio(ratio)) => self.refuse_if(
                ratio < 0.0,
                "heat.mixing.ratio",
                "is negative",
                "give hot oil over fresh oil, q_0/q_1, or remove mixing",
            ),
            Some(Mixing::Share(share)) => self.refuse_if(
                !(0.0..=1.0).contains(&share) && !share.is_nan(),
                "heat.mixing.share",
                "is not between 0 and 1",
                "give the share of the oil carried round that mixes with the fresh one, some 0.5 to 0.9",
            ),
            None => {}
        }
        self.refuse_if(
            scene.journal.speed == 0.0,
            "journal.speed",
            "is zero, so that nothing heats the oil",
            "give a speed, or remove [heat] and give oil.temperature",
        );
        self.refuse_if(
            scene.bearing.theory == Theory::Long && heat.housing.is_none(),
            "bearing.theory",
            "\"long\" seals the ends, so that no oil carries heat off",
            "give heat.housing, or another theory",
        );
    }
}

#[cfg(test)]
mod tests {
    use crate::validate::tests::{told, told_one};

    const OIL: &str = "[oil]\nviscosity = \"0.4 Pa.s\"";

    fn with(heat: &str) -> String {
        format!("[heat]\n{heat}\n[oil]\ngrade = \"SAE 30\"")
    }

    #[test]
    fn balances_are_checked() {
        assert!(told(OIL, &with("inlet = \"75 C\"")).is_empty());
        for (heat, wanted) in [
            ("inlet = \"75 K\"", "heat.inlet: is -198.15 C, but oil films"),
            (
                "inlet = \"75 C\"\nheat_capacity = \"1.8 kJ/(m3.K)\"",
                "heat.heat_capacity: is no heat capacity",
            ),
            (
                "inlet = \"75 C\"\nfilm_min = \"0 um\"",
                "heat.film_min: is not positive",
            ),
            (
                "inlet = \"75 C\"\ntemperature_max = \"500 C\"",
                "heat.temperature_max: is 500 C",
            ),
            (
                "inlet = \"75 C\"\nhousing = { conductance = \"0 W/K\", ambient = \"40 C\" }",
                "heat.housing.conductance: is not positive",
            ),
            (
                "inlet = \"75 C\"\nhousing = { transfer = \"-1 W/(m2.K)\", area = \"1 m2\", ambient = \"40 C\" }",
                "heat.housing.transfer: is not positive",
            ),
            (
                "inlet = \"75 C\"\nmixing = { ratio = -0.1 }",
                "heat.mixing.ratio: is negative",
            ),
            (
                "inlet = \"75 C\"\nmixing = { share = 1.1 }",
                "heat.mixing.share: is not between",
            ),
        ] {
            told_one(OIL, &with(heat), wanted);
        }
    }
}
