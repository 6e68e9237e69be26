//! Arrays of a film in few letters: differences from what neighbours predict, bytes of equal rank together, deflated,
//! in base 64.
//!
//! Nodes are predicted by those before them: a vertex by the vertex before it, the middle of a side by the mean of the
//! ends of the side. Where a mesh is straight its middles cost nothing. All numbers are whole, so that the page
//! computes the same bits again.

use base64_simd::STANDARD;
use miniz_oxide::deflate::compress_to_vec;
use serde::Serialize;

/// Level of compression: higher ones save one percent and take three times as long.
const LEVEL: u8 = 6;
/// The ends of the side whose middle is node 3, 4 or 5 of a triangle.
const ENDS: [[usize; 2]; 3] = [[0, 1], [1, 2], [2, 0]];

/// An array as it stands in the page.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub(super) struct Packed {
    /// Number of its elements, four bytes each.
    count: usize,
    /// Bytes of rank 0, then of rank 1 and so on, deflated, in base 64.
    data: String,
}

/// Packs whole numbers.
pub(super) fn packed(values: &[u32]) -> Packed {
    let mut planes = Vec::with_capacity(4 * values.len());
    for rank in 0..4 {
        planes.extend(values.iter().map(|value| value.to_le_bytes()[rank]));
    }
    Packed { count: values.len(), data: STANDARD.encode_to_string(compress_to_vec(&planes, LEVEL)) }
}

/// Triangles by their nodes, each as its distance from the first number that none before has: zero for nodes in the
/// order in which they are met.
pub(super) fn triangles(cells: &[[u32; 6]]) -> Vec<u32> {
    let mut next = 0u32;
    let code = |node: &u32| {
        let code = next.wrapping_sub(*node);
        next = next.max(node.wrapping_add(1));
        code
    };
    cells.iter().flatten().map(code).collect()
}

/// What predicts each node: nothing but the node before, or the ends of a side. In the order in which nodes are first
/// met.
#[derive(Debug)]
pub(super) struct Prediction {
    /// Nodes, and the ends of the side that they are the middle of.
    order: Vec<(u32, Option<[u32; 2]>)>,
}

impl Prediction {
    /// The prediction for the nodes of triangles: first all vertices, then all middles.
    pub(super) fn of(cells: &[[u32; 6]], nodes: usize) -> Self {
        let mut is_met = vec![false; nodes];
        let mut order = Vec::with_capacity(nodes);
        let mut meet = |node: u32, ends: Option<[u32; 2]>| {
            if !std::mem::replace(&mut is_met[node as usize], true) {
                order.push((node, ends));
            }
        };
        for cell in cells {
            (0..3).for_each(|k| meet(cell[k], None));
        }
        for cell in cells {
            for (k, [a, b]) in (3..).zip(ENDS) {
                meet(cell[k], Some([cell[a], cell[b]]));
            }
        }
        Self { order }
    }

    /// Differences of values at the nodes from their prediction, around the clock of 32 bits; small ones of either sign
    /// are small numbers.
    pub(super) fn differences(&self, values: &[u32]) -> Vec<u32> {
        let mut last = 0u32;
        let difference = |(node, ends): &(u32, Option<[u32; 2]>)| {
            let value = values[*node as usize];
            let predicted = match ends {
                None => std::mem::replace(&mut last, value),
                Some([a, b]) => middle(values[*a as usize], values[*b as usize]),
            };
            let difference = value.wrapping_sub(predicted) as i32;
            ((difference << 1) ^ (difference >> 31)) as u32
        };
        self.order.iter().map(difference).collect()
    }
}

/// The middle of the shorter way between two numbers around the clock.
fn middle(a: u32, b: u32) -> u32 {
    let way = b.wrapping_sub(a) as i32;
    a.wrapping_add((way >> 1) as u32)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn straight_sides_and_nodes_in_order_cost_nothing() {
        let cells = [[0, 1, 2, 3, 4, 5], [2, 1, 6, 4, 7, 8]];
        assert_eq!(triangles(&cells), [0, 0, 0, 0, 0, 0, 4, 5, 0, 3, 0, 0]);
        let mut values = [10u32, 4_294_967_290, 40, 0, 0, 0, 80, 0, 0];
        for cell in cells {
            for (k, [a, b]) in (3..).zip(ENDS) {
                values[cell[k] as usize] = middle(values[cell[a] as usize], values[cell[b] as usize]);
            }
        }
        assert_eq!(values[3], 2, "the shorter way across zero");
        let differences = Prediction::of(&cells, 9).differences(&values);
        assert_eq!(differences[..4], [20, 31, 92, 80]);
        assert_eq!(differences[4..], [0; 5]);
    }

    #[test]
    fn bytes_of_equal_rank_are_deflated_together() {
        let values: Vec<u32> = (0..1000).map(|k| 0x0100_0000 + k % 7).collect();
        let packed = packed(&values);
        let bytes = STANDARD.decode_to_vec(&packed.data).expect("base 64");
        let planes = miniz_oxide::inflate::decompress_to_vec(&bytes).expect("deflated");
        assert_eq!((packed.count, planes.len()), (1000, 4000));
        assert_eq!((planes[8], planes[1008], planes[3008]), (1, 0, 1));
        assert!(packed.data.len() < 200, "{} letters", packed.data.len());
    }
}
