//! One pass over a file: its sections, and the numbers in them.
//!
//! Text and binary are read by the same code over a [`Cursor`]. Every count is held against the bytes that are left
//! before anything is allocated for it, and nothing that the file says is trusted: what is found here is put together
//! and checked in [`super::assemble`].

use super::cursor::{Cursor, position};
use crate::Error;

/// What a file holds.
#[derive(Debug, Default)]
pub(super) struct Scan {
    pub(super) binary: bool,
    /// Curves and surfaces with the tags of their physical groups.
    pub(super) entities: Option<Vec<Entity>>,
    /// Coordinates of all nodes, in the order of the file, and their tags.
    pub(super) nodes: Option<Vec<[f64; 3]>>,
    pub(super) node_tags: Vec<u64>,
    pub(super) elements: Option<Vec<ElementBlock>>,
    /// `(dimension, tag, name)` of the named physical groups.
    pub(super) names: Vec<(i32, i32, String)>,
    /// Tags of nodes that correspond, `[node, master]`.
    pub(super) periodic: Vec<[u64; 2]>,
}

/// A curve (dimension 1) or surface (2) of the geometry.
#[derive(Debug)]
pub(super) struct Entity {
    pub(super) dim: i32,
    pub(super) tag: i32,
    /// Tags of its physical groups; the sign is the orientation in the group.
    pub(super) groups: Vec<i32>,
}

/// The elements of one kind on one entity.
#[derive(Debug)]
pub(super) struct ElementBlock {
    pub(super) dim: i32,
    pub(super) entity: i32,
    /// Element type in gmsh's numbering.
    pub(super) kind: i32,
    /// Nodes of one element.
    pub(super) nodes: usize,
    /// Tag of each element, followed by the tags of its nodes.
    pub(super) numbers: Vec<u64>,
}

/// The byte order mark of a text in UTF-8.
const UTF_8: &[u8] = b"\xef\xbb\xbf";
/// Byte order marks of a text in UTF-16.
pub(super) const UTF_16: [&[u8]; 2] = [b"\xff\xfe", b"\xfe\xff"];
/// Most letters of a name in a file; gmsh itself writes no longer ones.
const LONGEST_NAME: usize = 127;
/// Most physical groups of one curve or surface: each element of it is listed in each of them.
const MOST_GROUPS: usize = 8;

/// Finds the sections of a file and reads them.
pub(super) fn scan(bytes: &[u8]) -> Result<Scan, Error> {
    let mut scan = Scan::default();
    let mut format_seen = false;
    if UTF_16.iter().any(|mark| bytes.starts_with(mark)) {
        return Err(Error::Encoding { what: "letters of two bytes (UTF-16)".to_owned() });
    }
    // Editors on Windows put it before a text.
    let mut at = if bytes.starts_with(UTF_8) { UTF_8.len() } else { 0 };
    while let Some(start) = next_section(bytes, &mut at) {
        let name = bytes[start + 1..at].trim_ascii();
        if !format_seen && name != b"MeshFormat" && name != b"Comments" {
            return Err(Error::NotMsh);
        }
        let name = shown(name);
        let refused = |what: &str| Err(damaged(bytes, scan.binary, &name, start, what));
        if name.chars().count() > LONGEST_NAME {
            return refused("the name of this section is too long");
        }
        let twice = match name.as_str() {
            "MeshFormat" => format_seen,
            "Entities" => scan.entities.is_some(),
            "Nodes" => scan.nodes.is_some(),
            "Elements" => scan.elements.is_some(),
            _ => false,
        };
        if twice {
            return refused("a second section of this name");
        }
        at = match name.as_str() {
            "Entities" => scan_entities(bytes, at, &mut scan)?,
            "Nodes" => scan_nodes(bytes, at, &mut scan)?,
            "Elements" => scan_elements(bytes, at, &mut scan)?,
            "Periodic" => scan_periodic(bytes, at, &mut scan)?,
            "PartitionedEntities" => return Err(Error::Partitioned),
            _ => {
                let body = at;
                let end = find(bytes, body, format!("$End{name}").as_bytes())
                    .ok_or_else(|| damaged(bytes, scan.binary, &name, body, &format!("no \"$End{name}\" follows")))?;
                let after = end + 4 + name.len();
                match name.as_str() {
                    "MeshFormat" => {
                        scan.binary = mesh_format(&bytes[body..end])?;
                        format_seen = true;
                    }
                    "PhysicalNames" => {
                        scan.names = physical_names(&bytes[body..end])
                            .map_err(|what| damaged(bytes, scan.binary, &name, body, &what))?;
                    }
                    _ => {}
                }
                after
            }
        };
    }
    if format_seen { Ok(scan) } else { Err(Error::NotMsh) }
}

