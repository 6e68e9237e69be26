//! The balance of the hill: what pressure drives and the journal drags, with a source that fills up where the film
//! forms again.
//!
//! ```text
//! R_i(v) = Int k grad v . grad phi_i - F T/h . grad phi_i dA,      F = U h/2,  v = q - q(p_cav)
//! T = h                    on the side of rupture
//! T = g + (h - g) chi      on the side of reformation while g < h
//! chi = clip(v/e0, 0, 1),  e0 = |F| (1 - g/h) n_x l/k
//! ```
//! l is the size of a triangle over the degree, n_x how far the gradient of the pressure lies along the flow. In a film
//! of thickness h that takes the place of oil g the pressure rises by `|F| (1 - g/h)/k` a length: the front is as wide
//! as a triangle.

use oilwedge_fem::integrate::{Nodal, Rule};
use oilwedge_fem::lagrange::MOST_SHAPES;
use oilwedge_fem::mapping::MappedPoint;
use oilwedge_fem::quadrature::MOST_POINTS;
use oilwedge_fem::{Matrix, Space};

use super::rays::{RaySide, Rays};
use crate::film_law::FilmLaw;
use crate::{FilmProblem, FilmSystem};

/// Lebesgue's constant of cubic triangles is 2.11, that of quadratic ones 1.67.
const LEBESGUE: f64 = 2.2;

/// A point of a triangle on the side of reformation.
#[derive(Debug, Clone, Copy)]
pub(super) struct FrontPoint {
    /// `F dA` [m4/s].
    drag: [f64; 2],
    /// Film thickness h [m].
    thickness: f64,
    /// Oil g [m] as the mass-conserving film has it.
    oil: f64,
    /// `|F| l/k` [Pa].
    rise: f64,
    place: MappedPoint,
}

/// A triangle with points on the side of reformation.
#[derive(Debug)]
pub(super) struct FrontCell {
    cell: usize,
    /// Points of the cell, in the order of the rule.
    points: Vec<FrontPoint>,
    /// The greatest e0 [Pa] where n_x is one.
    widest: f64,
}

/// The discrete balance.
pub(super) struct HillBalance<'a> {
    pub(super) space: &'a Space,
    system: &'a FilmSystem,
    /// What pressure drives.
    pub(super) conduction: Matrix,
    /// What is dragged where the film is full everywhere.
    dragged: Vec<f64>,
    rule: Rule,
    cells: Vec<FrontCell>,
    /// Alignment n_x of the pressure's gradient with the flow, at vertices.
    pub(super) along: Vec<f64>,
}

impl<'a> HillBalance<'a> {
    /// The balance of `problem` on the elements of `system`, with the fronts that these rays have.
    pub(super) fn new(problem: &FilmProblem, system: &'a FilmSystem, rays: &Rays) -> Self {
        let space = system.space();
        let sides = rays.sides(space);
        let law = FilmLaw::new(problem, 1.0);
        let mut conduction = Matrix::zero(system.assembler.pattern().clone());
        let nothing = vec![0.0; space.dofs()];
        let dragged = (system.assembler).tangent_and_residual(&law, &nothing, &mut conduction);
        let rule = Rule::for_degree(space.degree());
        let cells = (0..space.mesh().triangles().len()).filter(|&t| {
            let dofs = &space.element_dofs(t)[..space.shapes()];
            dofs.iter().any(|&dof| matches!(sides[dof], RaySide::Reformation(_)))
        });
        let cells = cells.map(|t| front_cell(&law, space, &rule, rays, t));
        Self {
            space,
            system,
            conduction,
            dragged,
            cells: cells.collect(),
            rule,
            along: vec![1.0; space.mesh().points().len()],
        }
    }

    /// The balance of each node.
    pub(super) fn residual(&self, v: &[f64]) -> Vec<f64> {
        let mut residual = self.conduction.multiply(v);
        residual.iter_mut().zip(&self.dragged).for_each(|(r, dragged)| *r += dragged);
        for (cell, dofs, nodal, along) in self.fronts(v) {
            for (q, point) in cell.points.iter().enumerate() {
                let Some(front) = self.front(q, point, &along) else {
                    continue;
                };
                let empty = 1.0 - front.filled(self.rule.value(q, &nodal));
                if empty == 0.0 {
                    continue;
                }
                // F T/h less F.
                let less = (point.oil / point.thickness - 1.0) * empty;
                for i in 0..self.space.shapes() {
                    let [x, z] = self.rule.gradient(q, i, &point.place);
                    residual[dofs[i]] -= less * (point.drag[0] * x + point.drag[1] * z);
                }
            }
        }
        residual
    }

    /// Writes the derivative of the balance into `tangent`.
    pub(super) fn tangent(&self, v: &[f64], tangent: &mut Matrix) {
        tangent.values.copy_from_slice(&self.conduction.values);
        let n = self.space.shapes();
        for (cell, dofs, nodal, along) in self.fronts(v) {
            let mut square = [[0.0; MOST_SHAPES]; MOST_SHAPES];
            let mut is_moving = false;
            for (q, point) in cell.points.iter().enumerate() {
                let Some(front) = self.front(q, point, &along) else {
                    continue;
                };
                let value = self.rule.value(q, &nodal);
                if value <= 0.0 || value >= front.width {
                    continue;
                }
                is_moving = true;
                let slope = (1.0 - point.oil / point.thickness) / front.width;
                for i in 0..n {
                    let [x, z] = self.rule.gradient(q, i, &point.place);
                    let by = slope * (point.drag[0] * x + point.drag[1] * z);
                    for j in 0..n {
                        square[i][j] -= by * self.rule.shapes(q)[j];
                    }
                }
            }
            if is_moving {
                let addresses = self.system.assembler.addresses(cell.cell, &dofs);
                for i in 0..n {
                    for j in 0..n {
                        tangent.values[addresses[i][j] as usize] += square[i][j];
                    }
                }
            }
        }
    }

