//! `[roughness]`: the flow of oil between surfaces that are not smooth.

use crate::reader::TableReader;
use crate::{Complaints, Scene};

keys! {
    "roughness" = Table; "", "the oil flows as between smooth surfaces", "",
        "the flow of oil between rough surfaces, with the roughness of `bearing.roughness`";
    "roughness.model" = Choice(&["patir-cheng"]); "patir-cheng", "required", "",
        "how roughness changes the flow: Patir and Cheng's factor of the pressure flow for isotropic heights, and the mean gap of Gaussian ones; both surfaces equally rough";
}

/// How roughness changes the flow of oil.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Roughness {
    /// Patir and Cheng's flow factors of isotropic surfaces.
    PatirCheng,
}

pub(crate) fn read(mut table: TableReader<'_>) -> Option<Roughness> {
    if !table.has("model") && table.is_readable() {
        table.complain("model", "is missing", "write model = \"patir-cheng\"");
    }
    table.word("model", &[("patir-cheng", Roughness::PatirCheng)])
}

/// Flow factors need the roughness of the bearing, and a laminar film.
pub(crate) fn check(scene: &Scene, complaints: &mut Complaints) {
    complaints.refuse_if(
        scene.roughness.is_some() && scene.bearing.roughness.is_none(),
        "roughness.model",
        "is \"patir-cheng\", but the bearing has no roughness",
        "give bearing.roughness = \"0.6 um\", the root mean square of both surfaces together",
    );
    complaints.refuse_if(
        scene.roughness.is_some() && scene.turbulence.is_some(),
        "roughness.model",
        "is of laminar flow between the asperities, but the film is turbulent",
        "remove [roughness], or [turbulence]",
    );
}

#[cfg(test)]
mod tests {
    use crate::Roughness;
    use crate::scene::tests::{STUDY, read};

    #[test]
    fn flow_factors_need_a_roughness() {
        let text = format!("{STUDY}\n[roughness]\nmodel = \"patir-cheng\"\n");
        let error = read(&text).expect_err("no roughness").to_string();
        assert!(error.contains("roughness.model: is \"patir-cheng\", but the bearing has no roughness"), "{error}");
        let rough = text.replacen("bearing = {", "bearing = { roughness = \"0.6 um\",", 1);
        assert_eq!(read(&rough).map(|scene| scene.roughness).ok(), Some(Some(Roughness::PatirCheng)));
        let error = read(&rough.replace("model = \"patir", "model = \"tripp")).expect_err("no such model").to_string();
        assert!(error.contains("roughness.model"), "{error}");
        let error = read(&rough.replace("model = \"patir-cheng\"", "")).expect_err("no model").to_string();
        assert!(error.contains("roughness.model: is missing"), "{error}");
    }
}
