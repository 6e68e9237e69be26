//! A wall that the load would press through: far too soft, mostly by its unit.

use oilwedge_scene::wording::bars;
use oilwedge_scene::{Complaints, Layer, Liner, Scene, WallMaterial};

pub(super) fn check(scene: &Scene, complaints: &mut Complaints) {
    if ["liner", "bearing", "load.force"].iter().any(|table| complaints.concern(table)) {
        return;
    }
    let (key, material) = match &scene.liner {
        Some(Liner::Winkler(Layer::Of(material))) => ("liner.winkler.modulus", material),
        Some(Liner::Wall { of, .. }) => ("liner.wall.modulus", of),
        _ => return,
    };
    let Some([x, y]) = scene.journal.load() else { return };
    let pressure = x.hypot(y) / (scene.bearing.diameter * scene.bearing.length);
    complaints.refuse_if(
        pressure >= confined(material),
        key,
        format!(
            "is too soft: the mean pressure of the load, {}, presses the wall in by its whole thickness",
            bars(pressure)
        ),
        "give the modulus of the wall's material, such as \"210 GPa\" of steel or \"2 GPa\" of a polymer; is its unit right?",
    );
}

/// Modulus [Pa] of a layer that cannot move sideways: `E (1 - nu)/((1 + nu) (1 - 2 nu))`.
fn confined(material: &WallMaterial) -> f64 {
    let (modulus, poisson) = (material.modulus, material.poisson);
    modulus * (1.0 - poisson) / ((1.0 + poisson) * (1.0 - 2.0 * poisson))
}