    /// The derivative of the residual by the oil that arrives, as a part of it.
    pub(super) fn by_oil(&self, v: &[f64]) -> Vec<f64> {
        let mut change = vec![0.0; v.len()];
        for (cell, dofs, nodal, along) in self.fronts(v) {
            for (q, point) in cell.points.iter().enumerate() {
                let Some(front) = self.front(q, point, &along) else {
                    continue;
                };
                let value = self.rule.value(q, &nodal);
                let empty = match value > 0.0 && value < front.width {
                    // (1 - g/h) (1 - chi) is (1 - g/h) less a multiple of v.
                    true => 1.0,
                    false => 1.0 - front.filled(value),
                };
                let by = point.oil / point.thickness * empty;
                for i in 0..self.space.shapes() {
                    let [x, z] = self.rule.gradient(q, i, &point.place);
                    change[dofs[i]] -= by * (point.drag[0] * x + point.drag[1] * z);
                }
            }
        }
        change
    }

    /// The triangles that are not full everywhere at v, with their dofs, nodal values, and n_x at their corners.
    fn fronts(&self, v: &[f64]) -> impl Iterator<Item = (&FrontCell, [usize; MOST_SHAPES], Nodal, [f64; 3])> {
        self.cells.iter().filter_map(move |cell| {
            let dofs = self.space.element_dofs(cell.cell);
            let mut nodal = [0.0; MOST_SHAPES];
            let (mut least, mut most) = (f64::INFINITY, f64::NEG_INFINITY);
            for i in 0..self.space.shapes() {
                nodal[i] = v[dofs[i]];
                (least, most) = (least.min(nodal[i]), most.max(nodal[i]));
            }
            // No polynomial lies farther from the middle of its nodal values.
            let lowest = 0.5 * (least + most) - 0.5 * LEBESGUE * (most - least);
            let corners = self.space.mesh().triangles()[cell.cell];
            (lowest < cell.widest).then(|| (cell, dofs, nodal, corners.map(|v| self.along[v as usize])))
        })
    }

    /// The front at a point; none where more oil arrives than there is room for.
    fn front(&self, q: usize, point: &FrontPoint, along: &[f64; 3]) -> Option<Front> {
        let missing = 1.0 - point.oil / point.thickness;
        let along: f64 = self.rule.barycentric(q).iter().zip(along).map(|(part, along)| part * along).sum();
        (missing > 0.0).then_some(Front { width: point.rise * missing * along })
    }

    /// Filled share chi at every quadrature point of a triangle, in the order of the points of [`Rule::for_degree`];
    /// none where it is one everywhere.
    pub(super) fn filled(&self, v: &[f64]) -> std::collections::HashMap<usize, Vec<f64>> {
        let of = |(cell, _, nodal, along): (&FrontCell, _, Nodal, [f64; 3])| {
            let filled = |(q, point): (usize, &FrontPoint)| match self.front(q, point, &along) {
                Some(front) => front.filled(self.rule.value(q, &nodal)),
                None => 1.0,
            };
            (cell.cell, cell.points.iter().enumerate().map(filled).collect())
        };
        self.fronts(v).map(of).collect()
    }
}

/// The smeared front at a point.
struct Front {
    /// Width e0 of the front [Pa].
    width: f64,
}

impl Front {
    /// Filled share chi at a value of the unknown.
    fn filled(&self, value: f64) -> f64 {
        (value / self.width).clamp(0.0, 1.0)
    }
}

fn front_cell(law: &FilmLaw, space: &Space, rule: &Rule, rays: &Rays, t: usize) -> FrontCell {
    let mut cell = FrontCell { cell: t, points: Vec::with_capacity(MOST_POINTS), widest: 0.0 };
    let mut area = 0.0;
    rule.visit(space.mesh(), t, |points| {
        let (film, flows) = law.film_and_flows(t, points.positions);
        for (q, &position) in points.positions.iter().enumerate() {
            let flux = flows[q].flux;
            area += points.area(q);
            cell.points.push(FrontPoint {
                drag: flux.map(|flux| flux * points.area(q)),
                thickness: film[q].thickness,
                oil: match rays.side(position) {
                    RaySide::Reformation(oil) => oil,
                    RaySide::Rupture | RaySide::Bare => f64::INFINITY,
                },
                rise: flux[0].hypot(flux[1]) / flows[q].conductance[0],
                place: *points.place(q),
            });
        }
    });
    let size = (2.0 * area).sqrt() / space.degree() as f64;
    for point in &mut cell.points {
        point.rise *= size;
        cell.widest = cell.widest.max(point.rise * (1.0 - point.oil / point.thickness));
    }
    cell
}