/// Offset of the next line that opens a section; `at` moves behind that line.
fn next_section(bytes: &[u8], at: &mut usize) -> Option<usize> {
    while *at < bytes.len() {
        let start = *at;
        let length = bytes[start..].iter().position(|&byte| byte == b'\n');
        *at = length.map_or(bytes.len(), |length| start + length + 1);
        if bytes[start] == b'$' {
            return Some(start);
        }
    }
    None
}

fn find(bytes: &[u8], from: usize, needle: &[u8]) -> Option<usize> {
    let mut at = from;
    while let Some(ahead) = bytes[at..].iter().position(|&byte| byte == needle[0]) {
        at += ahead;
        if bytes[at..].starts_with(needle) {
            return Some(at);
        }
        at += 1;
    }
    None
}

/// A word or name of a file as it can be shown, a letter more than the longest name at most.
fn shown(bytes: &[u8]) -> String {
    // A letter has four bytes at most.
    let some = &bytes[..bytes.len().min(4 * (LONGEST_NAME + 1))];
    String::from_utf8_lossy(some).chars().take(LONGEST_NAME + 1).collect()
}

fn damaged(bytes: &[u8], binary: bool, section: &str, at: usize, what: &str) -> Error {
    Error::Damaged {
        section: section.chars().filter(|c| !c.is_control()).take(40).collect(),
        position: position(bytes, at, binary),
        what: what.to_owned(),
    }
}

/// True if the file is binary.
fn mesh_format(body: &[u8]) -> Result<bool, Error> {
    let line = body.split_inclusive(|&byte| byte == b'\n').next().unwrap_or(&[]);
    let words = shown(line);
    let mut words = words.split_ascii_whitespace();
    let version = words.next().unwrap_or("(none)");
    if version != "4.1" {
        return Err(Error::Version { version: version.chars().take(24).collect() });
    }
    let encoding = |what: String| Error::Encoding { what };
    let file_type = words.next().unwrap_or("(none)");
    let size = words.next().unwrap_or("(none)");
    if size != "8" {
        let size: String = size.chars().take(24).collect();
        return Err(encoding(format!("the data size {size} instead of 8 bytes")));
    }
    match file_type {
        "0" => Ok(false),
        "1" => match body.get(line.len()..line.len() + 4) {
            Some([1, 0, 0, 0]) => Ok(true),
            Some([0, 0, 0, 1]) => Err(encoding("big-endian numbers".to_owned())),
            _ => Err(encoding("no mark of its byte order".to_owned())),
        },
        other => {
            let other: String = other.chars().take(24).collect();
            Err(encoding(format!("the file type {other} instead of 0 (text) or 1 (binary)")))
        }
    }
}

fn physical_names(body: &[u8]) -> Result<Vec<(i32, i32, String)>, String> {
    let lines = body.split(|&byte| byte == b'\n').map(<[u8]>::trim_ascii);
    let mut lines = lines.filter(|line| !line.is_empty());
    let count = shown(lines.next().unwrap_or(&[]));
    let names: Vec<_> = lines
        .map(|bytes| {
            let line = String::from_utf8_lossy(bytes);
            let mut words = line.splitn(3, char::is_whitespace);
            let dim = words.next().and_then(|word| word.parse().ok());
            let tag = words.next().and_then(|word| word.parse().ok());
            let name = words.next().map(str::trim);
            let name = name.and_then(|name| name.strip_prefix('"')?.strip_suffix('"'));
            match (dim, tag, name) {
                (Some(_), Some(_), Some(name)) if name.chars().count() > LONGEST_NAME => Err(format!(
                    "the name of a physical group that begins with \"{}\" has more than {LONGEST_NAME} letters",
                    name.chars().take(20).collect::<String>()
                )),
                (Some(dim), Some(tag), Some(name)) => Ok((dim, tag, name.to_owned())),
                _ => Err(format!("\"{}\" is not: dimension, tag and quoted name of a physical group", shown(bytes))),
            }
        })
        .collect::<Result<_, _>>()?;
    if count.parse() != Ok(names.len()) {
        return Err(format!("\"{count}\" names announced, {} present", names.len()));
    }
    Ok(names)
}

