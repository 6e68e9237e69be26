//! `[contact]`: where rough surfaces touch, and what they carry there.

use crate::reader::TableReader;
use crate::{Complaints, Scene};

keys! {
    "contact" = Table; "", "the surfaces do not touch, however thin the film is", "",
        "where rough surfaces touch: they carry a part of the load there, and rub";
    "contact.model" = Choice(&["greenwood-tripp", "bearing-curve"]); "greenwood-tripp", "required", "",
        "how the pressure of contact depends on the gap: elastic asperities of Gaussian heights, with the roughness of `bearing.roughness`; or `H ((r - h)/r)^2` by a bearing curve";
    "contact.eta_beta_sigma" = Number; "0.05", "required with `greenwood-tripp`", "> 0",
        "asperities per area times radius of their tips times roughness, some 0.03 to 0.05";
    "contact.sigma_over_beta" = Number; "0.01", "required with `greenwood-tripp`", "> 0",
        "roughness over the radius of the tips, some 1e-4 to 0.01";
    "contact.modulus" = Quantity(Pressure); "115 GPa", "required with `greenwood-tripp`", "> 0",
        "modulus E' of both surfaces: `1/E' = (1 - nu_1^2)/E_1 + (1 - nu_2^2)/E_2`";
    "contact.depth" = Quantity(Length); "1.2 um", "required with `bearing-curve`", "> 0",
        "gap r of the mean planes at which the profiles begin to touch, greatest height of the profile over the root of two";
    "contact.hardness" = Quantity(Pressure); "900 MPa", "required", "> 0",
        "hardness of the softer surface: the pressure of contact nowhere exceeds it";
    "contact.friction" = Number; "0.1", "required", ">= 0",
        "friction coefficient of surfaces that touch, some 0.05 to 0.15 with oil between them";
}

/// Contact of journal and liner.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ContactTable {
    /// How its pressure depends on the gap.
    pub model: ContactModel,
    /// Hardness of the softer surface [Pa].
    pub hardness: f64,
    /// Friction coefficient [1].
    pub friction: f64,
}

/// How the pressure of contact depends on the gap.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum ContactModel {
    /// Greenwood and Tripp's asperities, with the roughness of the bearing.
    GreenwoodTripp {
        /// `eta beta sigma` [1].
        density: f64,
        /// `sigma/beta` [1].
        sharpness: f64,
        /// E' [Pa].
        modulus: f64,
    },
    /// A bearing curve.
    BearingCurve {
        /// Depth r [m].
        depth: f64,
    },
}

/// Names in scenes.
const MODELS: [(&str, bool); 2] = [(GREENWOOD_TRIPP, true), ("bearing-curve", false)];
const GREENWOOD_TRIPP: &str = "greenwood-tripp";

pub(crate) fn read(mut table: TableReader<'_>) -> Option<ContactTable> {
    if !table.has("model") && table.is_readable() {
        let help = "write model = \"greenwood-tripp\" or \"bearing-curve\"";
        table.complain("model", "is missing", help);
    }
    let is_of_asperities = table.word("model", &MODELS);
    for (keys, of, other) in [
        (&["depth"][..], false, GREENWOOD_TRIPP),
        (&["eta_beta_sigma", "sigma_over_beta", "modulus"], true, "bearing-curve"),
    ] {
        for key in keys {
            let is_written = table.has(key);
            table.refuse_if(
                is_of_asperities == Some(!of) && is_written,
                key,
                format!("has no meaning with contact.model = \"{other}\""),
                "remove it, or take the other model",
            );
            if is_of_asperities == Some(of) {
                table.require(key);
            }
        }
    }
    let density = table.number("eta_beta_sigma").or(f64::NAN);
    let sharpness = table.number("sigma_over_beta").or(f64::NAN);
    let modulus = table.given("modulus");
    let depth = table.given("depth");
    let hardness = table.required("hardness");
    let friction = table
        .number("friction")
        .within("is negative", "give the friction coefficient of surfaces that touch, some 0.1");
    let friction = friction.required();
    is_of_asperities.map(|is_of_asperities| ContactTable {
        model: match is_of_asperities {
            true => ContactModel::GreenwoodTripp { density, sharpness, modulus: modulus.unwrap_or(f64::NAN) },
            false => ContactModel::BearingCurve { depth: depth.unwrap_or(f64::NAN) },
        },
        hardness,
        friction,
    })
}

