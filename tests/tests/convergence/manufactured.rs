//! Manufactured solutions on a ring with curved cells.
//!
//! `u = sin(2 x) cosh(z) + x-periodic` of the law `F = -k grad u`, `k = (1 + cos(x)/2)^3`, with the
//! source that makes it a solution. Expected: order `p + 1` in L2 and `p` in H1 (tolerance 0.1).

use std::f64::consts::TAU;
use std::sync::Arc;

use oilwedge_fem::conservation_law::{Conduction, Response, State};
use oilwedge_fem::mapping::Mapping;
use oilwedge_fem::newton;
use oilwedge_fem::{
    Analysis, Assembler, ConservationLaw, Constraints, Field, LinearSolver, Quadrature, Space, TangentKind,
};
use oilwedge_mesh::{Mesh, RawMesh};
use oilwedge_tests::order;

fn exact([x, z]: [f64; 2]) -> f64 {
    x.sin() * (0.7 * z).cosh() + (2.0 * x).cos() * z
}

fn gradient([x, z]: [f64; 2]) -> [f64; 2] {
    [x.cos() * (0.7 * z).cosh() - 2.0 * (2.0 * x).sin() * z, 0.7 * x.sin() * (0.7 * z).sinh() + (2.0 * x).cos()]
}

fn conductance(x: f64) -> f64 {
    (1.0 + 0.5 * x.cos()).powi(3)
}

/// `s = div(k grad u)`, so that `div(-k grad u) + s = 0`.
fn source(point: [f64; 2]) -> f64 {
    let [x, z] = point;
    let by_x = -1.5 * x.sin() * (1.0 + 0.5 * x.cos()).powi(2);
    let laplacian = (0.49 - 1.0) * x.sin() * (0.7 * z).cosh() - 4.0 * (2.0 * x).cos() * z;
    by_x * gradient(point)[0] + conductance(x) * laplacian
}

struct Manufactured;

impl ConservationLaw for Manufactured {
    fn tangent(&self) -> TangentKind {
        TangentKind::Conduction
    }
    fn conduction(&self, _: usize, positions: &[[f64; 2]], out: &mut [Conduction]) {
        for (&point, out) in positions.iter().zip(out) {
            *out = Conduction { conductance: [conductance(point[0]); 2], flux: [0.0; 2], source: source(point) };
        }
    }
    fn response(&self, _: usize, _: &[[f64; 2]], _: &[State], _: &mut [Response]) {}
}

/// A ring of circumference 2 pi and height 2 whose inner edges bulge by the square of their length,
/// as the edges of a smooth curved map do.
fn curved_ring(n: u32) -> Arc<Mesh> {
    let (columns, rows) = (3 * n, n);
    let vertex = |i: u32, j: u32| (i % columns) * (rows + 1) + j;
    let mut raw = RawMesh { period: Some(TAU), ..RawMesh::default() };
    for i in 0..columns {
        for j in 0..=rows {
            raw.points.push([TAU * f64::from(i) / f64::from(columns), 2.0 * f64::from(j) / f64::from(rows) - 1.0]);
        }
    }
    for i in 0..columns {
        for j in 0..rows {
            let [a, b, c, d] = [vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1)];
            raw.bulges.push((raw.triangles.len() as u32, 2, [0.3 / f64::from(n * n), -0.2 / f64::from(n * n)]));
            raw.triangles.extend([[a, b, c], [a, c, d]]);
        }
    }
    Arc::new(Mesh::build(raw).unwrap())
}

/// Errors in L2 and in the H1 seminorm.
fn errors(degree: usize, n: u32) -> [f64; 2] {
    let assembler = Assembler::new(Space::new(curved_ring(n), degree));
    let space = assembler.space();
    let solver = LinearSolver::Direct(Arc::new(Analysis::new(space, assembler.pattern().clone()).unwrap()));
    let mut constraints = Constraints::none(space.dofs());
    for (dof, position) in space.positions().into_iter().enumerate() {
        if position[1].abs() > 1.0 - 1e-12 {
            constraints.fix(dof, exact(position));
        }
    }
    let start = vec![0.0; space.dofs()];
    let equation = newton::Equation {
        assembler: &assembler,
        solver: &solver,
        law: &Manufactured,
        constraints: &constraints,
        scale: 1.0,
    };
    let solution = newton::solve(&equation, start).unwrap();
    assert_eq!(solution.history.len(), 1, "a linear law needs one solve");
    let field = Field { space, values: &solution.u };
    let rule = Quadrature::for_degree(3);
    let mut sums = [0.0; 2];
    for t in 0..space.mesh().triangles().len() {
        let mapping = Mapping::of(space.mesh(), t);
        for (&point, weight) in rule.points.iter().zip(&rule.weights) {
            let place = mapping.at(point);
            let (value, slope) = field.value_and_gradient(t, point);
            let expected = gradient(place.position);
            let area = weight * place.determinant;
            sums[0] += area * (value - exact(place.position)).powi(2);
            sums[1] += area * ((slope[0] - expected[0]).powi(2) + (slope[1] - expected[1]).powi(2));
        }
    }
    sums.map(f64::sqrt)
}

#[test]
fn lagrange_elements_converge_at_their_order() {
    for degree in 1..=3 {
        let levels: Vec<[f64; 2]> = [8, 16, 32].map(|n| errors(degree, n)).into();
        let in_l2 = order(&levels.iter().map(|e| e[0]).collect::<Vec<_>>());
        let in_h1 = order(&levels.iter().map(|e| e[1]).collect::<Vec<_>>());
        assert!((in_l2 - (degree + 1) as f64).abs() < 0.1, "P{degree} in L2: {in_l2}");
        assert!((in_h1 - degree as f64).abs() < 0.1, "P{degree} in H1: {in_h1}");
    }
}
