//! Surfaces by chance: rough ones that touch, walls that give way, bores out of round.

use std::f64::consts::PI;
use std::fmt::Write;

use oilwedge_tests::random_bearings::Dice;

/// Surfaces of a bearing.
#[derive(Debug, Clone)]
pub struct Walls {
    /// Combined roughness [m].
    pub roughness: f64,
    /// Tables of the scene.
    pub tables: String,
}

/// Surfaces of a bearing whose films have pressures of some `pressure` [Pa] in this `clearance` [m].
pub fn tables(dice: &mut Dice, pressure: f64, clearance: f64) -> Walls {
    let mut tables = String::new();
    let roughness = clearance * dice.decades(-2.5, -1.5);
    if dice.chance(0.75) {
        contact(&mut tables, dice, roughness);
    }
    if dice.chance(0.4) {
        let _ = writeln!(tables, "[roughness]\nmodel = \"patir-cheng\"");
    }
    if dice.chance(0.75) {
        liner(&mut tables, dice, clearance / pressure);
    }
    if dice.chance(0.5) {
        bore(&mut tables, dice, clearance);
    }
    Walls { roughness, tables }
}

fn contact(tables: &mut String, dice: &mut Dice, roughness: f64) {
    let _ = match dice.chance(0.6) {
        true => writeln!(
            tables,
            "[contact]\nmodel = \"greenwood-tripp\"\neta_beta_sigma = {}\nsigma_over_beta = {}\nmodulus = \"{} GPa\"",
            dice.between(0.03, 0.05),
            dice.decades(-4.0, -2.0),
            dice.decades(0.5, 2.1)
        ),
        false => writeln!(
            tables,
            "[contact]\nmodel = \"bearing-curve\"\ndepth = \"{} m\"",
            roughness * dice.between(1.0, 4.0)
        ),
    };
    let _ = writeln!(tables, "hardness = \"{} MPa\"\nfriction = {}", dice.decades(2.0, 3.0), dice.between(0.0, 0.2));
}

/// A layer that moves by some hundredths of the clearance, or less, under the pressure of the film, or a ring.
fn liner(tables: &mut String, dice: &mut Dice, softness: f64) {
    let material = |dice: &mut Dice, thickness: [f64; 2], modulus: [f64; 2]| {
        format!(
            "thickness = \"{} mm\", modulus = \"{} GPa\", poisson = {}",
            dice.between(thickness[0], thickness[1]),
            dice.decades(modulus[0], modulus[1]),
            dice.between(0.2, 0.45)
        )
    };
    let _ = match dice.between(0.0, 2.999) as usize {
        0 => writeln!(tables, "[liner]\nwinkler = \"{} um/MPa\"", 1e12 * softness * dice.decades(-4.0, -1.7)),
        1 => writeln!(tables, "[liner]\nwinkler = {{ {} }}", material(dice, [0.2, 2.0], [0.0, 2.0])),
        _ => {
            let outer = if dice.chance(0.3) { "free" } else { "clamped" };
            let of = material(dice, [5.0, 40.0], [1.8, 2.3]);
            writeln!(tables, "[liner]\nwall = {{ {of}, outer = \"{outer}\" }}")
        }
    };
}

/// An oval, a crown or a worn pit, up to a third of the clearance.
fn bore(tables: &mut String, dice: &mut Dice, clearance: f64) {
    let (depth, angle) = (dice.between(0.02, 0.3) * clearance, dice.between(-PI, PI));
    let _ = match dice.between(0.0, 2.999) as usize {
        0 => writeln!(tables, "[[bore]]\noval = {{ depth = \"{depth} m\", angle = \"{angle} rad\" }}"),
        1 => writeln!(tables, "[[bore]]\ncrown = \"{depth} m\""),
        _ => writeln!(
            tables,
            "[[bore]]\nworn = {{ depth = \"{depth} m\", angle = \"{angle} rad\", half_width = \"{} rad\" }}",
            dice.between(0.3, 1.0)
        ),
    };
}
