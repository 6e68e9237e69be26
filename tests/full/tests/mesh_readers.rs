//! The reader mshio, one of gmsh 4.1 files that others wrote, finds the points, triangles and groups that ours finds;
//! where it does not, `docs/reference/mesh_files.md` says so, with the files of `tests/data/mshio`.

use std::collections::{BTreeMap, HashMap};
use std::f64::consts::TAU;
use std::path::{Path, PathBuf};

use mshio::ElementType;
use oilwedge_full::mesh_readers::{Outcome, outcome};
use oilwedge_full::msh_file::{Element, Encoding, Form, Numbers, to_bytes};
use oilwedge_mesh::generate::{Blueprint, Feature, RoundedRectangle, generate};
use oilwedge_mesh::gmsh::{self, MshFile};
use oilwedge_mesh::{LinerDomain, Mesh};
use oilwedge_tests::program::repository;
use oilwedge_tests::random_bearings::Dice;
use rayon::prelude::*;

/// Number of random liners.
const LINERS: u64 = 1000;

/// Names of physical groups by dimension and tag, which mshio does not read.
fn names(bytes: &[u8]) -> HashMap<(i32, i32), String> {
    let text = String::from_utf8_lossy(bytes);
    let section = text.split("$PhysicalNames\n").nth(1).unwrap_or_default();
    let section = section.split("$EndPhysicalNames").next().unwrap_or_default();
    let entry = |line: &str| {
        let mut words = line.splitn(3, ' ');
        let mut number = || words.next()?.parse().ok();
        let key = (number()?, number()?);
        Some((key, words.next()?.trim_matches('"').to_owned()))
    };
    section.lines().filter_map(entry).collect()
}

/// What mshio reads, as its documentation tells to use it: tags of a block without a map count on from the least one.
fn by_mshio(bytes: &[u8]) -> Result<MshFile, String> {
    let data = mshio::parse_msh_bytes(bytes).map_err(|error| error.to_string())?.data;
    let (nodes, elements) = data.nodes.zip(data.elements).ok_or("no nodes or no elements")?;
    let mut file = MshFile::default();
    for block in &nodes.node_blocks {
        let first = file.nodes.len() as u64;
        let mut tags: Vec<u64> = (0..block.nodes.len() as u64).map(|k| nodes.min_node_tag + first + k).collect();
        for (&tag, &place) in block.node_tags.iter().flatten() {
            tags[place] = tag;
        }
        file.tags.extend(tags);
        file.nodes.extend(block.nodes.iter().map(|node| [node.x, node.y, node.z]));
    }
    let place: HashMap<u64, u32> = file.tags.iter().copied().zip(0..).collect();
    let entities = data.entities.ok_or("no entities")?;
    let curves = entities.curves.iter().map(|curve| ((1, curve.tag), &curve.physical_tags));
    let surfaces = entities.surfaces.iter().map(|surface| ((2, surface.tag), &surface.physical_tags));
    let groups: HashMap<(i32, i32), &Vec<i32>> = curves.chain(surfaces).collect();
    let names = names(bytes);
    let name = |dim: i32, tag: i32| names.get(&(dim, tag)).cloned().unwrap_or_else(|| format!("{dim} {tag}"));
    for block in &elements.element_blocks {
        let (dim, mid_side) = match block.element_type {
            ElementType::Pnt => continue,
            ElementType::Lin2 | ElementType::Lin3 => (1, false),
            ElementType::Tri3 => (2, false),
            ElementType::Tri6 => (2, true),
            other => return Err(format!("{other:?}")),
        };
        for element in &block.elements {
            let absent = || format!("element {} names a node that is absent", element.element_tag);
            let node = |k: usize| place.get(&element.nodes[k]).copied().ok_or_else(absent);
            for &group in groups[&(dim, block.entity_tag)] {
                match dim {
                    1 => entry(&mut file.curves, name(1, group)).push([node(0)?, node(1)?]),
                    _ => entry(&mut file.surfaces, name(2, group)).push(file.triangles.len() as u32),
                }
            }
            if dim == 2 {
                file.triangles.push([node(0)?, node(1)?, node(2)?]);
            }
            if mid_side {
                file.mid_nodes.get_or_insert_default().push([node(3)?, node(4)?, node(5)?]);
            }
        }
    }
    Ok(file)
}

