//! `read_meshes`: the tables of `docs/reference/mesh_files.md` that compare the own reader of gmsh files with mshio, printed; on a quiet machine.

use std::collections::BTreeMap;
use std::time::Instant;

use oilwedge_full::mesh_readers::outcome;
use oilwedge_full::msh_file::{Element, Encoding, Form, Numbers, scattered, to_bytes};
use oilwedge_mesh::gmsh;
use oilwedge_tests::random_bearings::Dice;
use oilwedge_tests::ring_of_radius;

/// Runs the command.
pub(crate) fn run(_: &[String]) {
    times();
    damaged_files();
}

/// Times of both readers, from memory.
fn times() {
    let mesh = gmsh::parse(gmsh::to_text(&ring_of_radius(0.05, 400, 62, 0.05, 0.0)).as_bytes()).expect("our own file");
    println!(
        "| {} nodes | MB | own reader [ms] | mshio [ms] |\n|---|---|---|---|",
        mesh.nodes.len()
    );
    for (encoding, numbers) in [
        (Encoding::Text, Numbers::Consecutive),
        (Encoding::Binary, Numbers::Consecutive),
        (Encoding::Text, Numbers::Sparse),
        (Encoding::Binary, Numbers::Sparse),
    ] {
        let element = Element::Quadratic;
        let bytes = to_bytes(
            &mesh,
            Form {
                encoding,
                element,
                numbers,
                entities: 1,
            },
        );
        let ours = fastest(|| assert!(gmsh::parse(&bytes).is_ok()));
        let theirs = fastest(|| assert!(mshio::parse_msh_bytes(&bytes).is_ok()));
        let size = bytes.len() as f64 * 1e-6;
        println!(
            "| {encoding:?}, {numbers:?} | {size:.1} | {:.1} | {:.1} |",
            1e3 * ours,
            1e3 * theirs
        );
    }
}

/// What both make of damaged files.
fn damaged_files() {
    let small = gmsh::parse(gmsh::to_text(&ring_of_radius(0.05, 24, 6, 0.05, 0.0)).as_bytes());
    let small = scattered(&small.expect("our own file"));
    let mut counts = BTreeMap::new();
    let mut dice = Dice::new(7);
    std::panic::set_hook(Box::new(|_| {}));
    for number in 0..20_000 {
        let encoding = [Encoding::Text, Encoding::Binary][number % 2];
        let form = Form {
            encoding,
            element: Element::Linear,
            numbers: Numbers::Consecutive,
            entities: 2,
        };
        let damaged = damaged(to_bytes(&small, form), &mut dice);
        let ours = outcome(|| gmsh::parse(&damaged));
        let theirs = outcome(|| mshio::parse_msh_bytes(&damaged));
        *counts.entry((ours, theirs)).or_insert(0) += 1;
    }
    println!("| own reader | mshio | damaged files |\n|---|---|---|");
    for ((ours, theirs), count) in counts {
        println!("| {ours:?} | {theirs:?} | {count} |");
    }
}

/// Cut off, or some bytes replaced by others of a number.
fn damaged(mut bytes: Vec<u8>, dice: &mut Dice) -> Vec<u8> {
    let place = |dice: &mut Dice, length: usize| dice.between(0.0, length as f64 - 1.0) as usize;
    if dice.chance(0.2) {
        bytes.truncate(place(dice, bytes.len()));
        return bytes;
    }
    for _ in 0..3 {
        // Most damage is done by counts, which stand at the beginning.
        let length = if dice.chance(0.5) {
            400.min(bytes.len())
        } else {
            bytes.len()
        };
        let at = place(dice, length);
        bytes[at] = b"0123456789-. \n\xff\x00"[place(dice, 17)];
    }
    bytes
}

fn fastest(read: impl Fn()) -> f64 {
    let time = |_| {
        let start = Instant::now();
        read();
        start.elapsed().as_secs_f64()
    };
    (0..9).map(time).fold(f64::INFINITY, f64::min)
}
