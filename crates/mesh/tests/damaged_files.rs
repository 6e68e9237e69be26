//! Damaged files give errors: never a panic, never a mesh with wrong nodes in it.

use std::path::PathBuf;

use oilwedge_mesh::gmsh::{self, MshFile};
use oilwedge_mesh::{Error, LinerDomain, Mesh, developed};

use crate::random::Random;

fn data(name: &str) -> Vec<u8> {
    let path = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("tests/data").join(name);
    std::fs::read(path).unwrap()
}

fn text(name: &str) -> String {
    String::from_utf8(data(name)).unwrap()
}

/// What a file that is accepted promises.
fn sound(file: &MshFile) {
    let nodes = file.nodes.len();
    let exists = |v: &u32| (*v as usize) < nodes;
    assert_eq!(file.tags.len(), nodes);
    assert!(file.nodes.iter().flatten().all(|x| x.is_finite()));
    assert!(!file.triangles.is_empty() && file.triangles.iter().flatten().all(exists));
    assert!(file.mid_nodes.iter().flatten().flatten().all(exists));
    assert!(file.mid_nodes.as_ref().is_none_or(|mids| mids.len() == file.triangles.len()));
    assert!(file.curves.iter().flat_map(|(_, edges)| edges).flatten().all(exists));
    assert!(file.periodic.iter().flatten().all(exists));
    let triangle = |t: &u32| (*t as usize) < file.triangles.len();
    assert!(file.surfaces.iter().flat_map(|(_, cells)| cells).all(triangle));
}

fn message(bytes: &[u8]) -> String {
    gmsh::parse(bytes).unwrap_err().to_string()
}

#[test]
fn a_file_cut_anywhere_before_its_last_section_is_refused() {
    for name in ["plane_ring.msh", "plane_ring_binary.msh", "plane_ring_straight.msh"] {
        let bytes = data(name);
        let needle = b"$EndElements";
        let end = bytes.windows(needle.len()).position(|w| w == needle).unwrap() + needle.len();
        for length in 0..end {
            assert!(gmsh::parse(&bytes[..length]).is_err(), "{name} cut to {length}");
        }
        for length in end..bytes.len() {
            if let Ok(file) = gmsh::parse(&bytes[..length]) {
                sound(&file);
            }
        }
    }
}

#[test]
fn messages_name_section_and_line() {
    let good = text("plane_ring.msh");
    let nodes = good[good.find("$Nodes\n").unwrap() + 7..].lines().next().unwrap();
    let swap = |from: &str, to: &str| {
        assert!(good.contains(from), "{from}");
        message(good.replacen(from, to, 1).as_bytes())
    };
    let count = nodes.split(' ').nth(1).unwrap();
    let huge = nodes.replacen(count, "1000000000000000000", 1);
    assert!(swap(nodes, &huge).contains("$Nodes, line"));
    assert!(swap(nodes, &huge).contains("room for"));
    assert!(swap(nodes, &nodes.replacen(count, "-3", 1)).contains("\"-3\" where a whole number"));
    assert!(swap(nodes, "0 0 1 1").contains("no nodes"));
    assert!(swap(nodes, "0 0 0 0").contains("no nodes"));
    assert!(swap("0 1 0 1\n1\n0.5 -1 0", "0 1 0 1\n1\nnan -1 0").contains("node 1 has a coordinate"));
    assert!(swap("0 1 0 1\n1\n0.5 -1 0", "0 1 0 1\n1\n0.5 1e999 0").contains("node 1 has a coordinate"));
    assert!(swap("0 1 0 1\n1\n0.5 -1 0", "0 1 0 1\n2\n0.5 -1 0").contains("two nodes have the tag 2"));
    assert!(swap("0 1 0 1\n1\n0.5 -1 0", "0 1 0 1\n4711\n0.5 -1 0").contains("stands on node 1"));
    assert!(swap("4.1 0 8", "4.1 0 99").contains("data size 99"));
    assert!(swap("$EndElements", "$EndElement").contains("should follow"));
    assert!(swap("$Nodes", "$Knots").contains("$Knots"));
    assert!(swap("$Elements", "$Nodes").contains("second section"));
    assert!(message(b"").contains("not a gmsh mesh file"));
    assert!(message(b"$").contains("not a gmsh mesh file"));
    assert!(message(&[0; 300]).contains("not a gmsh mesh file"));
}