fn entry<T>(groups: &mut Vec<(String, Vec<T>)>, name: String) -> &mut Vec<T> {
    let place = groups.iter().position(|(group, _)| *group == name).unwrap_or(groups.len());
    if place == groups.len() {
        groups.push((name, Vec::new()));
    }
    &mut groups[place].1
}

/// Points, triangles and groups of both are equal to the last bit, in the order of the file; groups in any order.
fn assert_equal(ours: &MshFile, theirs: &MshFile, which: &str) {
    assert!(ours.tags == theirs.tags, "{which}: tags");
    assert!(ours.nodes == theirs.nodes, "{which}: points");
    assert!(ours.triangles == theirs.triangles, "{which}: triangles");
    assert!(ours.mid_nodes == theirs.mid_nodes, "{which}: mid-side nodes");
    let sorted = |file: &MshFile| {
        let surfaces: BTreeMap<_, _> = file.surfaces.iter().cloned().collect();
        let curves: BTreeMap<_, _> = file.curves.iter().cloned().collect();
        (surfaces, curves)
    };
    assert!(sorted(ours) == sorted(theirs), "{which}: groups");
}

/// Both readers read these bytes alike; what they read.
fn alike(bytes: &[u8], which: &str) -> MshFile {
    let ours = gmsh::parse(bytes).unwrap_or_else(|error| panic!("{which}: {error}"));
    let theirs = by_mshio(bytes).unwrap_or_else(|error| panic!("{which}: mshio: {error}"));
    assert_equal(&ours, &theirs, which);
    ours
}

