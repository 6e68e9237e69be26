//! # Viscosity that varies across the film
//!
//! **Equation.** With `eta = y/h` from the bearing to the journal, `F0 = Int 1/mu`, `F1 = Int eta/mu`, `F2 = Int
//! eta^2/mu
//! - F1^2/F0`, all over eta from 0 to 1, the flow per width and the stresses on the walls are
//!
//! ```text
//! J = theta s U h - h^3 F2 grad p,   s = 1 - F1/F0        tau_j = theta U/(h F0) + s h grad p
//!                                                         tau_b = theta U/(h F0) - (1 - s) h grad p
//! ```
//! so that two viscosities and s describe a film: `1/(12 F2)` where pressure drives oil, `1/F0` where the gap is
//! sheared. Both are mu, and s is 1/2, where mu is even. Eddies of a turbulent film divide 1/mu in these integrals
//! ([`EddyFactors`]); s is that with eddies.
//!
//! | symbol | unit | code |
//! |---|---|---|
//! | 1/(12 F2) | Pa s | `viscosity` |
//! | 1/F0 | Pa s | `shear_viscosity` |
//! | s | 1 | `drag` |
//!
//! **Source.** Dowson, Int. J. Mech. Sci. 4 (1962) 159. **Range.** Viscosities at zero gauge pressure: a law of
//! pressure multiplies all of them. **Verified by** the tests below; `heat`: films whose walls have two temperatures.

use oilwedge_fem::Space;
use oilwedge_fem::control_volumes::sub_triangles;

use crate::FilmPoint;

/// What stands for the viscosity at a place where it varies across the film.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AcrossFilm {
    /// Viscosity 1/(12 F2) by which pressure drives oil [Pa s].
    pub viscosity: f64,
    /// Viscosity 1/F0 that the shear of the gap meets [Pa s].
    pub shear_viscosity: f64,
    /// Mean velocity of the oil that the journal drags along, over that of its surface [1].
    pub drag: f64,
    /// What eddies make of a turbulent film; none in a laminar one, whose viscosities are those above.
    pub eddies: Option<EddyFactors>,
}

/// Flow of a turbulent film over that of a laminar one with the same temperatures, as powers of the gap about that for
/// which it was found.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct EddyFactors {
    /// Gap for which the factors were found [m].
    pub gap: f64,
    /// Conductances along x and along z over those of the laminar film at that gap [1].
    pub conductance: [f64; 2],
    /// Powers of the gap with which they grow [1], negative.
    pub conductance_growth: [f64; 2],
    /// Shear stress over that of the laminar film at that gap [1].
    pub shear: f64,
    /// Power of the gap with which it grows [1].
    pub shear_growth: f64,
}

impl EddyFactors {
    /// The means by the weights of three corners.
    fn mean(weights: [f64; 3], corners: [&Self; 3]) -> Self {
        let of = |value: &dyn Fn(&Self) -> f64| (0..3).map(|k| weights[k] * value(corners[k])).sum::<f64>();
        Self {
            gap: of(&|at| at.gap),
            conductance: [0, 1].map(|axis| of(&|at| at.conductance[axis])),
            conductance_growth: [0, 1].map(|axis| of(&|at| at.conductance_growth[axis])),
            shear: of(&|at| at.shear),
            shear_growth: of(&|at| at.shear_growth),
        }
    }
}

/// The viscosity of a film that varies across it, at each node; linear on the sub-triangles between them.
#[derive(Debug, Clone)]
pub struct ViscosityAcross {
    space: Space,
    nodes: Vec<AcrossFilm>,
    /// Node of each dof of a film on the vertices alone; `None` where the dofs are the nodes.
    of_vertices: Option<Vec<usize>>,
}

impl ViscosityAcross {
    /// By the values at the nodes of a `space`.
    pub fn new(space: &Space, nodes: Vec<AcrossFilm>) -> Self {
        Self { space: space.clone(), nodes, of_vertices: None }
    }

    /// This viscosity for a film on the vertices of the mesh alone.
    pub fn on_vertices(&self) -> Self {
        let vertices = 0..self.space.mesh().points().len() as u32;
        Self { of_vertices: Some(vertices.map(|vertex| self.space.vertex_dof(vertex)).collect()), ..self.clone() }
    }

    fn node(&self, dof: usize) -> &AcrossFilm {
        &self.nodes[self.of_vertices.as_ref().map_or(dof, |of_vertices| of_vertices[dof])]
    }

    /// Viscosity by which pressure drives oil at a dof [Pa s].
    pub(crate) fn viscosity(&self, dof: usize) -> f64 {
        self.node(dof).viscosity
    }

    /// Mean velocity of the oil dragged along at a dof, over that of the journal's surface [1].
    pub(crate) fn drag(&self, dof: usize) -> f64 {
        self.node(dof).drag
    }

    /// Sets the viscosities of a film at positions [m] in triangle `cell`.
    pub(crate) fn set(&self, cell: usize, positions: &[[f64; 2]], film: &mut [FilmPoint]) {
        let (dofs, places) = (self.space.element_dofs(cell), self.space.mesh().nodes(cell));
        let subs = sub_triangles(&self.space, cell);
        let mut pieces = [SubTriangle::default(); MOST_SUBS];
        for (piece, corners) in pieces.iter_mut().zip(subs) {
            *piece = SubTriangle::new(corners.map(|corner| places[corner]));
        }
        for (point, position) in film.iter_mut().zip(positions) {
            let (mut sub, mut weights, mut least) = (0, [0.0; 3], f64::NEG_INFINITY);
            for (k, piece) in pieces[..subs.len()].iter().enumerate() {
                let at = piece.weights(*position);
                let lowest = at[0].min(at[1]).min(at[2]);
                if lowest > least {
                    (sub, weights, least) = (k, at, lowest);
                }
            }
            let [a, b, c] = subs[sub].map(|corner| &self.nodes[dofs[corner]]);
            let mean = |[a, b, c]: [f64; 3]| weights[0] * a + weights[1] * b + weights[2] * c;
            point.viscosity = mean([a.viscosity, b.viscosity, c.viscosity]);
            point.shear_viscosity = mean([a.shear_viscosity, b.shear_viscosity, c.shear_viscosity]);
            point.drag = mean([a.drag, b.drag, c.drag]);
            if let (Some(a), Some(b), Some(c)) = (&a.eddies, &b.eddies, &c.eddies) {
                point.eddies = Some(EddyFactors::mean(weights, [a, b, c]));
            }
        }
    }
}

/// Most sub-triangles of a triangle.
const MOST_SUBS: usize = 4;

/// A sub-triangle, as the linear functions that are one at a corner and zero at the others.
#[derive(Debug, Clone, Copy, Default)]
struct SubTriangle {
    last: [f64; 2],
    /// Gradients of the functions of the first two corners [1/m].
    gradients: [[f64; 2]; 2],
}

impl SubTriangle {
    fn new([a, b, c]: [[f64; 2]; 3]) -> Self {
        let ([ax, ay], [bx, by]) = ([a[0] - c[0], a[1] - c[1]], [b[0] - c[0], b[1] - c[1]]);
        let doubled = ax * by - ay * bx;
        Self { last: c, gradients: [[by / doubled, -bx / doubled], [-ay / doubled, ax / doubled]] }
    }

    fn weights(&self, position: [f64; 2]) -> [f64; 3] {
        let (x, z) = (position[0] - self.last[0], position[1] - self.last[1]);
        let [a, b] = self.gradients.map(|[along, across]| along * x + across * z);
        [a, b, 1.0 - a - b]
    }
}
