use super::super::beam::Material;
use super::super::crankshaft::{CrankThrow, Crankshaft, Piece, Round};
use super::*;

const STEEL: Material = Material { youngs_modulus: 206e9, shear_modulus: None };
const DIAMETER: f64 = 0.06;

fn straight(length: f64) -> Piece {
    Piece::Straight(Round { length, diameter: DIAMETER, bore: 0.0 })
}

fn bending(material: Material) -> f64 {
    material.youngs_modulus * material.round(DIAMETER, 0.0).second_moments[0]
}

fn place(node: usize, order: usize) -> Place {
    Place { node, coordinates: Coordinates { order, arm: 0.015 } }
}

/// A straight shaft on places at these z without tilt, loaded at others.
fn beam(material: Material, length: f64, bearings: &[f64], loads: &[f64]) -> Shaft {
    let shaft = Crankshaft { material, pieces: vec![straight(length)] };
    let laid = shaft.laid(&[bearings, loads].concat());
    let (bearings, loads) = laid.places.split_at(bearings.len());
    let places: Vec<Place> = bearings.iter().map(|&node| place(node, 2)).collect();
    laid.frame.on(&places, loads).expect("a shaft")
}

fn pushed(place: usize, y: f64) -> NodeForce {
    NodeForce { place, force: [0.0, y] }
}

#[test]
fn knife_edges_carry_what_handbooks_say() {
    let shaft = beam(STEEL, 0.4, &[0.0, 0.2, 0.4], &[0.1, 0.3]);
    // With supports that do not move, the reactions are the loads moved to them.
    let forces = shaft.loads(&[pushed(0, -12e3), pushed(1, -12e3)], 0.7);
    for (force, part) in forces.iter().zip([5.0 / 16.0, 11.0 / 8.0, 5.0 / 16.0]) {
        assert!((force[1] / (-12e3 * part) - 1.0).abs() < 1e-10, "{forces:?}");
        assert!(force[0].abs() < 1e-9);
    }
}

#[test]
fn a_sunk_support_is_unloaded_by_the_beam() {
    // Force at the middle of a beam on two supports: 48 E I/L^3, with shear P L/(4 k G A) more deflection.
    let sheared = Material { shear_modulus: Some(79e9), ..STEEL };
    for material in [STEEL, sheared] {
        let shaft = beam(material, 0.4, &[0.0, 0.2, 0.4], &[]);
        let section = material.round(DIAMETER, 0.0);
        let shear = (material.shear_modulus).map_or(0.0, |g| 0.4 / (4.0 * section.shear_factors[0] * g * section.area));
        let wanted = 1.0 / (0.4f64.powi(3) / (48.0 * bending(material)) + shear);
        let at = [[0.0; 4], [0.0, 1.0, 0.0, 0.0], [0.0; 4]];
        let forces = shaft.forces(&at, 1.1);
        for (force, part) in forces.iter().zip([-0.5, 1.0, -0.5]) {
            assert!((force[1] / (wanted * part) - 1.0).abs() < 1e-9, "{forces:?} {wanted:e}");
        }
    }
}

/// Force at the middle of a beam on two supports that have moved: P z (3 L^2 - 4 z^2)/(48 E I), with shear
/// P z/(2 k G A) more.
#[test]
fn the_line_of_a_beam_hangs_between_its_supports() {
    let sheared = Material { shear_modulus: Some(79e9), ..STEEL };
    let ends = [[1e-5, 2e-5, 0.0, 0.0], [-3e-5, 1e-5, 0.0, 0.0]];
    for material in [STEEL, sheared] {
        let shaft = beam(material, 0.4, &[0.0, 0.4], &[0.2]);
        let section = material.round(DIAMETER, 0.0);
        let softness = material.shear_modulus.map_or(0.0, |g| 0.5 / (section.shear_factors[0] * g * section.area));
        for point in shaft.bent(&ends, &[pushed(0, -12e3)], 0.7).expect("a line") {
            let z = point.z.min(0.4 - point.z);
            let sag = 12e3 * z * ((3.0 * 0.16 - 4.0 * z * z) / (48.0 * bending(material)) + softness);
            let wanted = [0, 1].map(|k| ends[0][k] + (ends[1][k] - ends[0][k]) * point.z / 0.4);
            let off = (point.by[0] - wanted[0]).hypot(point.by[1] - wanted[1] + sag);
            assert!(off < 1e-13, "z = {}: {:?}, not {wanted:?} less {sag:e}", point.z, point.by);
        }
    }
}