#[test]
fn missing_sections_and_groups_are_named() {
    let good = text("plane_ring.msh");
    let without = |section: &str| {
        let from = good.find(&format!("${section}\n")).unwrap();
        let end = format!("$End{section}\n");
        let to = good.find(&end).unwrap() + end.len();
        format!("{}{}", &good[..from], &good[to..])
    };
    for section in ["Entities", "Nodes", "Elements"] {
        assert!(message(without(section).as_bytes()).contains(&format!("no section ${section}")));
    }
    let file = gmsh::parse(without("PhysicalNames").as_bytes()).unwrap();
    assert!(file.surface("surface 1").is_some() && file.curve("curve 2").is_some());
    let file = gmsh::parse(without("Periodic").as_bytes()).unwrap();
    let liner = LinerDomain { radius: 1.0, length: 2.0, arc: None };
    let by_position = developed::unroll(&file, &liner, 1.0).unwrap();
    let by_pairs = developed::unroll(&gmsh::parse(good.as_bytes()).unwrap(), &liner, 1.0).unwrap();
    assert_eq!(by_position.triangles, by_pairs.triangles);
}

#[test]
fn harmless_additions_are_accepted() {
    let good = text("plane_ring.msh");
    let plain = gmsh::parse(good.as_bytes()).unwrap();
    let body = &good[good.find("$PhysicalNames").unwrap()..];
    for changed in [
        format!("$Comments\nmade by hand\n$EndComments\n{good}"),
        format!("{good}\ntrailing words\n"),
        format!("{good}$Data2\n1 2 3\n$EndData2\n"),
        format!("$MeshFormat\n4.1   0\t8 \n$EndMeshFormat\n{body}"),
        good.replace('\n', "\r\n"),
    ] {
        assert_eq!(gmsh::parse(changed.as_bytes()).unwrap(), plain);
    }
}

#[test]
fn mutations_never_panic() {
    let seeds = ["plane_ring.msh", "plane_ring_binary.msh", "plane_ring_sparse.msh", "half_x.msh", "quads.msh"];
    let seeds = seeds.map(data);
    let words: [&[u8]; 13] = [
        b"-1",
        b"0",
        b"1000000000000000000",
        b"nan",
        b"\n",
        b"$",
        b" ",
        b"\xff\xff\xff\xff\xff\xff\xff\x7f",
        b"1e999",
        b"4294967296",
        b"18446744073709551615",
        b"-inf",
        b"9",
    ];
    let liner = LinerDomain { radius: 1.0, length: 2.0, arc: None };
    let mut random = Random(88_172_645_463_325_252);
    let mut accepted = 0;
    for round in 0..10000 {
        let mut bytes = seeds[round % seeds.len()].clone();
        for _ in 0..1 + random.below(3) {
            let at = random.below(bytes.len());
            let end = (at + random.below(12)).min(bytes.len());
            match random.below(5) {
                0 => bytes[at] = random.below(256) as u8,
                1 => bytes[at] = b'0' + random.below(10) as u8,
                2 => drop(bytes.drain(at..end)),
                3 => drop(bytes.splice(at..end, words[random.below(words.len())].iter().copied())),
                _ => bytes.copy_within(at..end, 0),
            }
        }
        if let Ok(file) = gmsh::parse(&bytes) {
            sound(&file);
            accepted += 1;
            match developed::unroll(&file, &liner, 1.0).and_then(|raw| Ok(Mesh::build(raw)?)) {
                Ok(mesh) => drop(gmsh::to_text(&mesh)),
                Err(error) => {
                    assert!(!matches!(error, Error::Io { .. }) && error.to_string().len() < 3000, "{error}");
                }
            }
        }
    }
    assert!(accepted > 100);
}
