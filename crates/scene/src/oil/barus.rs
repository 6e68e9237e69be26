//! `[oil.barus]`: a viscosity that grows exponentially with pressure.

use super::{PressureLawTable, THINNER};
use crate::reader::TableReader;
use crate::{Complaints, Scene};

keys! {
    "oil.barus" = Table; "", "constant viscosity", "",
        "viscosity that grows exponentially with pressure, mu = mu0 exp(alpha p)";
    "oil.barus.alpha" = Quantity(InversePressure); "2.5e-8 1/Pa", "required", ">= 0",
        "alpha of mu = mu0 exp(alpha p)";
    "oil.barus.form" = Choice(&["conservative", "as-printed"]); "conservative", "`\"conservative\"`", "",
        "where mu(p) stands: under the divergence, a balance of mass; or on the right-hand side as the FlexPDE study prints it, which is none";
}

/// Barus' law: mu = mu0 exp(alpha p).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BarusTable {
    /// Pressure-viscosity coefficient alpha [1/Pa], not negative.
    pub alpha: f64,
    /// Form of the equation that is solved.
    pub form: BarusForm,
}

/// Place of the viscosity in Reynolds' equation with Barus' law.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum BarusForm {
    /// The viscosity stands under the divergence: a balance of mass.
    #[default]
    Conservative,
    /// The viscosity stands on the right-hand side, div(h^3 grad p) = 12 mu(p) (...), as the FlexPDE study prints it.
    AsPrinted,
}

pub(super) fn read(mut table: TableReader<'_>) -> PressureLawTable {
    let help = "give a value that is not negative, about 1e-8 to 4e-8 1/Pa for mineral oil";
    let alpha = table.number("alpha");
    let alpha = alpha.within(THINNER, help).required();
    let forms = [("conservative", BarusForm::Conservative), ("as-printed", BarusForm::AsPrinted)];
    let form = table.word("form", &forms).unwrap_or_default();
    PressureLawTable::Barus(BarusTable { alpha, form })
}

/// A cavity that conserves oil needs an equation that does.
pub(super) fn check(scene: &Scene, complaints: &mut Complaints) {
    let is_printed =
        matches!(scene.oil.pressure_law, PressureLawTable::Barus(BarusTable { form: BarusForm::AsPrinted, .. }));
    let model = scene.cavitation.map_or("", |it| it.model.name());
    complaints.refuse_if(
        is_printed && scene.conserves_oil(),
        "oil.barus.form",
        format!(
            "is the as-printed equation, which is no balance of mass, and cavitation.model = \"{model}\" needs one"
        ),
        "remove form (the equation is conservative then), or take cavitation.model = \"reynolds\"",
    );
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::tests::{STUDY, good, read, told_one};

    #[test]
    fn the_law_is_read_and_checked() {
        told_one("1/Pa\"", "1/Pa\", form = \"printed\"", "oil.barus.form: \"printed\" is not known");
        good::told_one("2.5e-8", "-2.5e-8", "oil.barus.alpha: is negative");
        let text = STUDY.replace("1/Pa\"", "1/Pa\", form = \"as-printed\"");
        let (alpha, form) = (2.5e-8, BarusForm::AsPrinted);
        let law = read(&text).map(|scene| scene.oil.pressure_law).ok();
        assert_eq!(law, Some(PressureLawTable::Barus(BarusTable { alpha, form })));
    }

    #[test]
    fn a_cavity_that_conserves_oil_needs_an_equation_that_does() {
        let printed = ("1/Pa\"", "1/Pa\", form = \"as-printed\"");
        for model in ["none", "guembel", "reynolds"] {
            let scene = good::with(&[printed, ("guembel", model)]);
            assert!(scene.is_ok(), "{model}: {scene:?}");
        }
        let error = good::with(&[printed, ("guembel", "jfo")]).expect_err("no balance").to_string();
        let message = "oil.barus.form: is the as-printed equation, which is no balance of mass, and cavitation.model = \"jfo\" needs one";
        assert!(
            error.contains(message) && error.contains("(remove form (the equation is conservative then), or take"),
            "{error}"
        );
    }
}