#[test]
fn slopes_and_moments_are_those_of_a_clamped_beam() {
    let shaft = Crankshaft { material: STEEL, pieces: vec![straight(0.4)] };
    let laid = shaft.laid(&[0.0, 0.4, 0.2]);
    let places = [place(laid.places[0], 4), place(laid.places[1], 4)];
    let shaft = laid.frame.on(&places, &[laid.places[2]]).expect("a shaft");
    // Both ends held: force P/2, and moments P L/8 that bend the ends back.
    let forces = shaft.loads(&[pushed(0, 1e4)], 0.0);
    let moments = forces.iter().map(|force| 0.015 * force[3]);
    for (moment, sign) in moments.zip([1.0, -1.0]) {
        assert!((moment / (sign * 1e4 * 0.4 / 8.0) - 1.0).abs() < 1e-9, "{forces:?}");
    }
    assert!(forces.iter().all(|force| (force[1] / 5e3 - 1.0).abs() < 1e-12));
    // A slope of one end: moment 4 E I/L there, 2 E I/L at the other.
    let forces = shaft.forces(&[[0.0, 0.0, 0.015, 0.0], [0.0; 4]], 0.0);
    let [own, other] = [0, 1].map(|k: usize| 0.015 * forces[k][2] * 0.4 / bending(STEEL));
    assert!((own - 4.0).abs() < 1e-8 && (other - 2.0).abs() < 1e-8, "{own} {other}");
}

#[test]
fn rigid_motions_are_free_and_loads_keep_sum_and_moment() {
    let throw = |angle: f64, web_width| {
        Piece::Throw(CrankThrow {
            angle,
            radius: 0.05,
            pin: Round { length: 0.03, diameter: 0.05, bore: 0.0 },
            web_thickness: 0.02,
            web_width,
        })
    };
    for width in [None, Some(0.08)] {
        let shaft = Crankshaft {
            material: Material { youngs_modulus: 206e13, shear_modulus: Some(79e13) },
            pieces: vec![straight(0.03), throw(0.3, width), straight(0.03), throw(2.0, width), straight(0.03)],
        };
        let bearings = [0.015, 0.115, 0.215];
        let laid = shaft.laid(&bearings);
        let places: Vec<Place> = laid.places.iter().map(|&node| place(node, 4)).collect();
        let loaded = [laid.throws[0].pin, laid.throws[1].webs[1]];
        let z = loaded.map(|node| laid.frame.nodes[node][2]);
        let shaft = laid.frame.on(&places, &loaded).expect("a shaft");
        let rigid: Vec<Vector> = bearings.map(|z| [1.0 + 2.0 * z, -z, 2.0 * 0.015, -0.015]).to_vec();
        let most = shaft.stiffness(0.0).at(0, 0);
        for force in shaft.forces(&rigid, 0.4).iter().flatten() {
            assert!(force.abs() < 1e-13 * most, "{force:e} of {most:e}");
        }
        // Pins follow as the axis does.
        let line = shaft.bent(&rigid, &[], 0.4).expect("a line");
        let off = line.iter().flat_map(|point| [point.by[0] - 1.0 - 2.0 * point.z, point.by[1] + point.z]);
        assert!(off.fold(0.0, |most: f64, off| most.max(off.abs())) < 1e-9);
        let loads = [pushed(0, 1e3), NodeForce { place: 1, force: [2e3, 0.0] }];
        let forces = shaft.loads(&loads, 0.9);
        let sum = |k: usize| forces.iter().map(|force| force[k]).sum::<f64>();
        assert!((sum(0) - 2e3).abs() < 1e-10 && (sum(1) - 1e3).abs() < 1e-10);
        let moment = |k: usize| {
            let parts = forces.iter().zip(bearings);
            parts.map(|(force, z)| z * force[k] + 0.015 * force[k + 2]).sum::<f64>()
        };
        assert!((moment(0) - 2e3 * z[1]).abs() < 1e-10 && (moment(1) - 1e3 * z[0]).abs() < 1e-10);
    }
}

