//! Blocks of a file become one list of nodes, of triangles, and named groups.

use std::collections::HashMap;

use super::MshFile;
use super::scan::{ElementBlock, Entity, Scan, kind};
use crate::defect::MOST_DEFECTS;
use crate::{Defect, Error};

/// Puts together what the scan found.
// Long: one pass over the elements, in which nodes, groups and defects are found together.
pub(super) fn assemble(scan: Scan) -> Result<MshFile, Error> {
    let groups = EntityGroups::new(&scan);
    let (nodes, elements) = (scan.nodes.unwrap_or_default(), scan.elements.unwrap_or_default());
    let wrong: Vec<Defect> = nodes
        .iter()
        .zip(&scan.node_tags)
        .filter(|(node, _)| !node.iter().all(|x| x.is_finite()))
        .map(|(node, &tag)| Defect::NotFinite { node: tag, coordinates: node.to_vec() })
        .take(MOST_DEFECTS)
        .collect();
    if !wrong.is_empty() {
        return Err(wrong.into());
    }

    let index = TagIndex::new(&scan.node_tags)?;
    let (straight, curved) = count_triangles(&elements);
    if straight > 0 && curved > 0 {
        return Err(Error::MixedOrders { straight, curved });
    }
    let mut file = MshFile {
        nodes,
        triangles: Vec::with_capacity(straight + curved),
        mid_nodes: (curved > 0).then(|| Vec::with_capacity(curved)),
        periodic: scan
            .periodic
            .iter()
            // gmsh may list nodes of curves that were not saved.
            .filter_map(|pair| Some([index.of(pair[0])?, index.of(pair[1])?]))
            .collect(),
        ..MshFile::default()
    };
    let mut in_group: Vec<Members> = groups.names.iter().map(|_| Members::default()).collect();
    for block in &elements {
        if block.kind == kind::POINT {
            continue;
        }
        let members = groups.of(block)?;
        for element in block.numbers.chunks_exact(1 + block.nodes) {
            let node = |k: usize| {
                let (element, node) = (element[0], element[1 + k]);
                index.of(node).ok_or(Error::Dangling { element, node })
            };
            if matches!(block.kind, kind::LINE | kind::LINE_3) {
                let edge = [node(0)?, node(1)?];
                for &group in members {
                    in_group[group].edges.push(edge);
                }
                continue;
            }
            let triangle = file.triangles.len() as u32;
            file.triangles.push([node(0)?, node(1)?, node(2)?]);
            if let Some(mid_nodes) = &mut file.mid_nodes {
                mid_nodes.push([node(3)?, node(4)?, node(5)?]);
            }
            for &group in members {
                in_group[group].triangles.push(triangle);
            }
        }
    }
    if file.triangles.is_empty() {
        return Err(vec![Defect::Empty].into());
    }
    for (name, members) in groups.names.into_iter().zip(in_group) {
        enter(&mut file.surfaces, &name, members.triangles);
        enter(&mut file.curves, &name, members.edges);
    }
    if file.surfaces.is_empty() && file.curves.is_empty() {
        return Err(Error::NoGroups);
    }
    file.tags = scan.node_tags;
    Ok(file)
}

/// Adds to the group of that name, unless there is nothing to add.
fn enter<T>(groups: &mut Vec<(String, Vec<T>)>, name: &str, members: Vec<T>) {
    match groups.iter_mut().find(|(group, _)| group == name) {
        Some((_, present)) => present.extend(members),
        None if members.is_empty() => {}
        None => groups.push((name.to_owned(), members)),
    }
}

#[derive(Default)]
struct Members {
    edges: Vec<[u32; 2]>,
    triangles: Vec<u32>,
}

fn count_triangles(blocks: &[ElementBlock]) -> (usize, usize) {
    let count = |kind: i32| {
        blocks.iter().filter(|block| block.kind == kind).map(|block| block.numbers.len() / (1 + block.nodes)).sum()
    };
    (count(kind::TRIANGLE), count(kind::TRIANGLE_6))
}