/// Asperities have the roughness of the bearing, and a criterion of contact is one of a scene with contact.
pub(crate) fn check(scene: &Scene, complaints: &mut Complaints) {
    let is_of_asperities = (scene.contact).is_some_and(|it| matches!(it.model, ContactModel::GreenwoodTripp { .. }));
    complaints.refuse_if(
        is_of_asperities && scene.bearing.roughness.is_none(),
        "contact.model",
        "is \"greenwood-tripp\", but the bearing has no roughness",
        "give bearing.roughness = \"0.6 um\", the root mean square of both surfaces together",
    );
    complaints.refuse_if(
        complaints.has("criteria.contact_share_max") && scene.contact.is_none(),
        "criteria.contact_share_max",
        "has nothing to be compared with: the scene simulates no contact",
        "add [contact], or remove the criterion",
    );
}

#[cfg(test)]
mod tests {
    use crate::scene::tests::{STUDY, read};
    use crate::{ContactModel, ContactTable};

    const CURVE: &str = "model = \"bearing-curve\"\ndepth = \"1.2 um\"\nhardness = \"900 MPa\"\nfriction = 0.1";
    const ASPERITIES: &str = "model = \"greenwood-tripp\"\neta_beta_sigma = 0.05\nsigma_over_beta = 0.01\nmodulus = \"115 GPa\"\nhardness = \"1 GPa\"\nfriction = 0";

    fn asked(roughness: &str, keys: &str) -> Result<ContactTable, String> {
        let text =
            format!("{STUDY}\n[contact]\n{keys}\n").replacen("bearing = {", &format!("bearing = {{ {roughness}"), 1);
        let scene = read(&text).map_err(|error| error.to_string())?;
        Ok(scene.contact.expect("the table is there"))
    }

    #[test]
    fn both_models_are_read() {
        assert_eq!(
            asked("", CURVE),
            Ok(ContactTable {
                model: ContactModel::BearingCurve { depth: 1.2e-6 },
                hardness: 900.0 * 1e6,
                friction: 0.1
            })
        );
        assert_eq!(
            asked("roughness = \"0.6 um\",", ASPERITIES),
            Ok(ContactTable {
                model: ContactModel::GreenwoodTripp { density: 0.05, sharpness: 0.01, modulus: 115.0 * 1e9 },
                hardness: 1e9,
                friction: 0.0,
            })
        );
        assert_eq!(read(STUDY).expect("a scene").contact, None);
    }

    #[test]
    fn what_has_no_meaning_is_refused() {
        let refused = |keys: &str, wanted: &str| {
            let error = asked("roughness = \"0.6 um\",", keys).expect_err(wanted);
            assert!(error.contains(wanted), "{error}");
        };
        refused(&CURVE.replace("0.1", "-0.1"), "contact.friction: is negative");
        refused(&CURVE.replace("depth", "# depth"), "contact.depth");
        refused(&CURVE.replace("1.2 um", "0 um"), "contact.depth: is not positive");
        refused(&CURVE.replace("hardness", "# hardness"), "contact.hardness");
        refused(&CURVE.replace("model", "# model"), "contact.model: is missing");
        refused(
            &format!("{ASPERITIES}\ndepth = \"1 um\""),
            "contact.depth: has no meaning with contact.model = \"greenwood-tripp\"",
        );
        refused(
            &format!("{CURVE}\nmodulus = \"1 GPa\""),
            "contact.modulus: has no meaning with contact.model = \"bearing-curve\"",
        );
        let error = asked("", ASPERITIES).expect_err("no roughness");
        assert!(error.contains("the bearing has no roughness"), "{error}");
    }
}
