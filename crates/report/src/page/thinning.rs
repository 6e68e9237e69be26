//! Fewer triangles on the same area: vertices are moved onto a neighbour one by one, far from each other in each pass,
//! so that fine regions stay finer than coarse ones. Vertices that must stay, as those of rims, keep the sides between
//! them.

/// Least shape of new triangles ([`shape`]), and what they may be worse than those before; both fall by half where
/// nothing can be removed.
const GOOD: f64 = 0.5;
const WORSE: f64 = 0.7;
/// A pass that removes less than this share of the vertices has come to its end, and so often shapes may be relaxed.
const FEW: usize = 50;
const RELAXED: usize = 3;

/// Triangles that are thinned out.
struct MeshThinning<'a> {
    /// Place of each vertex [m].
    places: &'a [[f64; 2]],
    /// Length of the circumference [m]: places differ by less than half of it within a triangle.
    period: f64,
    /// Corners, against the clock; `None` where it is gone.
    triangles: Vec<Option<[u32; 3]>>,
    /// Triangles at each vertex.
    around: Vec<Vec<u32>>,
}

/// Removes as many vertices as wanted, or as possible, from triangles that run against the clock; none of those that
/// must stay. Places [m] are on a cylinder of that circumference [m], unrolled.
pub(super) fn thinned(
    places: &[[f64; 2]],
    triangles: &[[u32; 3]],
    must_stay: &[bool],
    (period, wanted): (f64, usize),
) -> Vec<[u32; 3]> {
    let mut around = vec![Vec::new(); places.len()];
    for (t, corners) in (0..).zip(triangles) {
        corners.iter().for_each(|corner| around[*corner as usize].push(t));
    }
    let mut thinning =
        MeshThinning { places, period, triangles: triangles.iter().copied().map(Some).collect(), around };
    let mut order: Vec<u32> = (0..places.len() as u32).filter(|v| !must_stay[*v as usize]).collect();
    order.retain(|v| !thinning.around[*v as usize].is_empty());
    // All over the area, however far a pass comes; the same each time.
    order.sort_by_key(|v| v.wrapping_mul(2_654_435_769));
    let (mut removed, mut relaxed) = (0, 0);
    let mut limits = [GOOD, WORSE];
    while removed < wanted && relaxed <= RELAXED {
        let gone = thinning.pass(&mut order, wanted - removed, limits);
        removed += gone;
        if gone * FEW < order.len() {
            relaxed += 1;
            limits = limits.map(|limit| 0.5 * limit);
        }
    }
    thinning.triangles.into_iter().flatten().collect()
}

