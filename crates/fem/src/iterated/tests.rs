use std::sync::Arc;

use oilwedge_mesh::{Mesh, RawMesh};

use crate::conservation_law::{Conduction, ConservationLaw, Response, State, TangentKind};
use crate::factorization::LazyAnalysis;
use crate::linear_solver::MultigridSolver;
use crate::linearisation::Route;
use crate::{Analysis, Assembler, Constraints, LinearProlongation, LinearSolver, Linearisation, Matrix, Space};

/// `F = x^3 - grad u` on a ring of period one, with a conductance that varies by a factor of 1000.
struct CubicReaction;

impl ConservationLaw for CubicReaction {
    fn tangent(&self) -> TangentKind {
        TangentKind::Conduction
    }
    fn conduction(&self, _: usize, positions: &[[f64; 2]], out: &mut [Conduction]) {
        for (&[x, _], out) in positions.iter().zip(out) {
            let h = 1.0 + 0.82 * (std::f64::consts::TAU * x).cos();
            *out = Conduction { conductance: [1e-16 * h.powi(3); 2], flux: [1e-6 * h, 0.0], source: 0.0 };
        }
    }
    fn response(&self, _: usize, _: &[[f64; 2]], _: &[State], _: &mut [Response]) {}
}

/// A ring of period one with `columns` times `rows` cells, two crooked triangles each, of the given height.
fn ring(columns: u32, rows: u32, height: f64) -> Arc<Mesh> {
    let vertex = |i: u32, j: u32| (i % columns) * (rows + 1) + j;
    let (width, step) = (1.0 / f64::from(columns), height / f64::from(rows));
    let points = (0..columns * (rows + 1))
        .map(|k| {
            let (i, j) = (f64::from(k / (rows + 1)), f64::from(k % (rows + 1)));
            let inside = (j * (f64::from(rows) - j)).min(1.0);
            [width * (i + 0.15 * (1.7 * j).sin()), step * (j + 0.1 * inside * (2.3 * i).sin())]
        })
        .collect();
    let cells = (0..columns).flat_map(|i| (0..rows).map(move |j| (i, j)));
    let triangles = cells
        .flat_map(|(i, j)| {
            let [a, b, c, d] = [vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1)];
            [[a, b, c], [a, c, d]]
        })
        .collect();
    let raw = RawMesh { points, triangles, period: Some(1.0), ..RawMesh::default() };
    Arc::new(Mesh::build(raw).expect("a mesh"))
}

/// A system with the ends given, its right-hand side, and both ways to solve it.
struct TestSystem {
    matrix: Matrix,
    constraints: Constraints,
    b: Vec<f64>,
    multigrid: LinearSolver,
    direct: LinearSolver,
}

impl TestSystem {
    fn on(mesh: &Arc<Mesh>) -> Self {
        let space = Space::new(mesh.clone(), 2);
        let assembler = Assembler::new(space.clone());
        let pattern = assembler.pattern().clone();
        let mut constraints = Constraints::none(space.dofs());
        let topology = mesh.topology();
        for edge in (0..topology.edges.len() as u32).filter(|&edge| topology.is_boundary(edge)) {
            space.dofs_on_edge(edge).for_each(|dof| constraints.fix(dof, 0.0));
        }
        let mut matrix = Matrix::zero(pattern.clone());
        let b = assembler.tangent_and_residual(&CubicReaction, &vec![0.0; space.dofs()], &mut matrix);
        let direct = LinearSolver::Direct(Arc::new(Analysis::new(&space, pattern.clone()).expect("small")));
        let multigrid = LinearSolver::Multigrid(MultigridSolver {
            between: Arc::new(LinearProlongation::new(&space, pattern.clone())),
            direct: Arc::new(LazyAnalysis::new(space, pattern)),
        });
        Self { matrix, constraints, b, multigrid, direct }
    }

    fn linearised(&self, solver: &LinearSolver) -> Linearisation {
        solver.linearise(self.matrix.clone(), self.constraints.clone()).expect("positive definite")
    }
}

