//! Random meshes as files in every form that gmsh has for them: they are read back the same.

use oilwedge_mesh::gmsh::{self, MshFile};
use oilwedge_mesh::{LinerDomain, Mesh, RawMesh, developed};
use proptest::prelude::*;

const LENGTH: f64 = 0.04;
const RADIUS: f64 = 0.025;

/// A liner of `columns` by `rows` cells, an arc of 2 rad or a ring, with uneven spacing.
fn liner_mesh(columns: u32, rows: u32, steps: &[f64], is_ring: bool) -> Mesh {
    let width = if is_ring { std::f64::consts::TAU * RADIUS } else { 2.0 * RADIUS };
    let spaced = |count: u32, extent: f64, k: u32| {
        let step = |k: u32| 1.0 + steps[k as usize % steps.len()];
        let total: f64 = (0..count).map(step).sum();
        extent * (0..k).map(step).sum::<f64>() / total
    };
    let around = if is_ring { columns } else { columns + 1 };
    let mut raw = RawMesh { period: is_ring.then_some(width), ..RawMesh::default() };
    let vertex = |i: u32, j: u32| (i % around) * (rows + 1) + j;
    for (i, j) in (0..around).flat_map(|i| (0..=rows).map(move |j| (i, j))) {
        let z = spaced(rows, LENGTH, j) - 0.5 * LENGTH;
        raw.points.push([spaced(columns, width, i), z]);
    }
    for (i, j) in (0..columns).flat_map(|i| (0..rows).map(move |j| (i, j))) {
        let [a, b, c, d] = [vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1)];
        raw.triangles.extend([[a, b, c], [a, c, d]]);
    }
    let along = |j: u32| (0..columns).map(|i| [vertex(i, j), vertex(i + 1, j)]).collect();
    let across = |i: u32| (0..rows).map(|j| [vertex(i, j), vertex(i, j + 1)]).collect();
    raw.curves = vec![("end_low".into(), along(0)), ("end_high".into(), along(rows))];
    if !is_ring {
        raw.curves.extend([("arc_from".into(), across(0)), ("arc_to".into(), across(columns))]);
    }
    raw.surfaces = vec![("film".into(), (0..2 * columns * rows).collect())];
    Mesh::build(raw).expect("a mesh")
}

/// The sections behind the header: name and body.
fn sections(text: &str) -> Vec<(String, String)> {
    let mut sections = Vec::new();
    let mut rest = text;
    while let Some((name, behind)) = rest.trim_start().strip_prefix('$').and_then(|rest| rest.split_once('\n')) {
        let (body, after) = behind.split_once(&format!("$End{name}\n")).expect("a closed section");
        sections.push((name.to_owned(), body.to_owned()));
        rest = after;
    }
    sections
}

/// Numbers of a section of text, written as gmsh's binary files have them.
struct Binary<'a> {
    words: std::str::SplitAsciiWhitespace<'a>,
    bytes: Vec<u8>,
}

