//! Files of gmsh 4.1 in the forms that gmsh has for one mesh, written without gmsh.

use std::collections::{BTreeMap, HashMap};

use oilwedge_mesh::gmsh::MshFile;

/// Text or little-endian binary.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Encoding {
    /// Text.
    Text,
    /// Binary, little-endian, of 8-byte sizes.
    Binary,
}

/// Type of the triangles and of the lines beside them.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Element {
    /// 3-node triangles and 2-node lines.
    Linear,
    /// 6-node triangles and 3-node lines; the mesh must have mid-side nodes.
    Quadratic,
}

/// Tags of the nodes, in the order of the file.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Numbers {
    /// 1, 2, 3 ...
    Consecutive,
    /// Numbers with gaps, in no order.
    Sparse,
}

/// How a mesh is written.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Form {
    /// Text or binary.
    pub encoding: Encoding,
    /// Type of the elements.
    pub element: Element,
    /// Tags of the nodes.
    pub numbers: Numbers,
    /// Entities among which the nodes, and the elements of each group, are shared out.
    pub entities: usize,
}

/// The bytes of `file` in that form. Groups keep their names; a group gets its place in its list as tag.
///
/// # Panics
/// If mid-side nodes are asked for and absent.
pub fn to_bytes(file: &MshFile, form: Form) -> Vec<u8> {
    let mut out = Writer { encoding: form.encoding, bytes: Vec::new() };
    let blocks = Blocks::new(file, form);
    out.text(match form.encoding {
        Encoding::Text => "$MeshFormat\n4.1 0 8\n",
        Encoding::Binary => "$MeshFormat\n4.1 1 8\n",
    });
    if form.encoding == Encoding::Binary {
        out.row([Word::Int(1)]);
        out.text("\n");
    }
    out.text("$EndMeshFormat\n");
    names(&mut out, file);
    blocks.write_entities(&mut out);
    let tags = write_nodes(&mut out, file, form);
    blocks.write_elements(&mut out, &tags);
    out.bytes
}

/// Vertices and triangles of a mesh in an order without locality, so that a reader is not helped; mid-side nodes are
/// left out.
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
        surfaces: file.surfaces.iter().map(|(name, cells)| (name.clone(), shuffled(cells))).collect(),
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

#[derive(Clone, Copy)]
enum Word {
    Int(i32),
    Size(u64),
    Real(f64),
}

struct Writer {
    encoding: Encoding,
    bytes: Vec<u8>,
}

impl Writer {
    fn text(&mut self, text: &str) {
        self.bytes.extend_from_slice(text.as_bytes());
    }

    /// A line of text, or the numbers of one in binary.
    fn row(&mut self, words: impl IntoIterator<Item = Word>) {
        for word in words {
            match (self.encoding, word) {
                (Encoding::Text, Word::Int(value)) => self.text(&format!("{value} ")),
                (Encoding::Text, Word::Size(value)) => self.text(&format!("{value} ")),
                (Encoding::Text, Word::Real(value)) => self.text(&format!("{value} ")),
                (Encoding::Binary, Word::Int(value)) => self.bytes.extend(value.to_le_bytes()),
                (Encoding::Binary, Word::Size(value)) => self.bytes.extend(value.to_le_bytes()),
                (Encoding::Binary, Word::Real(value)) => self.bytes.extend(value.to_le_bytes()),
            }
        }
        if self.encoding == Encoding::Text {
            self.bytes.pop();
            self.text("\n");
        }
    }

    fn end(&mut self, section: &str) {
        if self.encoding == Encoding::Binary {
            self.text("\n");
        }
        self.text(&format!("$End{section}\n"));
    }
}

fn names(out: &mut Writer, file: &MshFile) {
    let mut text = format!("$PhysicalNames\n{}\n", file.curves.len() + file.surfaces.len());
    for (tag, (name, _)) in (1..).zip(&file.curves) {
        text += &format!("1 {tag} \"{name}\"\n");
    }
    for (tag, (name, _)) in (1..).zip(&file.surfaces) {
        text += &format!("2 {tag} \"{name}\"\n");
    }
    out.text(&(text + "$EndPhysicalNames\n"));
}

/// Writes the nodes and returns their tags.
fn write_nodes(out: &mut Writer, file: &MshFile, form: Form) -> Vec<u64> {
    let count = file.nodes.len();
    let tags: Vec<u64> = match form.numbers {
        Numbers::Consecutive => (1..=count as u64).collect(),
        Numbers::Sparse => far_apart(count).map(|k| 5 + 3 * k as u64 + k as u64 % 2).collect(),
    };
    let nodes: Vec<usize> = (0..count).collect();
    let blocks: Vec<&[usize]> = nodes.chunks(count.div_ceil(form.entities)).collect();
    let ends = [tags.iter().min(), tags.iter().max()].map(|tag| Word::Size(tag.copied().unwrap_or(0)));
    out.text("$Nodes\n");
    out.row([Word::Size(blocks.len() as u64), Word::Size(count as u64), ends[0], ends[1]]);
    for (entity, nodes) in (1..).zip(blocks) {
        out.row([Word::Int(2), Word::Int(entity), Word::Int(0), Word::Size(nodes.len() as u64)]);
        for &node in nodes {
            out.row([Word::Size(tags[node])]);
        }
        for &node in nodes {
            out.row(file.nodes[node].map(Word::Real));
        }
    }
    out.end("Nodes");
    tags
}

