//! What the tables of a crankshaft must be to each other.

use super::{CrankshaftTable, ShaftPiece, ShaftScene};
use crate::Complaints;
use crate::wording::millimetres;

pub(super) fn check(scene: &ShaftScene, complaints: &mut Complaints) {
    let shaft = &scene.crankshaft;
    check_pieces(shaft, complaints);
    check_places(shaft, complaints);
    check_loads(scene, complaints);
    check_weights(shaft, complaints);
}

fn check_pieces(shaft: &CrankshaftTable, complaints: &mut Complaints) {
    let is_throw = |piece: Option<&ShaftPiece>| matches!(piece, Some(ShaftPiece::Throw { .. }));
    for (number, piece) in shaft.pieces.iter().enumerate() {
        let next = shaft.pieces.get(number + 1);
        let is_bare = number == 0 || next.is_none() || is_throw(next);
        complaints.refuse_if(
            is_throw(Some(piece)) && is_bare,
            &format!("crankshaft.piece[{number}]"),
            "is a throw without straight pieces on both sides",
            "write a straight piece with length and diameter before it and behind it",
        );
    }
    let has_throws = shaft.pieces.iter().any(|piece| is_throw(Some(piece)));
    complaints.refuse_if(
        has_throws && shaft.throw.is_none(),
        "crankshaft",
        "has throws, but their shape is missing",
        "write [crankshaft.throw] with pin_length, pin_diameter and web_thickness",
    );
    complaints.refuse_if(
        !has_throws && shaft.throw.is_some(),
        "crankshaft.throw",
        "has no effect, since no piece is a throw",
        "remove it, or give a piece fires_at",
    );
    complaints.refuse_if(
        has_throws && shaft.shear_modulus.is_none(),
        "crankshaft.shear_modulus",
        "is missing, but throws twist the shaft",
        "write shear_modulus = \"79 GPa\"",
    );
}

fn check_places(shaft: &CrankshaftTable, complaints: &mut Complaints) {
    let spans = shaft.straight_spans();
    let is_on_shaft = |z: f64| z.is_nan() || spans.iter().any(|[from, to]| z.is_nan() || (*from..=*to).contains(&z));
    let are_known = spans.iter().flatten().all(|z| z.is_finite());
    let told: Vec<String> =
        (spans.iter()).map(|[from, to]| format!("{} to {}", millimetres(*from), millimetres(*to))).collect();
    let bearings = shaft.bearings.iter().map(|bearing| bearing.at).zip(0..);
    let loads = shaft.loads.iter().map(|load| load.at).zip(0..);
    let places = (bearings.map(|(z, number)| (z, format!("bearing[{number}]"))))
        .chain(loads.map(|(z, number)| (z, format!("load[{number}]"))));
    for (z, table) in places {
        complaints.refuse_if(
            are_known && !is_on_shaft(z),
            &format!("crankshaft.{table}.at"),
            "lies on no straight piece",
            format!("straight pieces lie from {}", told.join(", ")),
        );
    }
    for (number, pair) in shaft.bearings.windows(2).enumerate() {
        complaints.refuse_if(
            pair[1].at <= pair[0].at,
            &format!("crankshaft.bearing[{}].at", number + 1),
            "does not lie behind the bearing before it",
            "write the bearings in their order along the axis",
        );
    }
    for (number, bearing) in shaft.bearings.iter().enumerate() {
        let before = &shaft.bearings[..number];
        complaints.refuse_if(
            before.iter().any(|other| other.name == bearing.name),
            &format!("crankshaft.bearing[{number}].name"),
            "is the name of a bearing before it",
            "give each bearing a name of its own",
        );
    }
    let is_held =
        shaft.bearings.len() >= 2 || shaft.tilt == super::ShaftTilt::Free && shaft.statics == super::Statics::Elastic;
    complaints.refuse_if(
        !is_held && !shaft.bearings.is_empty(),
        "crankshaft.bearing",
        "is one alone, and bears no moment: the shaft is free to turn over",
        "give a second bearing, or leave out tilt = \"none\" and statics = \"cut\"",
    );
}

fn check_loads(scene: &ShaftScene, complaints: &mut Complaints) {
    let shaft = &scene.crankshaft;
    complaints.refuse_if(
        scene.crank.is_some() && !shaft.loads.is_empty(),
        "crankshaft.load",
        "stands beside [crank], by which the loads change over a cycle",
        "remove [[crankshaft.load]] or [crank]",
    );
    complaints.refuse_if(
        scene.crank.is_none() && shaft.loads.is_empty(),
        "crankshaft",
        "has no loads",
        "write [[crankshaft.load]] with at, force and angle, or [crank] with the masses and the gas pressure of all throws",
    );
    complaints.refuse_if(
        scene.crank.is_some() && shaft.fires_at().is_empty(),
        "crank",
        "has no throw to act on",
        "give a piece fires_at, which makes it a throw",
    );
    complaints.refuse_if(
        scene.orbit.is_some() && scene.crank.is_none(),
        "orbit",
        "stands without [crank], but the loads do not change",
        "remove [orbit], or give [crank] in place of [[crankshaft.load]]",
    );
    complaints.refuse_if(
        scene.crank.is_some() && scene.orbit.is_none(),
        "crank",
        "stands without [orbit], but its loads change over a cycle",
        "write [orbit], by which the journals are followed until they repeat",
    );
    if let Some(orbit) = scene.orbit {
        for (is_given, key) in [(orbit.mass > 0.0, "mass"), (orbit.start.is_some(), "start")] {
            complaints.refuse_if(
                is_given,
                &format!("orbit.{key}"),
                "has no meaning for a shaft on several films",
                format!("remove {key}"),
            );
        }
    }
}

fn check_weights(shaft: &CrankshaftTable, complaints: &mut Complaints) {
    let throws = shaft.fires_at().len();
    for (number, weight) in shaft.counterweights.iter().enumerate() {
        complaints.refuse_if(
            weight.throw >= throws,
            &format!("crankshaft.counterweight[{number}].throw"),
            format!("is no throw of the shaft, which has {throws}"),
            "give the number of a throw along the axis, from 1",
        );
    }
}