impl MeshThinning<'_> {
    /// Removes vertices that are not neighbours of each other; returns how many.
    fn pass(&mut self, order: &mut Vec<u32>, wanted: usize, limits: [f64; 2]) -> usize {
        let mut is_touched = vec![false; self.places.len()];
        let mut gone = 0;
        order.retain(|&v| {
            if gone == wanted || is_touched[v as usize] {
                return true;
            }
            let neighbours = self.neighbours(v);
            let Some(onto) = self.best(v, &neighbours, limits) else {
                return true;
            };
            self.move_onto(v, onto);
            neighbours.iter().for_each(|other| is_touched[*other as usize] = true);
            gone += 1;
            false
        });
        gone
    }

    fn neighbours(&self, v: u32) -> Vec<u32> {
        let corners = self.around[v as usize].iter();
        let mut all: Vec<u32> =
            corners.filter_map(|t| self.triangles[*t as usize]).flatten().filter(|other| *other != v).collect();
        all.sort_unstable();
        all.dedup();
        all
    }

    /// The neighbour onto which a vertex is moved with the best triangles, if those are good enough.
    fn best(&self, v: u32, neighbours: &[u32], [good, worse]: [f64; 2]) -> Option<u32> {
        let star: Vec<[u32; 3]> = self.around[v as usize].iter().filter_map(|t| self.triangles[*t as usize]).collect();
        let before = star.iter().map(|it| self.shape(*it)).fold(f64::INFINITY, f64::min);
        let least = good.min(worse * before);
        let after = |&onto: &u32| {
            let shared = self.neighbours(onto).iter().filter(|it| neighbours.contains(it)).count();
            let moved = star
                .iter()
                .filter(|it| !it.contains(&onto))
                .map(|it| self.shape(it.map(|corner| if corner == v { onto } else { corner })));
            // Neighbours that the two share beside those of their own side would become a fold.
            (shared == 2).then(|| (onto, moved.fold(f64::INFINITY, f64::min)))
        };
        let best = neighbours.iter().filter_map(after).max_by(|a, b| a.1.total_cmp(&b.1))?;
        (best.1 >= least && best.1 > 0.0).then_some(best.0)
    }

    fn move_onto(&mut self, v: u32, onto: u32) {
        for t in std::mem::take(&mut self.around[v as usize]) {
            let Some(corners) = self.triangles[t as usize] else {
                continue;
            };
            if corners.contains(&onto) {
                self.triangles[t as usize] = None;
                for corner in corners.into_iter().filter(|corner| *corner != v) {
                    self.around[corner as usize].retain(|other| *other != t);
                }
            } else {
                self.triangles[t as usize] = Some(corners.map(|corner| if corner == v { onto } else { corner }));
                self.around[onto as usize].push(t);
            }
        }
    }

    /// Twice the height over the longest side, up to 1.73; negative where the triangle is turned over.
    fn shape(&self, corners: [u32; 3]) -> f64 {
        let [a, b, c] = corners.map(|corner| self.places[corner as usize]);
        let from = |point: [f64; 2]| {
            let x = point[0] - a[0];
            [x - self.period * (x / self.period).round(), point[1] - a[1]]
        };
        let (u, v) = (from(b), from(c));
        let longest = [u, v, [v[0] - u[0], v[1] - u[1]]]
            .map(|side| side[0] * side[0] + side[1] * side[1])
            .into_iter()
            .fold(0.0, f64::max);
        2.0 * (u[0] * v[1] - u[1] * v[0]) / longest
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_ring_keeps_its_area_and_its_rims() {
        let (columns, rows) = (60u32, 10u32);
        let number = |i: u32, j: u32| (i % columns) * (rows + 1) + j;
        let places: Vec<[f64; 2]> =
            (0..columns).flat_map(|i| (0..=rows).map(move |j| [f64::from(i), f64::from(j)])).collect();
        let squares = (0..columns).flat_map(|i| (0..rows).map(move |j| (i, j)));
        let triangles: Vec<[u32; 3]> = squares
            .flat_map(|(i, j)| {
                let [a, b, c, d] = [number(i, j), number(i + 1, j), number(i + 1, j + 1), number(i, j + 1)];
                [[a, b, c], [a, c, d]]
            })
            .collect();
        let must_stay: Vec<bool> = places.iter().map(|[_, z]| *z == 0.0 || *z == 10.0).collect();
        let period = f64::from(columns);
        let found = thinned(&places, &triangles, &must_stay, (period, 200));
        assert_eq!(found.len(), triangles.len() - 400);
        let area = |corners: &[u32; 3]| {
            let [a, b, c] = corners.map(|corner| places[corner as usize]);
            let x = |p: [f64; 2]| p[0] - a[0] - period * ((p[0] - a[0]) / period).round();
            0.5 * (x(b) * (c[1] - a[1]) - x(c) * (b[1] - a[1]))
        };
        assert!(found.iter().all(|it| area(it) > 0.0));
        assert!((found.iter().map(area).sum::<f64>() - 600.0).abs() < 1e-9);
        let stays = |v: usize| found.iter().flatten().any(|corner| *corner as usize == v);
        assert!((0..places.len()).all(|v| !must_stay[v] || stays(v)));
        // More than can go: all that can, and no more.
        let least = thinned(&places, &triangles, &must_stay, (period, 10_000));
        assert!((least.iter().map(area).sum::<f64>() - 600.0).abs() < 1e-9 && least.len() < found.len());
    }
}