impl Binary<'_> {
    fn size(&mut self) -> u64 {
        let value: u64 = self.words.next().expect("a word").parse().expect("a whole number");
        self.bytes.extend(value.to_le_bytes());
        value
    }

    fn int(&mut self) -> i32 {
        let value: i32 = self.words.next().expect("a word").parse().expect("a whole number");
        self.bytes.extend(value.to_le_bytes());
        value
    }

    fn reals(&mut self, count: u64) {
        for _ in 0..count {
            let value: f64 = self.words.next().expect("a word").parse().expect("a number");
            self.bytes.extend(value.to_le_bytes());
        }
    }

    fn ints(&mut self) {
        for _ in 0..self.size() {
            self.int();
        }
    }

    fn sizes(&mut self, count: u64) {
        for _ in 0..count {
            self.size();
        }
    }

    fn entities(&mut self) {
        let counts = [0; 4].map(|_: i32| self.size());
        for (dim, count) in counts.into_iter().enumerate() {
            for _ in 0..count {
                self.int();
                self.reals(if dim == 0 { 3 } else { 6 });
                self.ints();
                if dim > 0 {
                    self.ints();
                }
            }
        }
    }

    fn blocks(&mut self, is_nodes: bool) {
        let blocks = self.size();
        self.sizes(3);
        for _ in 0..blocks {
            let kind = [0; 3].map(|_: i32| self.int())[2];
            let count = self.size();
            if is_nodes {
                self.sizes(count);
                self.reals(3 * count);
            } else {
                let nodes = match kind {
                    1 => 2,
                    2 | 8 => 3,
                    9 => 6,
                    other => panic!("element type {other}"),
                };
                self.sizes((1 + nodes) * count);
            }
        }
    }

    fn periodic(&mut self) {
        for _ in 0..self.size() {
            for _ in 0..3 {
                self.int();
            }
            let affine = self.size();
            self.reals(affine);
            let pairs = self.size();
            self.sizes(2 * pairs);
        }
    }
}

/// The body of a section in binary.
fn binary(name: &str, body: &str) -> Vec<u8> {
    let mut binary = Binary { words: body.split_ascii_whitespace(), bytes: Vec::new() };
    match name {
        "Entities" => binary.entities(),
        "Nodes" => binary.blocks(true),
        "Elements" => binary.blocks(false),
        "Periodic" => binary.periodic(),
        _ => return body.as_bytes().to_vec(),
    }
    assert_eq!(binary.words.next(), None, "{name}");
    binary.bytes.push(b'\n');
    binary.bytes
}

/// The file with its sections behind the header in another order, in text or in binary.
fn rewritten(text: &str, turn: usize, is_binary: bool) -> Vec<u8> {
    let mut all = sections(text);
    let mut behind = all.split_off(1);
    let places = behind.len();
    behind.rotate_left(turn % places);
    let mut bytes = match is_binary {
        true => [b"$MeshFormat\n4.1 1 8\n".as_slice(), &1i32.to_le_bytes(), b"\n$EndMeshFormat\n"].concat(),
        false => b"$MeshFormat\n4.1 0 8\n$EndMeshFormat\n".to_vec(),
    };
    for (name, body) in behind {
        bytes.extend(format!("${name}\n").as_bytes());
        match is_binary {
            true => bytes.extend(binary(&name, &body)),
            false => bytes.extend(body.as_bytes()),
        }
        bytes.extend(format!("$End{name}\n").as_bytes());
    }
    bytes
}

fn liner(is_ring: bool) -> LinerDomain {
    LinerDomain { radius: RADIUS, length: LENGTH, arc: (!is_ring).then_some((0.0, 2.0)) }
}

fn read(file: &MshFile, is_ring: bool) -> Mesh {
    let raw = developed::unroll(file, &liner(is_ring), 1.0).expect("the liner");
    Mesh::build(raw).expect("a mesh")
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(60))]

    #[test]
    fn a_mesh_is_read_back_from_every_form(
        columns in 4u32..9, rows in 2u32..6, steps in prop::collection::vec(0.0..1.0, 3..7), is_ring: bool, turn in 0usize..5,
    ) {
        let mesh = liner_mesh(columns, rows, &steps, is_ring);
        let text = gmsh::to_text(&mesh);
        let plain = gmsh::parse(text.as_bytes()).expect("what was written is read");
        let again = read(&plain, is_ring);
        prop_assert_eq!(again.triangles(), mesh.triangles());
        for (a, b) in again.points().iter().flatten().zip(mesh.points().iter().flatten()) {
            prop_assert!((a - b).abs() <= 1e-15, "{a} {b}");
        }
        for is_binary in [false, true] {
            let other = gmsh::parse(&rewritten(&text, turn, is_binary)).expect("the same file in another form");
            prop_assert_eq!(&other, &plain);
        }
    }
}
