//! `field` of `[heat]`: the temperature as a field in the film, in the bush around it, and in the journal.

use crate::reader::TableReader;
use crate::{Complaints, Scene, TheoryKey, Turbulence};

keys! {
    "heat.field" = Switch; "true", "`false`: the film has one temperature", "with the cavitation model `jfo`",
        "whether the temperature is found at each place of the film and across it, with that of bush, journal and feeds";
    "heat.layers" = Number; "6", "4, 6 or 8 by the Graetz number of the film; 6 or 8 beside an adiabatic bush; 8 of a turbulent film", "whole, 4, 6 or 8",
        "layers N between bush and journal: temperatures stand at N + 1 points across the film";
    "heat.bush" = Table; "", "adiabatic: no heat goes through the bore", "",
        "a ring around the film that conducts heat; its ends are insulated";
    "heat.bush.outer_diameter" = Quantity(Length); "100 mm", "required", "> 0, above the bore",
        "outer diameter of the ring";
    "heat.bush.conductivity" = Quantity(ThermalConductivity); "45 W/(m.K)", "required", "> 0",
        "heat conductivity of the ring";
    "heat.bush.transfer" = Quantity(HeatTransfer); "80 W/(m2.K)", "required", "> 0",
        "heat transfer coefficient on its outer surface";
    "heat.bush.ambient" = Quantity(Temperature); "40 C", "required", "-60 to 350 C",
        "temperature around the ring";
    "heat.journal" = Table; "", "no heat leaves by the shaft", "",
        "heat that leaves the film along the shaft";
    "heat.journal.conductance" = Quantity(Conductance); "2 W/K", "required", "> 0",
        "heat conductance along the shaft, from the journal to its surroundings";
    "heat.journal.ambient" = Quantity(Temperature); "40 C", "required", "-60 to 350 C",
        "temperature of these surroundings";
    "heat.expansion" = Table; "", "the clearance is that of the scene", "",
        "how the clearance changes as journal and bush grow warm: c + R (a_bush (T_bush - t) - a_shaft (T_journal - t))";
    "heat.expansion.shaft" = Quantity(InverseTemperature); "1.15e-5 1/K", "required", "0 to 1e-3 1/K",
        "coefficient of expansion of the journal a_shaft";
    "heat.expansion.bush" = Quantity(InverseTemperature); "1.15e-5 1/K", "required", "0 to 1e-3 1/K",
        "coefficient of expansion of the bush a_bush";
    "heat.expansion.at" = Quantity(Temperature); "20 C", "required", "-60 to 350 C",
        "temperature t at which the clearance of the scene is measured";
}

/// Keys that have a meaning with `field` alone.
const OF_FIELD: [&str; 4] = ["layers", "bush", "journal", "expansion"];
/// Layers that there may be.
const LAYERS: [f64; 3] = [4.0, 6.0, 8.0];

/// The temperature as a field.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct HeatField {
    /// Layers between bush and journal; `None`: as many as the film asks for.
    pub layers: Option<usize>,
    /// The ring around the film; `None`: adiabatic.
    pub bush: Option<HeatBush>,
    /// Heat that leaves along the shaft; `None`: none does.
    pub journal: Option<HeatJournal>,
    /// Change of the clearance by the temperatures of the walls; `None`: it does not change.
    pub expansion: Option<HeatExpansion>,
}

/// A ring that conducts heat.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct HeatBush {
    /// Outer diameter [m].
    pub outer_diameter: f64,
    /// Heat conductivity [W/(m K)].
    pub conductivity: f64,
    /// Heat transfer coefficient outside [W/(m2 K)].
    pub transfer: f64,
    /// Temperature around it [K].
    pub ambient: f64,
}

/// Heat that leaves along the shaft.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct HeatJournal {
    /// Heat conductance [W/K].
    pub conductance: f64,
    /// Temperature of the surroundings [K].
    pub ambient: f64,
}

/// Expansion of the walls.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct HeatExpansion {
    /// Coefficient of the journal [1/K].
    pub shaft: f64,
    /// Coefficient of the bush [1/K].
    pub bush: f64,
    /// Temperature at which the clearance is measured [K].
    pub at: f64,
}

