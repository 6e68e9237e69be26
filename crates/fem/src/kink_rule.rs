//! Integrals over triangles through which a kink of the integrand runs, along a level of functions of the elements.
//!
//! ```text
//!   Int_T g(u) dA,   g smooth for u < k and for u > k
//! ```
//!
//! **Method.** A triangle with values below and above `k` at its nodes is quartered, and so is each part of it,
//! [`QUARTERINGS`] times: a part whose nodes lie on one side is integrated as it is. What is left is the kink within
//! parts of a sixteenth of the edges. Where no kink runs it is the [`Rule`] of the degree. **Verified by**
//! `a_kink_along_a_straight_line_is_integrated`.

use std::ops::Range;
use std::sync::OnceLock;

use oilwedge_mesh::Mesh;

use crate::integrate::{Nodal, Points, Rule, value};
use crate::lagrange;
use crate::mapping::Mapping;
use crate::quadrature::{Quadrature, in_quarters};

/// Most times that a part is quartered.
pub const QUARTERINGS: usize = 4;

/// A rule for triangles through which a kink may run; see the [module](self).
#[derive(Debug)]
pub struct KinkRule {
    /// Rules of the levels: level `k` has the triangle quartered `k` times.
    levels: Vec<QuarteredParts>,
}

/// The parts of a triangle quartered so often; part `k` of the level before has those from `4 k` on.
#[derive(Debug)]
struct QuarteredParts {
    /// The points of all parts, one after the other.
    rule: Rule,
    /// Shape functions at the nodes of each part.
    nodes: Vec<Vec<Nodal>>,
}

/// The kink: a level of functions with these values at the nodes of a triangle.
#[derive(Debug, Clone, Copy)]
pub struct Kink<'a, const N: usize> {
    /// The level; none where the integrand is smooth.
    pub level: Option<f64>,
    /// The functions. The kink runs where one of them is below the level and one above.
    pub functions: [&'a Nodal; N],
}

impl KinkRule {
    /// The rule for elements of polynomial degree 1, 2 or 3, made once.
    pub fn for_degree(degree: usize) -> &'static Self {
        static RULES: [OnceLock<KinkRule>; 3] = [const { OnceLock::new() }; 3];
        let degree = degree.clamp(1, RULES.len());
        RULES[degree - 1].get_or_init(|| Self {
            levels: (0..=QUARTERINGS).map(|times| QuarteredParts::new(degree, times)).collect(),
        })
    }

    /// Calls `visit` with every batch of points of triangle `t`.
    pub fn visit<const N: usize>(&self, mesh: &Mesh, t: usize, kink: Kink<N>, mut visit: impl FnMut(&Points)) {
        let mapping = Mapping::of(mesh, t);
        self.visit_part((0, 0), &kink, &mut |rule, batch| rule.visit_batch(&mapping, t, batch, &mut visit));
    }

    /// Calls `visit` with the rule and the points of each part, from that of this level and number on, through which no
    /// kink runs, or that is not quartered further.
    fn visit_part<const N: usize>(
        &self,
        (level, part): (usize, usize),
        kink: &Kink<N>,
        visit: &mut impl FnMut(&Rule, Range<usize>),
    ) {
        let QuarteredParts { rule, nodes } = &self.levels[level];
        if level < QUARTERINGS && kink.runs_through(&nodes[part]) {
            (4 * part..4 * part + 4).for_each(|part| self.visit_part((level + 1, part), kink, visit));
        } else {
            let points = rule.points() / nodes.len();
            visit(rule, part * points..(part + 1) * points);
        }
    }
}

impl QuarteredParts {
    fn new(degree: usize, quarterings: usize) -> Self {
        let nodes = in_quarters(&lagrange::nodes(degree), quarterings);
        let of_part = |nodes: &[[f64; 2]]| lagrange::tabulated(degree, nodes);
        Self {
            rule: Rule::new(Quadrature::for_degree(degree).quartered(quarterings), degree),
            nodes: nodes.chunks(lagrange::shapes(degree)).map(of_part).collect(),
        }
    }
}

impl<const N: usize> Kink<'_, N> {
    /// Whether it runs between these nodes, given by the shape functions there.
    fn runs_through(&self, nodes: &[Nodal]) -> bool {
        let Some(level) = self.level else { return false };
        let (mut is_below, mut is_above) = (false, false);
        for node in nodes {
            for function in self.functions {
                let u = value(node, nodes.len(), function);
                is_below |= u < level;
                is_above |= u > level;
            }
        }
        is_below && is_above
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use oilwedge_mesh::RawMesh;

    /// The unit triangle, with a straight-sided mesh of one.
    fn triangle() -> Mesh {
        Mesh::build(RawMesh {
            points: vec![[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]],
            triangles: vec![[0, 1, 2]],
            ..RawMesh::default()
        })
        .expect("a mesh")
    }

    /// `max(xi - k, 0)` over the unit triangle is `(1 - k)^3/6`, and its step function `(1 - k)^2/2`; points far from
    /// the kink are few.
    #[test]
    fn a_kink_along_a_straight_line_is_integrated() {
        let mesh = triangle();
        for degree in [2, 3] {
            let mut function = Nodal::default();
            for (value, node) in function.iter_mut().zip(lagrange::nodes(degree)) {
                *value = node[0];
            }
            for level in [0.1, 0.37, 0.8] {
                let kink = Kink { level: Some(level), functions: [&function] };
                let (mut raised, mut step, mut area, mut points) = (0.0, 0.0, 0.0, 0);
                KinkRule::for_degree(degree).visit(&mesh, 0, kink, |batch| {
                    for q in 0..batch.positions.len() {
                        let above = batch.value(q, &function) - level;
                        raised += batch.area(q) * above.max(0.0);
                        step += batch.area(q) * f64::from(u8::from(above > 0.0));
                        area += batch.area(q);
                    }
                    points += batch.positions.len();
                });
                let left = 1.0 - level;
                assert!((raised - left.powi(3) / 6.0).abs() < 2e-5, "{degree} {level}: {raised}");
                assert!((step - left.powi(2) / 2.0).abs() < 5e-3, "{degree} {level}: {step}");
                assert!((area - 0.5).abs() < 1e-14, "{area}");
                assert!(points < 16 * 110, "{points}");
            }
        }
    }

    /// Parts on one side of the kink have few points: the integral is that of all parts quartered alike.
    #[test]
    fn parts_without_a_kink_are_not_quartered() {
        let mesh = triangle();
        let mut function = Nodal::default();
        for (value, [x, z]) in function.iter_mut().zip(lagrange::nodes(2)) {
            *value = x * x + 0.5 * z * z - 0.4 * x * z - 0.2;
        }
        let raised = |points: &Points, sum: &mut f64| {
            for q in 0..points.positions.len() {
                *sum += points.area(q) * points.value(q, &function).max(0.0);
            }
        };
        let everywhere = Rule::new(Quadrature::for_degree(2).quartered(QUARTERINGS), 2).integrate(&mesh, 0, raised);
        let mut here = 0.0;
        let kink = Kink { level: Some(0.0), functions: [&function] };
        KinkRule::for_degree(2).visit(&mesh, 0, kink, |points| raised(points, &mut here));
        assert!((here - everywhere).abs() < 1e-12, "{here} {everywhere}");
    }
}