/// A throw on two supports without tilt at its ends, under a force P on its pin in its own plane: `u/P` by
/// Castigliano's theorem, with the arm a from a support to the middle of a web and half a pin b up to there, is
/// `a^3/(6 E I_j) + ((a + b)^3 - a^3)/(6 E I_p) + a^2 r/(2 E I_w) + r/(2 E A_w)`; rigid webs have the first two terms
/// alone. With the throw of `scenes/engines/three_throws.toml` and webs 110 mm wide, the webs from axis to axis make it
/// 7.2 times as soft.
#[test]
fn webs_bend_from_axis_to_axis() {
    let (pin, journal) = (0.072, 0.085);
    let (radius, arm, half_pin, thickness, width) = (0.0625, 0.033, 0.034, 0.026, 0.11);
    let round = |length: f64, diameter: f64| Round { length, diameter, bore: 0.0 };
    let softness = |web_width| {
        let outer = Piece::Straight(round(arm - 0.5 * thickness, journal));
        let throw = CrankThrow {
            angle: 0.0,
            radius,
            pin: round(2.0 * half_pin - thickness, pin),
            web_thickness: thickness,
            web_width,
        };
        let shaft = Crankshaft { material: STEEL, pieces: vec![outer, Piece::Throw(throw), outer] };
        let laid = shaft.laid(&[0.0, 2.0 * (arm + half_pin)]);
        let nodes = [laid.places[0], laid.throws[0].pin, laid.places[1]];
        let places = nodes.map(|node| place(node, 2));
        let shaft = laid.frame.on(&places, &[]).expect("a shaft");
        let forces = shaft.forces(&[[0.0; 4], [1.0, 0.0, 0.0, 0.0], [0.0; 4]], 0.0);
        1.0 / forces[1][0]
    };
    let bending = |diameter: f64| 6.0 * STEEL.youngs_modulus * STEEL.round(diameter, 0.0).second_moments[0];
    let rigid = arm.powi(3) / bending(journal) + ((arm + half_pin).powi(3) - arm.powi(3)) / bending(pin);
    let second = width * thickness.powi(3) / 12.0;
    let webs = 0.5 * radius * (arm * arm / second + 1.0 / (width * thickness)) / STEEL.youngs_modulus;
    for (web_width, wanted) in [(None, rigid), (Some(width), rigid + webs)] {
        let found = softness(web_width);
        assert!((found / wanted - 1.0).abs() < 1e-9, "{found:e} {wanted:e}");
    }
    assert!(((rigid + webs) / rigid - 7.2).abs() < 0.05, "{}", (rigid + webs) / rigid);
}

#[test]
fn a_shaft_that_turns_keeps_its_stiffness_in_its_own_axes() {
    let throw = CrankThrow {
        angle: 0.0,
        radius: 0.05,
        pin: Round { length: 0.03, diameter: 0.05, bore: 0.0 },
        web_thickness: 0.02,
        web_width: Some(0.08),
    };
    let of = |angle: f64| {
        let shaft = Crankshaft {
            material: Material { shear_modulus: Some(79e9), ..STEEL },
            pieces: vec![straight(0.03), Piece::Throw(CrankThrow { angle, ..throw }), straight(0.03)],
        };
        let laid = shaft.laid(&[0.015, 0.115]);
        let places: Vec<Place> = laid.places.iter().map(|&node| place(node, 4)).collect();
        laid.frame.on(&places, &[]).expect("a shaft")
    };
    let at = [[1e-6, 2e-6, 3e-6, -1e-6], [0.0, 1e-6, 0.0, 2e-6]];
    let (turned, laid) = (of(0.0).forces(&at, 0.8), of(0.8).forces(&at, 0.0));
    let size = turned[0][0].abs();
    for (a, b) in turned.iter().flatten().zip(laid.iter().flatten()) {
        assert!((a - b).abs() < 1e-8 * size, "{turned:?} {laid:?}");
    }
    // The throw makes it stiffer one way than the other.
    let stiffness = of(0.0).stiffness(0.0);
    assert!((stiffness.at(2, 2) / stiffness.at(3, 3) - 1.0).abs() > 0.05);
}

#[test]
fn one_support_without_tilt_leaves_a_shaft_free() {
    let shaft = Crankshaft { material: STEEL, pieces: vec![straight(0.4)] };
    let laid = shaft.laid(&[0.1]);
    let on = |order| laid.frame.on(&[place(laid.places[0], order)], &[]);
    assert!(matches!(on(2), Err(NoShaft::Free | NoShaft::Singular)));
    assert!(on(4).is_ok());
}
