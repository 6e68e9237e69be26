//! The table of effects: one row each, in a file of its own, that knows everything about its effect but the physics.
//!
//! An effect fills a socket of the film ([`Sockets`]). Compilation, the list of what is simulated, the cost of effects,
//! and warnings about limits of validity are loops over [`EFFECTS`]; no other code knows an effect by name.

mod barus;
pub mod bearing_theory;
mod closure;
mod contact;
mod couette;
mod dynamics;
mod elastic_liner;
mod equilibrium;
mod groove_depth;
mod guembel;
mod heat;
mod heat_field;
mod jfo;
mod moment_balance;
mod oil_by_temperature;
mod orbit;
mod poiseuille;
mod reynolds;
mod roelands;
mod roughness;
mod shapes;
pub(crate) mod sockets;
mod squeeze;
mod starved_inlet;
mod surface;
mod tilt;
mod turbulence;

use std::borrow::Cow;

use oilwedge_scene::Scene;
use serde::{Deserialize, Deserializer, Serialize, Serializer};

use crate::film::Film;
use crate::measure::Measured;
use crate::warning::Warning;
pub use jfo::without_conservation;
pub use sockets::{Contribution, PressureRule, ShapedSurface, Socket, Sockets};

/// All effects, in the order in which the sockets are filled.
pub const EFFECTS: &[&Effect] = &[
    &bearing_theory::SHORT,
    &bearing_theory::LONG,
    &poiseuille::ROW,
    &couette::ROW,
    &squeeze::ROW,
    &equilibrium::ROW,
    &orbit::ROW,
    &moment_balance::ROW,
    &elastic_liner::ROW,
    &heat::ROW,
    &heat_field::ROW,
    &oil_by_temperature::ROW,
    &barus::CONSERVATIVE,
    &barus::AS_PRINTED,
    &roelands::ROW,
    &groove_depth::ROW,
    &tilt::ROW,
    &shapes::ROW,
    &starved_inlet::ROW,
    &guembel::ROW,
    &reynolds::ROW,
    &jfo::ROW,
    &contact::ROW,
    &roughness::ROW,
    &turbulence::ROW,
    &dynamics::ROW,
];

/// What a film may leave out and a reader may miss, in the order of reports.
const MISSED: &[&str] = &[
    couette::KIND,
    VISCOSITY_BY_PRESSURE,
    CAVITATION,
    heat::KIND,
    squeeze::KIND,
    tilt::KIND,
    shapes::KIND,
    elastic_liner::KIND,
    ROUGHNESS,
    turbulence::KIND,
];
/// Kind of all laws of viscosity against pressure.
const VISCOSITY_BY_PRESSURE: &str = "viscosity growing with pressure";
/// Kind of all that roughness does.
const ROUGHNESS: &str = "roughness";
/// Kind of all closures.
const CAVITATION: &str = "cavitation";

/// One effect.
#[derive(Debug, Clone, Copy)]
pub struct Effect {
    /// Name in reports, as `cavitation: jfo`.
    pub name: &'static str,
    /// What it does, in a sentence.
    pub sentence: &'static str,
    /// What it is an entry of.
    pub socket: Socket,
    /// What is listed as not simulated where no effect of this kind is in the scene.
    kind: &'static str,
    /// Whether it is in a scene.
    is_in: fn(&Scene) -> bool,
    /// Puts it into its socket.
    install: fn(&Scene, &mut Sockets),
    /// What stands in its place where it is taken out.
    pub instead: &'static str,
    /// The scene without it; `None` where leaving it out asks another question.
    pub remove: fn(&Scene) -> Option<Scene>,
    /// Why forces are not in proportion to the rates of the journal's motions with it: a key of the scene, what is
    /// wrong with it, the way out; `None` where they may be.
    pub no_proportion: Option<[&'static str; 3]>,
    /// Warnings, in sentences, about films outside its limits of validity.
    warnings: fn(&Film, &Measured) -> Vec<Warning>,
}

/// An effect without properties.
const BLANK: Effect = Effect {
    name: "",
    sentence: "",
    socket: Socket::Terms,
    kind: "",
    is_in: |_| true,
    install: |_, _| (),
    instead: "",
    remove: |_| None,
    no_proportion: None,
    warnings: |_, _| Vec::new(),
};

/// The effects that are in a scene.
pub fn present(scene: &Scene) -> impl Iterator<Item = &'static Effect> + '_ {
    EFFECTS.iter().copied().filter(|effect| (effect.is_in)(scene))
}

/// Warnings of all effects of a film about their limits of validity.
pub fn warnings(film: &Film, measured: &Measured) -> Vec<Warning> {
    named(&film.model.effects).flat_map(|effect| (effect.warnings)(film, measured)).collect()
}

/// The effects of these names, in the order of the table.
fn named<'a>(names: &'a [&'static str]) -> impl Iterator<Item = &'static Effect> + 'a {
    EFFECTS.iter().copied().filter(|effect| names.contains(&effect.name))
}

impl Sockets {
    /// The sockets that the effects of a scene fill.
    pub fn of(scene: &Scene) -> Self {
        let mut sockets = Self::empty();
        present(scene).for_each(|effect| (effect.install)(scene, &mut sockets));
        sockets
    }
}

/// The scene with `change` made to a copy of it.
fn changed(scene: &Scene, change: impl FnOnce(&mut Scene)) -> Option<Scene> {
    let mut scene = scene.clone();
    change(&mut scene);
    Some(scene)
}

impl PartialEq for Effect {
    fn eq(&self, other: &Self) -> bool {
        self.name == other.name
    }
}

impl Eq for Effect {}

impl PartialEq<&str> for &Effect {
    fn eq(&self, name: &&str) -> bool {
        self.name == *name
    }
}

impl Serialize for Effect {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(self.name)
    }
}

/// Effects by their names; those that this version of the program does not have are left out.
fn known<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Vec<&'static Effect>, D::Error> {
    let names = Vec::<String>::deserialize(deserializer)?;
    Ok(names.iter().filter_map(|name| EFFECTS.iter().copied().find(|effect| effect.name == name)).collect())
}

/// What was computed and what was left out.
#[derive(Debug, Clone, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(default)]
pub struct Effects {
    /// Effects that are simulated, in the order of the sockets; those that close around the film and those that are
    /// asked of it stand last.
    #[serde(deserialize_with = "known")]
    pub simulated: Vec<&'static Effect>,
    /// Names of effects that are not simulated, in the order of reports.
    pub not_simulated: Vec<Cow<'static, str>>,
}

impl Effects {
    /// The effects of these names.
    pub fn of(names: &[&'static str]) -> Self {
        let mut simulated: Vec<&Effect> = named(names).collect();
        simulated.sort_by_key(|effect| (effect.socket == Socket::Analysis, effect.socket.is_balance()));
        let is_missed = |kind: &&str| simulated.iter().all(|effect| effect.kind != *kind);
        let not_simulated = MISSED.iter().copied().filter(is_missed).map(Cow::from).collect();
        Self { simulated, not_simulated }
    }

    /// Whether one of them is an entry of this socket.
    pub fn fill(&self, socket: Socket) -> bool {
        self.simulated.iter().any(|effect| effect.socket == socket)
    }
}

#[cfg(test)]
mod tests {
    use super::EFFECTS;

    #[test]
    fn every_effect_has_a_name_of_its_own_and_a_sentence() {
        for (number, effect) in EFFECTS.iter().enumerate() {
            assert!(!effect.name.is_empty() && !effect.sentence.is_empty(), "{effect:?}");
            assert!(EFFECTS[..number].iter().all(|other| other != effect), "{}", effect.name);
        }
    }
}
