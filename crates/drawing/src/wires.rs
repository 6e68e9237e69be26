//! The mesh of the sides of triangles.

use std::collections::HashMap;

use crate::outline::{FinePlace, PLACES, place};
use crate::patch::{PatchSide, sides};
use crate::{Figure, Patch, Pen};

/// Draws the sides of all triangles, each once.
pub fn draw_mesh(figure: &mut Figure, patches: &[Patch], pen: Pen) {
    figure.lines(trails(patches), pen);
}

/// The sides of all triangles as few lines [mm], each side once.
fn trails(patches: &[Patch]) -> Vec<Vec<[f64; 2]>> {
    join(patches.iter().flat_map(|patch| sides(patch).map(|(side, _)| side)).collect())
}

/// Pieces of lines [mm] as few lines: pieces that meet are drawn on from each other.
pub fn joined(pieces: &[[[f64; 2]; 2]]) -> Vec<Vec<[f64; 2]>> {
    let side = |piece: &[[f64; 2]; 2]| -> PatchSide {
        let [a, b] = piece.map(place);
        let middle = [0, 1].map(|d| a[d] + (b[d] - a[d]) / 2);
        if a <= b { [a, b, middle] } else { [b, a, middle] }
    };
    let sides = pieces.iter().map(side);
    join(sides.filter(|[a, b, _]| a != b).collect())
}

fn join(mut all: Vec<PatchSide>) -> Vec<Vec<[f64; 2]>> {
    all.sort_unstable();
    all.dedup();
    let mut at: HashMap<FinePlace, Vec<usize>> = HashMap::new();
    for (k, [a, b, _]) in all.iter().enumerate() {
        at.entry(*a).or_default().push(k);
        at.entry(*b).or_default().push(k);
    }
    let point = |place: FinePlace| place.map(|part| f64::from(part) / PLACES);
    let mut drawn = vec![false; all.len()];
    let mut lines = Vec::new();
    // Lines that have ends are drawn from one of them.
    let end_of =
        |side: &PatchSide| side[..2].iter().copied().find(|end| at.get(end).is_some_and(|sides| sides.len() % 2 == 1));
    let (ends, others): (Vec<usize>, Vec<usize>) = (0..all.len()).partition(|k| end_of(&all[*k]).is_some());
    let starts: Vec<(usize, FinePlace)> =
        ends.into_iter().chain(others).map(|k| (k, end_of(&all[k]).unwrap_or(all[k][0]))).collect();
    for (start, from) in starts {
        if drawn[start] {
            continue;
        }
        // Straight on through as many sides as possible.
        let mut end = from;
        let mut line = vec![point(end)];
        while let Some(next) = at.get_mut(&end).and_then(|sides| {
            while sides.last().is_some_and(|k| drawn[*k]) {
                sides.pop();
            }
            sides.pop()
        }) {
            drawn[next] = true;
            let [a, b, middle] = all[next];
            if is_bent(all[next]) {
                line.push(point(middle));
            }
            end = if a == end { b } else { a };
            line.push(point(end));
        }
        lines.push(line);
    }
    lines
}

/// True where the middle of a side is off the straight line by more than can be seen.
fn is_bent([a, b, middle]: PatchSide) -> bool {
    (0..2).any(|d| (a[d] + b[d] - 2 * middle[d]).abs() > 20)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::patch::grid;

    #[test]
    fn every_side_is_drawn_once() {
        let patches = grid(3, 9.0, |_| 0.0);
        let trails = trails(&patches);
        // 24 upright and level sides, 9 diagonals.
        let sides: usize = trails.iter().map(|trail| trail.len() - 1).sum();
        assert_eq!(sides, 33);
        let length = |pair: &[[f64; 2]]| (pair[1][0] - pair[0][0]).hypot(pair[1][1] - pair[0][1]);
        let whole: f64 = trails.iter().flat_map(|trail| trail.windows(2)).map(length).sum();
        assert!((whole - (24.0 * 3.0 + 9.0 * 18f64.sqrt())).abs() < 1e-6 && trails.len() < 10);
    }
}