fn bytes(path: &Path) -> Vec<u8> {
    std::fs::read(path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

#[test]
fn both_read_the_shipped_meshes_alike() {
    let folder = std::fs::read_dir(repository().join("meshes")).expect("meshes");
    let files = folder.map(|entry| entry.expect("an entry").path());
    let meshes: Vec<PathBuf> = files.filter(|path| path.extension().is_some_and(|ending| ending == "msh")).collect();
    assert!(meshes.len() >= 10, "only {} meshes", meshes.len());
    for mesh in meshes {
        let file = alike(&bytes(&mesh), &mesh.display().to_string());
        assert!(file.triangles.len() > 400 && file.surface("film").is_some());
    }
}

/// Text, binary, numbers with gaps, straight and curved triangles, cylinders: as gmsh wrote them.
#[test]
fn both_read_files_of_gmsh_alike() {
    let folder = repository().join("crates/mesh/tests/data");
    for name in ["plane_ring", "plane_ring_binary", "plane_ring_sparse", "plane_ring_straight", "cylinder_x", "half_x"]
    {
        alike(&bytes(&folder.join(format!("{name}.msh"))), name);
    }
}

fn feature(dice: &mut Dice, liner: &LinerDomain, number: u32) -> Feature {
    let (from, to) = liner.arc.unwrap_or((0.0, TAU));
    let centre = [liner.radius * dice.between(from, to), liner.length * dice.between(-0.35, 0.35)];
    let small = liner.radius.min(liner.length);
    let shape = match dice.chance(0.6) {
        true => RoundedRectangle::disc(centre, small * dice.between(0.05, 0.2)),
        false => RoundedRectangle {
            centre,
            half: [small * dice.between(0.05, 0.3), small * dice.between(0.05, 0.3)],
            corner: 0.0,
        },
    };
    Feature { name: format!("hole number {number}"), shape, meshed: dice.chance(0.5) }
}

/// A random liner with up to three holes or pockets, a few hundred triangles.
fn liner(dice: &mut Dice) -> Mesh {
    loop {
        let radius = dice.decades(-3.0, 0.5);
        let liner = LinerDomain {
            radius,
            length: radius * dice.between(0.3, 2.0),
            arc: dice.chance(0.4).then(|| (0.3, dice.between(1.0, 5.5))),
        };
        let count = dice.between(0.0, 3.999) as u32;
        let blueprint =
            Blueprint { liner, features: (0..count).map(|number| feature(dice, &liner, number)).collect(), line: None };
        let size = radius.min(liner.length) * dice.between(0.5, 1.5);
        // A drawing whose holes overlap is drawn anew.
        if let Ok(mesh) = generate(&blueprint, &|_| size) {
            return mesh;
        }
    }
}

#[test]
fn both_read_a_thousand_random_liners_alike_in_every_form() {
    (0..LINERS).into_par_iter().for_each(|number| {
        let text = gmsh::to_text(&liner(&mut Dice::new(number)));
        let file = alike(text.as_bytes(), &format!("liner {number}"));
        // Two forms that differ in everything; eight liners see all of them.
        let kind = number as usize % 8;
        for kind in [kind, 7 - kind] {
            let form = Form {
                encoding: [Encoding::Text, Encoding::Binary][kind % 2],
                element: [Element::Linear, Element::Quadratic][kind / 2 % 2],
                numbers: [Numbers::Consecutive, Numbers::Sparse][kind / 4],
                entities: 1 + number as usize % 4,
            };
            let again = alike(&to_bytes(&file, form), &format!("liner {number}, {form:?}"));
            assert_eq!(again.nodes, file.nodes);
            assert_eq!(again.triangles.len(), file.triangles.len());
            let lengths = |file: &MshFile| -> BTreeMap<String, usize> {
                let surfaces = file.surfaces.iter().map(|(name, cells)| (name.clone(), cells.len()));
                surfaces.chain(file.curves.iter().map(|(name, lines)| (name.clone(), lines.len()))).collect()
            };
            assert_eq!(lengths(&again), lengths(&file));
        }
    });
}

/// The files that `docs/reference/mesh_files.md` shows: our reader and mshio differ on each of them, as said there.
#[test]
fn what_mshio_misreads_is_documented() {
    let page = std::fs::read_to_string(repository().join("docs/reference/mesh_files.md")).expect("the page");
    let folder = repository().join("tests/data/mshio");
    let mut files = std::fs::read_dir(&folder).expect("the files").count();
    for (name, ours, theirs) in [
        ("order", Outcome::Read, Outcome::Read),
        ("dangling", Outcome::Refused, Outcome::Read),
        ("not_finite", Outcome::Refused, Outcome::Read),
        ("miscounted", Outcome::Refused, Outcome::Read),
        ("comment", Outcome::Read, Outcome::Refused),
        ("word_size", Outcome::Refused, Outcome::Panics),
    ] {
        let bytes = bytes(&folder.join(format!("{name}.msh")));
        assert_eq!(outcome(|| gmsh::parse(&bytes)), ours, "{name}");
        assert_eq!(outcome(|| mshio::parse_msh_bytes(&bytes)), theirs, "{name}: mshio");
        assert!(page.contains(&format!("tests/data/mshio/{name}.msh")), "the page does not name {name}.msh");
        files -= 1;
    }
    assert_eq!(files, 0, "a file without a row");
}

/// Tags 2, 1, 3 fill the range from least to greatest: mshio takes them for 1, 2, 3, and the triangle is turned over.
#[test]
fn mshio_moves_points_whose_numbers_are_out_of_order() {
    let data = repository().join("tests/data/mshio/order.msh");
    let shuffled = repository().join("crates/mesh/tests/data/plane_ring_shuffled.msh");
    for file in [data, shuffled] {
        let bytes = bytes(&file);
        let ours = gmsh::parse(&bytes).expect("a sound file");
        let theirs = by_mshio(&bytes).expect("a sound file");
        assert_eq!(ours.nodes, theirs.nodes);
        let mut sorted = ours.tags.clone();
        sorted.sort_unstable();
        assert_eq!(theirs.tags, sorted);
        assert_ne!(ours.triangles, theirs.triangles);
    }
}