fn distance(a: &[f64], b: &[f64]) -> f64 {
    let greatest = |values: &mut dyn Iterator<Item = f64>| values.fold(0.0, |m: f64, v| m.max(v.abs()));
    greatest(&mut a.iter().zip(b).map(|(a, b)| a - b)) / greatest(&mut b.iter().copied())
}

#[test]
fn steps_do_not_grow_with_the_mesh() {
    for (columns, rows) in [(24, 10), (60, 24), (150, 60), (300, 120)] {
        let system = TestSystem::on(&ring(columns, rows, 0.4));
        let multigrid = system.linearised(&system.multigrid);
        let x = multigrid.solve(&system.b).expect("solved");
        assert_eq!(multigrid.route(), Route::Multigrid);
        assert!(multigrid.steps() <= 22, "{} steps on {columns} x {rows}", multigrid.steps());
        let y = system.linearised(&system.direct).solve(&system.b).expect("solved");
        assert!(distance(&x, &y) < 1e-9, "{:e}", distance(&x, &y));
    }
}

#[test]
fn levels_that_were_freed_are_made_again() {
    let system = TestSystem::on(&ring(60, 24, 0.4));
    let multigrid = system.linearised(&system.multigrid);
    let x = multigrid.solve(&system.b).expect("solved");
    multigrid.free_levels();
    assert_eq!(multigrid.solve(&system.b).expect("solved"), x);
}

#[test]
fn needles_go_to_a_factor() {
    let system = TestSystem::on(&ring(20, 60, 0.01));
    let multigrid = system.linearised(&system.multigrid);
    let x = multigrid.solve(&system.b).expect("solved");
    assert_eq!(multigrid.route(), Route::Switched);
    let steps = multigrid.steps();
    let y = system.linearised(&system.direct).solve(&system.b).expect("solved");
    assert!(distance(&x, &y) < 1e-9, "{:e}", distance(&x, &y));
    // The factor stays.
    multigrid.solve(&system.b).expect("solved");
    assert_eq!(multigrid.steps(), steps);
}

#[test]
fn other_dofs_may_be_held() {
    let mesh = ring(120, 48, 0.4);
    let system = TestSystem::on(&mesh);
    let mut held = system.constraints.clone();
    let space = Space::new(mesh.clone(), 2);
    for (edge, ends) in (0u32..).zip(&mesh.topology().edges) {
        if ends.iter().all(|&v| mesh.points()[v as usize][0] > 0.55) {
            held.fix(space.edge_dof(edge), 0.0);
        }
    }
    let anew = |solver: &LinearSolver| {
        let first = system.linearised(solver);
        first.solve(&system.b).expect("solved");
        let steps = first.steps();
        let second = first.masked_anew(solver, held.clone()).expect("positive definite");
        (second.solve(&system.b).expect("solved"), second.steps() - steps)
    };
    let (x, steps) = anew(&system.multigrid);
    let (y, _) = anew(&system.direct);
    assert!(distance(&x, &y) < 1e-9 && steps <= 17, "{:e} in {steps}", distance(&x, &y));
    assert!(x.iter().zip(&held.fixed).all(|(x, &fixed)| !fixed || *x == 0.0));
}

#[test]
fn threads_do_not_change_a_bit() {
    let system = TestSystem::on(&ring(150, 60, 0.4));
    let on = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("a pool");
        pool.install(|| system.linearised(&system.multigrid).solve(&system.b).expect("solved"))
    };
    assert!(on(1) == on(3));
}

#[test]
fn nothing_gives_nothing_and_nonsense_an_error() {
    let mut system = TestSystem::on(&ring(24, 10, 0.4));
    let zero = vec![0.0; system.b.len()];
    let multigrid = system.linearised(&system.multigrid);
    assert_eq!(multigrid.solve(&zero).expect("solved"), zero);
    let middle = system.matrix.values.len() / 2;
    system.matrix.values[middle] = f64::NAN;
    assert!(system.multigrid.linearise(system.matrix, system.constraints).is_err());
}