/// Elements of one entity.
struct Block {
    dim: i32,
    groups: Vec<i32>,
    /// Nodes of all elements.
    nodes: Vec<Vec<u32>>,
}

/// The entities: curves, then surfaces.
struct Blocks(Vec<Block>);

impl Blocks {
    fn new(file: &MshFile, form: Form) -> Self {
        let mut blocks = Vec::new();
        let mut push = |dim: i32, groups: Vec<i32>, nodes: Vec<Vec<u32>>| {
            for part in nodes.chunks(nodes.len().div_ceil(form.entities)) {
                let groups = groups.clone();
                let nodes = part.to_vec();
                blocks.push(Block { dim, groups, nodes });
            }
        };
        let middles = (form.element == Element::Quadratic).then(|| file.mid_nodes.as_ref().expect("mid-side nodes"));
        let mut middle_of = HashMap::new();
        for (triangle, mids) in file.triangles.iter().zip(middles.into_iter().flatten()) {
            for k in 0..3 {
                let [a, b] = [triangle[k], triangle[(k + 1) % 3]];
                middle_of.insert([a.min(b), a.max(b)], mids[k]);
            }
        }
        for (tag, (_, lines)) in (1..).zip(&file.curves) {
            let nodes = |&[a, b]: &[u32; 2]| {
                let middle = middle_of.get(&[a.min(b), a.max(b)]);
                [a, b].into_iter().chain(middle.copied()).collect()
            };
            push(1, vec![tag], lines.iter().map(nodes).collect());
        }
        for (groups, cells) in by_groups(file) {
            let nodes = |cell: u32| {
                let middle = middles.map(|middles| middles[cell as usize]);
                file.triangles[cell as usize].into_iter().chain(middle.into_iter().flatten()).collect()
            };
            push(2, groups, cells.into_iter().map(nodes).collect());
        }
        Self(blocks)
    }

    fn count(&self, dim: i32) -> u64 {
        self.0.iter().filter(|block| block.dim == dim).count() as u64
    }

    fn write_entities(&self, out: &mut Writer) {
        out.text("$Entities\n");
        out.row([0, self.count(1), self.count(2), 0].map(Word::Size));
        for (tag, block) in (1..).zip(&self.0) {
            let groups = block.groups.iter().map(|&group| Word::Int(group));
            let opening = [Word::Int(tag)].into_iter().chain([Word::Real(0.0); 6]);
            let count = Word::Size(block.groups.len() as u64);
            out.row(opening.chain([count]).chain(groups).chain([Word::Size(0)]));
        }
        out.end("Entities");
    }

    fn write_elements(&self, out: &mut Writer, tags: &[u64]) {
        let count: usize = self.0.iter().map(|block| block.nodes.len()).sum();
        out.text("$Elements\n");
        out.row([self.0.len() as u64, count as u64, 1, count as u64].map(Word::Size));
        let mut element = 0;
        for (entity, block) in (1..).zip(&self.0) {
            let kind = match (block.dim, block.nodes[0].len()) {
                (1, 2) => 1,
                (1, _) => 8,
                (_, 3) => 2,
                _ => 9,
            };
            let elements = Word::Size(block.nodes.len() as u64);
            out.row([Word::Int(block.dim), Word::Int(entity), Word::Int(kind), elements]);
            for nodes in &block.nodes {
                element += 1;
                let nodes = nodes.iter().map(|&node| Word::Size(tags[node as usize]));
                out.row([Word::Size(element)].into_iter().chain(nodes));
            }
        }
        out.end("Elements");
    }
}

/// Triangles that belong to the same groups, in the order of the first group that names them.
fn by_groups(file: &MshFile) -> BTreeMap<Vec<i32>, Vec<u32>> {
    let mut groups_of = vec![Vec::new(); file.triangles.len()];
    let mut order = Vec::new();
    for (tag, (_, cells)) in (1..).zip(&file.surfaces) {
        for &cell in cells {
            if groups_of[cell as usize].is_empty() {
                order.push(cell);
            }
            groups_of[cell as usize].push(tag);
        }
    }
    let mut blocks: BTreeMap<Vec<i32>, Vec<u32>> = BTreeMap::new();
    for cell in order {
        blocks.entry(groups_of[cell as usize].clone()).or_default().push(cell);
    }
    blocks
}