/// The physical groups that each entity belongs to.
struct EntityGroups {
    /// Names in the order of `$PhysicalNames`; groups without a name follow. A name of both a curve and a surface
    /// stands here twice.
    names: Vec<String>,
    of_entity: HashMap<(i32, i32), Vec<usize>>,
}

impl EntityGroups {
    fn new(scan: &Scan) -> Self {
        let mut names = Vec::new();
        let mut number = HashMap::new();
        for (dim, tag, name) in &scan.names {
            number.entry((*dim, *tag)).or_insert_with(|| {
                names.push(name.clone());
                names.len() - 1
            });
        }
        let mut of_entity = HashMap::new();
        for &Entity { dim, tag, ref groups } in scan.entities.iter().flatten() {
            let mut groups: Vec<usize> = groups
                .iter()
                .map(|tag| tag.saturating_abs())
                .map(|tag| {
                    *number.entry((dim, tag)).or_insert_with(|| {
                        names.push(format!("{} {tag}", if dim == 1 { "curve" } else { "surface" }));
                        names.len() - 1
                    })
                })
                .collect();
            groups.sort_unstable();
            groups.dedup();
            of_entity.insert((dim, tag), groups);
        }
        Self { names, of_entity }
    }

    fn of(&self, block: &ElementBlock) -> Result<&[usize], Error> {
        let groups = self.of_entity.get(&(block.dim, block.entity));
        groups.map(Vec::as_slice).ok_or(Error::UnknownEntity { dim: block.dim, tag: block.entity })
    }
}

/// Index of a node by its tag.
enum TagIndex {
    /// Tags are 1, 2, 3 ... in the order of the file.
    Dense(u32),
    /// Index by tag; `u32::MAX` where there is none.
    Table(Vec<u32>),
    /// Tags with their indices, ascending.
    Sorted(Vec<(u64, u32)>),
}

impl TagIndex {
    fn new(tags: &[u64]) -> Result<Self, Error> {
        if (1..).zip(tags).all(|(place, &tag)| place == tag) {
            return Ok(Self::Dense(tags.len() as u32));
        }
        let greatest = tags.iter().copied().max().unwrap_or(0);
        if greatest <= 4 * tags.len() as u64 {
            let mut table = vec![u32::MAX; greatest as usize + 1];
            for (index, &tag) in (0..).zip(tags) {
                let entry = &mut table[tag as usize];
                if *entry != u32::MAX {
                    return Err(Error::DuplicateTag { tag });
                }
                *entry = index;
            }
            return Ok(Self::Table(table));
        }
        let mut sorted: Vec<(u64, u32)> = tags.iter().copied().zip(0..).collect();
        sorted.sort_unstable();
        match sorted.windows(2).find(|pair| pair[0].0 == pair[1].0) {
            Some(pair) => Err(Error::DuplicateTag { tag: pair[0].0 }),
            None => Ok(Self::Sorted(sorted)),
        }
    }

    fn of(&self, tag: u64) -> Option<u32> {
        match self {
            Self::Dense(count) => (tag >= 1 && tag <= u64::from(*count)).then(|| (tag - 1) as u32),
            Self::Table(table) => {
                let index = usize::try_from(tag).ok().and_then(|tag| table.get(tag));
                index.copied().filter(|&index| index != u32::MAX)
            }
            Self::Sorted(sorted) => {
                let place = sorted.binary_search_by_key(&tag, |&(tag, _)| tag).ok()?;
                Some(sorted[place].1)
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tags_in_every_arrangement() {
        for tags in [vec![1, 2, 3], vec![3, 1, 2], vec![7, 1 << 60, 2]] {
            let index = TagIndex::new(&tags).unwrap();
            for (place, &tag) in (0..).zip(&tags) {
                assert_eq!(index.of(tag), Some(place));
            }
            assert_eq!(index.of(0), None);
            assert_eq!(index.of(4), None);
            assert_eq!(index.of(u64::MAX), None);
        }
        assert!(TagIndex::new(&[2, 2, 1]).is_err());
        assert!(TagIndex::new(&[1 << 60, 1 << 60, 1]).is_err());
    }
}