fn scan_entities(bytes: &[u8], body: usize, scan: &mut Scan) -> Result<usize, Error> {
    let mut cursor = Cursor::new(bytes, body, scan.binary, "Entities");
    let counts = [
        cursor.count(4, "points")?,
        cursor.count(7, "curves")?,
        cursor.count(7, "surfaces")?,
        cursor.count(7, "volumes")?,
    ];
    let mut entities = Vec::with_capacity(counts[1] + counts[2]);
    for (dim, count) in (0..).zip(counts) {
        for _ in 0..count {
            let tag = cursor.int()?;
            // A point, or the corners of a box.
            cursor.skip(if dim == 0 { 3 } else { 6 })?;
            let groups = cursor.ints("physical groups")?;
            if groups.len() > MOST_GROUPS {
                let what = format!("{} physical groups of one entity, more than {MOST_GROUPS}", groups.len());
                return Err(cursor.damaged(what));
            }
            if dim > 0 {
                let _bounds = cursor.ints("bounding entities")?;
            }
            if dim == 1 || dim == 2 {
                entities.push(Entity { dim, tag, groups });
            }
        }
    }
    scan.entities = Some(entities);
    cursor.close()
}

/// The numbers that open `$Nodes` and `$Elements`: blocks, total, and the span of the tags.
fn opening(cursor: &mut Cursor<'_>, values: usize, what: &str) -> Result<(usize, usize), Error> {
    let blocks = cursor.count(if cursor.is_binary() { 2 } else { 4 }, "blocks")?;
    let total = cursor.count(values, what)?;
    let (least, greatest) = (cursor.size()?, cursor.size()?);
    if total == 0 {
        return Err(cursor.damaged(format!("no {what}")));
    }
    if least == 0 || least > greatest {
        return Err(cursor.damaged(format!("the tags cannot run from {least} to {greatest}")));
    }
    Ok((blocks, total))
}

fn scan_nodes(bytes: &[u8], body: usize, scan: &mut Scan) -> Result<usize, Error> {
    let mut cursor = Cursor::new(bytes, body, scan.binary, "Nodes");
    let (block_count, total) = opening(&mut cursor, 4, "nodes")?;
    let mut tags = Vec::with_capacity(total);
    let mut nodes = Vec::with_capacity(total);
    for _ in 0..block_count {
        let (dim, _entity, parametric) = (cursor.int()?, cursor.int()?, cursor.int()?);
        // Coordinates on the curve (u), on the surface (u, v) or in the volume (u, v, w), which are passed over.
        let own = match (parametric, dim) {
            (0, _) => 0,
            (1, 0..=3) => dim as usize,
            (1, _) => return Err(cursor.damaged(format!("{dim} where a dimension from 0 to 3 should be"))),
            _ => return Err(cursor.damaged(format!("{parametric} where 0 or 1 should be (parametric)"))),
        };
        let count = cursor.count(4, "nodes")?;
        cursor.sizes(count, &mut tags)?;
        cursor.points(count, own, &mut nodes)?;
    }
    if tags.len() != total {
        return Err(cursor.damaged(format!("{total} nodes announced, {} present", tags.len())));
    }
    scan.node_tags = tags;
    scan.nodes = Some(nodes);
    cursor.close()
}

