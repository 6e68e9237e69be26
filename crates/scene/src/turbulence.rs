//! `[turbulence]`: a film that is no longer laminar.

use crate::oil::pressure_law_keys;
use crate::reader::TableReader;
use crate::{Complaints, Scene, TheoryKey};

keys! {
    "turbulence" = Table; "", "the film is laminar, however fast it flows", "",
        "the resistance and shear of a turbulent film, by its Reynolds number at each place";
    "turbulence.model" = Choice(&["ng-pan", "constantinescu", "reichardt"]); "ng-pan", "required", "",
        "how resistance and shear grow with `Re = rho U h/mu`: Ng and Pan's eddy viscosity, or Constantinescu's mixing length, each by its usual fits; with `heat.field` Reichardt's eddies at each place across the film, which carry heat too";
}

/// Models by their names in scenes.
const MODELS: [(&str, Turbulence); 3] = [
    ("ng-pan", Turbulence::NgPan),
    ("constantinescu", Turbulence::Constantinescu),
    ("reichardt", Turbulence::Reichardt),
];

/// How the film resists more than a laminar one.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Turbulence {
    /// Ng and Pan's linearised theory of eddy viscosity.
    NgPan,
    /// Constantinescu's theory of a mixing length.
    Constantinescu,
    /// Reichardt's eddies across the film, which carry heat too.
    Reichardt,
}

pub(crate) fn read(mut table: TableReader<'_>) -> Option<Turbulence> {
    if !table.has("model") && table.is_readable() {
        table.complain(
            "model",
            "is missing",
            "write model = \"ng-pan\" or \"constantinescu\", or \"reichardt\" beside heat.field",
        );
    }
    table.word("model", &MODELS)
}

/// What has no theory beside a turbulent film.
pub(crate) fn check(scene: &Scene, complaints: &mut Complaints) {
    if scene.turbulence.is_none() {
        return;
    }
    complaints.refuse_if(
        scene.bearing.theory != TheoryKey::Full,
        "bearing.theory",
        "leaves out one of the flows that turbulence resists, by closed forms of laminar films",
        "remove it, or remove [turbulence]",
    );
    for key in pressure_law_keys() {
        complaints.refuse_if(
            complaints.has(&key),
            &key,
            "changes the Reynolds number of a turbulent film with its pressure, which is not computed",
            "remove it: such films are fast rather than highly loaded; or remove [turbulence]",
        );
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::tests::{STUDY, read};

    #[test]
    fn models_are_read_and_what_has_no_theory_is_refused() {
        let law = ", barus = { alpha = \"2.5e-8 1/Pa\" }";
        let text = format!("{STUDY}\n[turbulence]\nmodel = \"ng-pan\"\n");
        let error = read(&text).expect_err("a law of pressure").to_string();
        assert!(error.contains("oil.barus: changes the Reynolds number"), "{error}");
        let plain = text.replace(law, "");
        assert_eq!(read(&plain).map(|scene| scene.turbulence).ok(), Some(Some(Turbulence::NgPan)));
        let other = plain.replace("ng-pan", "constantinescu");
        assert_eq!(read(&other).map(|scene| scene.turbulence).ok(), Some(Some(Turbulence::Constantinescu)));
        for (more, wanted) in [("model = \"hirs\"", "turbulence.model"), ("", "turbulence.model: is missing")] {
            let error = read(&plain.replace("model = \"ng-pan\"", more)).expect_err(more).to_string();
            assert!(error.contains(wanted), "{error}");
        }
    }
}
