//! Edges of polygons joined to outlines: edges that two polygons share vanish, the others become closed lines.

use std::collections::HashMap;

/// A place in parts of a millimetre.
pub(crate) type FinePlace = [i32; 2];

/// Places in a millimetre.
pub(crate) const PLACES: f64 = 1000.0;
/// How far a closed line may be from the points that it leaves out [places].
const TOLERANCE: f64 = 12.0;
/// Least area of what is drawn [places squared].
const LEAST_AREA: f64 = 1500.0;

/// The place of a point on the sheet [mm].
pub(crate) fn place(point: [f64; 2]) -> FinePlace {
    point.map(|part| (PLACES * part).round() as i32)
}

/// Directed edges of polygons that all run the same way round.
#[derive(Debug, Default)]
pub(crate) struct Edges {
    counts: HashMap<(FinePlace, FinePlace), u32>,
}

impl Edges {
    /// Adds an edge; one that runs the other way is taken away instead.
    pub(crate) fn add(&mut self, from: FinePlace, to: FinePlace) {
        if from == to {
            return;
        }
        if let Some(count) = self.counts.get_mut(&(to, from)).filter(|count| **count > 0) {
            *count -= 1;
        } else {
            *self.counts.entry((from, to)).or_insert(0) += 1;
        }
    }

    /// Adds the edges of a polygon.
    pub(crate) fn add_polygon(&mut self, corners: &[FinePlace]) {
        for (k, corner) in corners.iter().enumerate() {
            self.add(*corner, corners[(k + 1) % corners.len()]);
        }
    }

    /// Closed lines through the edges, simplified [mm]. As many edges leave each place as arrive there, so all lines
    /// close.
    pub(crate) fn into_outlines(self) -> Vec<Vec<[f64; 2]>> {
        let mut edges: Vec<(FinePlace, FinePlace)> =
            self.counts.into_iter().flat_map(|(edge, count)| std::iter::repeat_n(edge, count as usize)).collect();
        edges.sort_unstable();
        let mut leaving: HashMap<FinePlace, Vec<FinePlace>> = HashMap::new();
        for (from, to) in edges.iter().rev() {
            leaving.entry(*from).or_default().push(*to);
        }
        let mut outlines = Vec::new();
        for (start, _) in edges {
            let mut line = Vec::new();
            let mut at = start;
            while let Some(next) = leaving.get_mut(&at).and_then(Vec::pop) {
                line.push(at);
                at = next;
            }
            let line = simplified(&line);
            if line.len() > 2 && area(&line).abs() >= LEAST_AREA {
                outlines.push(line.into_iter().map(|place| place.map(|part| f64::from(part) / PLACES)).collect());
            }
        }
        outlines
    }
}

fn area(line: &[FinePlace]) -> f64 {
    let cross = |k: usize| {
        let ([a, b], [c, d]) = (line[k].map(f64::from), line[(k + 1) % line.len()].map(f64::from));
        a * d - b * c
    };
    0.5 * (0..line.len()).map(cross).sum::<f64>()
}

/// A closed line without the points that lie on it (Douglas and Peucker).
fn simplified(line: &[FinePlace]) -> Vec<FinePlace> {
    let distance = |k: usize| (0..2).map(|d| (f64::from(line[k][d]) - f64::from(line[0][d])).powi(2)).sum::<f64>();
    let Some(far) = (0..line.len()).max_by(|a, b| distance(*a).total_cmp(&distance(*b))) else {
        return Vec::new();
    };
    let mut kept = vec![false; line.len() + 1];
    [kept[0], kept[far], kept[line.len()]] = [true; 3];
    let mut spans = vec![(0, far), (far, line.len())];
    while let Some((from, to)) = spans.pop() {
        let (a, b) = (line[from], line[to % line.len()]);
        let off = |k: usize| distance_to_segment(line[k], a, b);
        let worst = (from + 1..to).map(|k| (k, off(k))).max_by(|a, b| a.1.total_cmp(&b.1));
        if let Some((k, _)) = worst.filter(|(_, off)| *off > TOLERANCE) {
            kept[k] = true;
            spans.extend([(from, k), (k, to)]);
        }
    }
    (0..line.len()).filter(|k| kept[*k]).map(|k| line[k]).collect()
}

fn distance_to_segment(point: FinePlace, from: FinePlace, to: FinePlace) -> f64 {
    let [p, a, b] = [point, from, to].map(|place| place.map(f64::from));
    let (along, beside) = ([b[0] - a[0], b[1] - a[1]], [p[0] - a[0], p[1] - a[1]]);
    let length = along[0].powi(2) + along[1].powi(2);
    let part =
        if length > 0.0 { ((along[0] * beside[0] + along[1] * beside[1]) / length).clamp(0.0, 1.0) } else { 0.0 };
    (beside[0] - part * along[0]).hypot(beside[1] - part * along[1])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shared_edges_vanish_and_the_rest_closes() {
        let mut edges = Edges::default();
        let square = |x: i32, y: i32| [[x, y], [x + 1000, y], [x + 1000, y + 1000], [x, y + 1000]];
        // Three by three squares without the one in the middle.
        for (x, y) in (0..3).flat_map(|x| (0..3).map(move |y| (x, y))).filter(|at| *at != (1, 1)) {
            edges.add_polygon(&square(1000 * x, 1000 * y));
        }
        let mut outlines = edges.into_outlines();
        outlines.sort_by_key(Vec::len);
        assert_eq!(outlines.len(), 2);
        let areas: Vec<f64> =
            outlines.iter().map(|line| area(&line.iter().map(|point| place(*point)).collect::<Vec<_>>())).collect();
        assert!(areas.contains(&9e6) && areas.contains(&-1e6), "{areas:?}");
        assert!(outlines.iter().all(|line| line.len() == 4), "{outlines:?}");
    }
}