fn scan_elements(bytes: &[u8], body: usize, scan: &mut Scan) -> Result<usize, Error> {
    let mut cursor = Cursor::new(bytes, body, scan.binary, "Elements");
    let (block_count, total) = opening(&mut cursor, 2, "elements")?;
    let mut blocks = Vec::with_capacity(block_count);
    let mut present = 0;
    for _ in 0..block_count {
        let (dim, entity, kind) = (cursor.int()?, cursor.int()?, cursor.int()?);
        let nodes = nodes_of(kind, &cursor)?;
        let count = cursor.count(1 + nodes, "elements")?;
        let mut numbers = Vec::with_capacity((1 + nodes) * count);
        cursor.sizes((1 + nodes) * count, &mut numbers)?;
        present += count;
        blocks.push(ElementBlock { dim, entity, kind, nodes, numbers });
    }
    if present != total {
        return Err(cursor.damaged(format!("{total} elements announced, {present} present")));
    }
    scan.elements = Some(blocks);
    cursor.close()
}

/// Element types of gmsh that are of use here.
pub(super) mod kind {
    pub(in super::super) const LINE: i32 = 1;
    pub(in super::super) const LINE_3: i32 = 8;
    pub(in super::super) const TRIANGLE: i32 = 2;
    pub(in super::super) const TRIANGLE_6: i32 = 9;
    pub(in super::super) const POINT: i32 = 15;
}

/// Nodes of an element of that type; an error for those that are of no use.
fn nodes_of(kind: i32, cursor: &Cursor<'_>) -> Result<usize, Error> {
    let (element, remedy) = match kind {
        kind::POINT => return Ok(1),
        kind::LINE => return Ok(2),
        kind::LINE_3 | kind::TRIANGLE => return Ok(3),
        kind::TRIANGLE_6 => return Ok(6),
        3 | 10 | 16 | 36..=41 | 47..=51 | 57..=61 => {
            ("quadrangles", "mesh without recombination (no Recombine Surface, Mesh.RecombineAll = 0)")
        }
        20..=28 | 42..=46 | 52..=56 | 62..=66 => ("elements of order 3 or more", "set Mesh.ElementOrder to 1 or 2"),
        4..=7 | 11..=14 | 17..=19 | 29..=33 | 71..=83 | 90..=131 | 137 => (
            "volume elements",
            "mesh in two dimensions (gmsh -2) and give physical groups to the surface and its curves only",
        ),
        _ => ("elements of a kind unknown here", "save triangles and lines only"),
    };
    Err(Error::Element { element, kind, position: cursor.position(), remedy })
}

fn scan_periodic(bytes: &[u8], body: usize, scan: &mut Scan) -> Result<usize, Error> {
    let mut cursor = Cursor::new(bytes, body, scan.binary, "Periodic");
    let mut tags = Vec::new();
    for _ in 0..cursor.count(2, "links")? {
        let _entity_and_master = (cursor.int()?, cursor.int()?, cursor.int()?);
        let affine = cursor.count(1, "coefficients")?;
        cursor.skip(affine)?;
        let pairs = cursor.count(2, "pairs of nodes")?;
        cursor.sizes(2 * pairs, &mut tags)?;
    }
    let (pairs, _) = tags.as_chunks::<2>();
    scan.periodic = pairs.to_vec();
    cursor.close()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn header_messages_say_what_to_do() {
        let with_header = |header: &str| {
            let text = format!("$MeshFormat\n{header}\n$EndMeshFormat\n");
            scan(text.as_bytes()).unwrap_err().to_string()
        };
        assert!(with_header("2.2 0 8").contains("-format msh41"));
        assert!(with_header("4 0 8").contains("format 4,"));
        assert!(with_header("4.1 0 99").contains("data size 99"));
        assert!(with_header("4.1 7 8").contains("file type 7"));
        assert!(with_header("4.1 1 8\n\0\0\0\x01").contains("big-endian"));
        assert!(with_header("").contains("(none)"));
        assert!(matches!(scan(b""), Err(Error::NotMsh)));
        assert!(matches!(scan(b"$NOD\n1\n"), Err(Error::NotMsh)));
    }

    #[test]
    fn names_may_hold_spaces() {
        let names = physical_names(b"2\n1 2 \"oil feed\"\r\n2 1 \"film\"\n").unwrap();
        assert_eq!(names, [(1, 2, "oil feed".to_owned()), (2, 1, "film".to_owned())]);
        assert!(physical_names(b"3\n1 2 \"a\"\n").is_err());
        assert!(physical_names(b"1\n1 x \"a\"\n").is_err());
    }
}