/// The field, if the table asks for one.
pub(super) fn read(table: &mut TableReader<'_>) -> Option<HeatField> {
    let is_asked = table.switch("field").unwrap_or(false);
    let layers = table.number("layers");
    let layers = layers.which(
        |layers| LAYERS.contains(&layers),
        "is not 4, 6 or 8",
        "remove it, or give 6 or 8 where the film conducts little",
    );
    let layers = layers.given().filter(|layers| !layers.is_nan());
    let field = HeatField {
        layers: layers.map(|layers| layers as usize),
        bush: table.table_if_given("bush").map(bush),
        journal: table.table_if_given("journal").map(journal),
        expansion: table.table_if_given("expansion").map(expansion),
    };
    for key in OF_FIELD.into_iter().filter(|_| !is_asked) {
        let help = "write field = true beside it, or remove it";
        table.refuse_if(table.has(key), key, "has a meaning only with field = true", help);
    }
    is_asked.then_some(field)
}

fn bush(mut table: TableReader<'_>) -> HeatBush {
    HeatBush {
        outer_diameter: table.required("outer_diameter"),
        conductivity: table.required("conductivity"),
        transfer: table.required("transfer"),
        ambient: table.oil_temperature("ambient").required(),
    }
}

fn journal(mut table: TableReader<'_>) -> HeatJournal {
    HeatJournal { conductance: table.required("conductance"), ambient: table.oil_temperature("ambient").required() }
}

fn expansion(mut table: TableReader<'_>) -> HeatExpansion {
    let mut coefficient = |key| {
        let help = "give the coefficient of linear expansion, some 1.15e-5 1/K for steel";
        table.number(key).within("is not a coefficient of expansion", help).required()
    };
    let [shaft, bush] = ["shaft", "bush"].map(&mut coefficient);
    HeatExpansion { shaft, bush, at: table.oil_temperature("at").required() }
}

/// What a field needs, and what has no meaning beside it.
pub(super) fn check(scene: &Scene, complaints: &mut Complaints) {
    let field = scene.heat.and_then(|heat| heat.field);
    complaints.refuse_if(
        scene.turbulence == Some(Turbulence::Reichardt) && field.is_none(),
        "turbulence.model",
        "finds eddies by the temperatures across the film, but the film has one temperature",
        "write model = \"ng-pan\", which fits the same eddies, or give heat.field = true",
    );
    let Some(field) = field else { return };
    let closure = scene.cavitation.map(|cavitation| cavitation.model);
    complaints.refuse_if(
        !closure.is_some_and(crate::CavitationModel::conserves_oil),
        "heat.field",
        "needs a film that conserves oil: other models of cavitation make oil that would carry heat",
        "give [cavitation] the model jfo, or remove field",
    );
    for (key, help) in [
        ("heat.housing", "give heat.bush, the ring around the film, or remove field"),
        ("heat.mixing", "remove it: with field each feed mixes what flows in and out of it, or remove field"),
    ] {
        complaints.refuse_if(complaints.has(key), key, "has no meaning beside heat.field", help);
    }
    complaints.refuse_if(
        scene.bearing.theory != TheoryKey::Full,
        "bearing.theory",
        "leaves out flows that carry heat",
        "remove it, or remove heat.field",
    );
    complaints.refuse_if(
        scene.turbulence.is_some_and(|model| model != Turbulence::Reichardt),
        "turbulence.model",
        "has no eddies across the film, which mix the heat of its layers",
        "write model = \"reichardt\", or remove heat.field: the film has one temperature then",
    );
    let Some(bush) = field.bush else { return };
    complaints.refuse_if(
        scene.bearing.arc.is_some(),
        "heat.bush",
        "is a whole ring, but this bearing has an arc",
        "remove it: the shell is adiabatic then",
    );
    complaints.refuse_if(
        bush.outer_diameter <= 2.0 * scene.bearing.radius(),
        "heat.bush.outer_diameter",
        "is not above the diameter of the bearing",
        "give the outer diameter of the ring around the film",
    );
}
