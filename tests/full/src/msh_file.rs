//! Binary gmsh 4.1 files of straight triangles, as gmsh writes large meshes (`-bin`), written without gmsh.

use oilwedge_mesh::gmsh::MshFile;

/// The bytes of `file`, its mid-side nodes left out: one entity for each group, the place of a group in its list its tag.
pub fn to_bytes(file: &MshFile) -> Vec<u8> {
    let mut out = Bytes(b"$MeshFormat\n4.1 1 8\n".to_vec());
    out.ints([1]);
    let mut groups: Vec<(i32, i32, &str, Vec<Vec<u32>>)> = Vec::new();
    for (tag, (name, lines)) in (1..).zip(&file.curves) {
        groups.push((1, tag, name, lines.iter().map(|line| line.to_vec()).collect()));
    }
    for (tag, (name, cells)) in (1..).zip(&file.surfaces) {
        groups.push((
            2,
            tag,
            name,
            cells
                .iter()
                .map(|&cell| file.triangles[cell as usize].to_vec())
                .collect(),
        ));
    }
    out.text(&format!("\n$EndMeshFormat\n$PhysicalNames\n{}\n", groups.len()));
    groups
        .iter()
        .for_each(|(dim, tag, name, _)| out.text(&format!("{dim} {tag} \"{name}\"\n")));
    out.text("$EndPhysicalNames\n$Entities\n");
    out.sizes([0, file.curves.len(), file.surfaces.len(), 0]);
    for &(_, tag, ..) in &groups {
        out.ints([tag]);
        out.reals([0.0; 6]);
        out.sizes([1]);
        out.ints([tag]);
        out.sizes([0]);
    }
    let nodes = file.nodes.len();
    out.text("\n$EndEntities\n$Nodes\n");
    out.sizes([1, nodes, 1, nodes]);
    out.ints([2, 1, 0]);
    out.sizes(std::iter::once(nodes).chain(1..=nodes));
    out.reals(file.nodes.iter().flatten().copied());
    let count = groups.iter().map(|(.., elements)| elements.len()).sum();
    out.text("\n$EndNodes\n$Elements\n");
    out.sizes([groups.len(), count, 1, count]);
    let mut numbers = 1..;
    for (dim, tag, _, elements) in &groups {
        // Type 1 is the line of 2 nodes, type 2 the triangle of 3.
        out.ints([*dim, *tag, *dim]);
        out.sizes([elements.len()]);
        for (nodes, number) in elements.iter().zip(numbers.by_ref()) {
            out.sizes(std::iter::once(number).chain(nodes.iter().map(|&node| node as usize + 1)));
        }
    }
    out.text("\n$EndElements\n");
    out.0
}

/// What is written, little-endian.
struct Bytes(Vec<u8>);

impl Bytes {
    fn text(&mut self, text: &str) {
        self.0.extend_from_slice(text.as_bytes());
    }

    fn ints(&mut self, values: impl IntoIterator<Item = i32>) {
        self.0.extend(values.into_iter().flat_map(i32::to_le_bytes));
    }

    fn sizes(&mut self, values: impl IntoIterator<Item = usize>) {
        self.0
            .extend(values.into_iter().flat_map(|value| (value as u64).to_le_bytes()));
    }

    fn reals(&mut self, values: impl IntoIterator<Item = f64>) {
        self.0.extend(values.into_iter().flat_map(f64::to_le_bytes));
    }
}

/// Vertices and triangles of a mesh in an order without locality, so that a reader is not helped; mid-side nodes are left out.
pub fn scattered(file: &MshFile) -> MshFile {
    let mut is_vertex = vec![false; file.nodes.len()];
    for &vertex in file.triangles.iter().flatten() {
        is_vertex[vertex as usize] = true;
    }
    let vertices: Vec<usize> = (0..is_vertex.len()).filter(|&node| is_vertex[node]).collect();
    let order: Vec<usize> = far_apart(vertices.len()).map(|k| vertices[k]).collect();
    let mut place = vec![u32::MAX; file.nodes.len()];
    for (new, &old) in (0..).zip(&order) {
        place[old] = new;
    }
    let moved = |node: u32| place[node as usize];
    let shuffled = |cells: &Vec<u32>| far_apart(cells.len()).map(|k| cells[k]).collect();
    MshFile {
        nodes: order.iter().map(|&old| file.nodes[old]).collect(),
        tags: (1..=order.len() as u64).collect(),
        triangles: file.triangles.iter().map(|triangle| triangle.map(moved)).collect(),
        mid_nodes: None,
        surfaces: file
            .surfaces
            .iter()
            .map(|(name, cells)| (name.clone(), shuffled(cells)))
            .collect(),
        curves: file
            .curves
            .iter()
            .map(|(name, lines)| (name.clone(), lines.iter().map(|line| line.map(moved)).collect()))
            .collect(),
        periodic: Vec::new(),
    }
}

/// `0..count`, each once, neighbours far apart.
fn far_apart(count: usize) -> impl Iterator<Item = usize> {
    // A prime beyond any number of nodes here has no divisor in common with it.
    const STRIDE: usize = 1_000_000_007;
    (0..count).map(move |k| k.wrapping_mul(STRIDE) % count)
}
