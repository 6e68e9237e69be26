//! Binary gmsh 4.1 files of 3-node triangles: what gmsh writes for a large mesh (`-bin`), without gmsh.

use std::path::Path;

use oilwedge_mesh::gmsh::MshFile;

const NONE: u64 = u64::MAX;

/// A file that is being written: little-endian.
#[derive(Default)]
struct Bytes(Vec<u8>);

impl Bytes {
    fn text(&mut self, text: &str) {
        self.0.extend_from_slice(text.as_bytes());
    }
    fn ints(&mut self, values: &[i32]) {
        self.0.extend(values.iter().flat_map(|value| value.to_le_bytes()));
    }
    fn sizes(&mut self, values: &[u64]) {
        self.0.extend(values.iter().flat_map(|value| value.to_le_bytes()));
    }
    fn floats(&mut self, values: &[f64]) {
        self.0.extend(values.iter().flat_map(|value| value.to_le_bytes()));
    }
}

/// Writes the vertices, triangles and groups of `file`, in an order without any locality: a reader is not helped.
///
/// # Panics
/// If the file cannot be written.
pub(super) fn write_binary(file: &MshFile, path: &Path) {
    let mut tag_of = vec![NONE; file.nodes.len()];
    let mut nodes = Vec::new();
    let mut used = vec![false; file.nodes.len()];
    for &vertex in file.triangles.iter().flatten() {
        used[vertex as usize] = true;
    }
    let vertices: Vec<usize> = (0..used.len()).filter(|&node| used[node]).collect();
    for k in scattered(vertices.len()) {
        nodes.push(vertices[k]);
        tag_of[vertices[k]] = nodes.len() as u64;
    }
    let mut bytes = Bytes::default();
    bytes.text("$MeshFormat\n4.1 1 8\n");
    bytes.ints(&[1]);
    bytes.text("\n$EndMeshFormat\n");
    names(&mut bytes, file);
    entities(&mut bytes, file);
    bytes.text("$Nodes\n");
    bytes.sizes(&[1, nodes.len() as u64, 1, nodes.len() as u64]);
    bytes.ints(&[2, 1, 0]);
    bytes.sizes(&[nodes.len() as u64]);
    bytes.sizes(&(1..=nodes.len() as u64).collect::<Vec<_>>());
    for node in nodes {
        bytes.floats(&file.nodes[node]);
    }
    bytes.text("\n$EndNodes\n");
    elements(&mut bytes, file, &tag_of);
    std::fs::write(path, bytes.0).expect("a mesh file is written");
}

/// `0..count`, each once, neighbours far apart.
fn scattered(count: usize) -> impl Iterator<Item = usize> {
    // A prime beyond any number of nodes here has no divisor in common with it.
    const STRIDE: usize = 1_000_000_007;
    (0..count).map(move |k| k.wrapping_mul(STRIDE) % count)
}

fn names(bytes: &mut Bytes, file: &MshFile) {
    let mut text = format!("$PhysicalNames\n{}\n", file.curves.len() + file.surfaces.len());
    for (tag, (name, _)) in (1..).zip(&file.curves) {
        text += &format!("1 {tag} \"{name}\"\n");
    }
    for (tag, (name, _)) in (1..).zip(&file.surfaces) {
        text += &format!("2 {tag} \"{name}\"\n");
    }
    bytes.text(&(text + "$EndPhysicalNames\n"));
}

/// One curve or surface a group.
fn entities(bytes: &mut Bytes, file: &MshFile) {
    bytes.text("$Entities\n");
    bytes.sizes(&[0, file.curves.len() as u64, file.surfaces.len() as u64, 0]);
    for count in [file.curves.len(), file.surfaces.len()] {
        for tag in 1..=count as i32 {
            bytes.ints(&[tag]);
            bytes.floats(&[0.0; 6]);
            bytes.sizes(&[1]);
            bytes.ints(&[tag]);
            bytes.sizes(&[0]);
        }
    }
    bytes.text("\n$EndEntities\n");
}

fn elements(bytes: &mut Bytes, file: &MshFile, tag_of: &[u64]) {
    let lines = file.curves.iter().map(|(_, lines)| lines.len());
    let cells = file.surfaces.iter().map(|(_, cells)| cells.len());
    let count = lines.chain(cells).sum::<usize>() as u64;
    let blocks = (file.curves.len() + file.surfaces.len()) as u64;
    bytes.text("$Elements\n");
    bytes.sizes(&[blocks, count, 1, count]);
    let mut tag = 0;
    let mut block = |entity: [i32; 3], elements: &mut dyn ExactSizeIterator<Item = &[u32]>| {
        bytes.ints(&entity);
        bytes.sizes(&[elements.len() as u64]);
        for element in elements {
            tag += 1;
            bytes.sizes(&[tag]);
            for &node in element {
                bytes.sizes(&[tag_of[node as usize]]);
            }
        }
    };
    for (entity, (_, lines)) in (1..).zip(&file.curves) {
        block([1, entity, 1], &mut lines.iter().map(|line| &line[..]));
    }
    for (entity, (_, cells)) in (1..).zip(&file.surfaces) {
        let order: Vec<usize> = scattered(cells.len()).collect();
        let triangle = |&k: &usize| &file.triangles[cells[k] as usize][..];
        block([2, entity, 2], &mut order.iter().map(triangle));
    }
    bytes.text("\n$EndElements\n");
}
