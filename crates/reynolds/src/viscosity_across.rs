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
        for (point, position) in film.iter_mut().zip(positions) {
            let (corners, weights) = around(subs, &places, *position);
            let mean = |value: fn(&AcrossFilm) -> f64| {
                (0..3).map(|k| weights[k] * value(&self.nodes[dofs[corners[k]]])).sum::<f64>()
            };
            point.viscosity = mean(|node| node.viscosity);
            point.shear_viscosity = mean(|node| node.shear_viscosity);
            point.drag = mean(|node| node.drag);
            let [a, b, c] = corners.map(|corner| self.nodes[dofs[corner]].eddies.as_ref());
            point.eddies = a.zip(b).zip(c).map(|((a, b), c)| EddyFactors::mean(weights, [a, b, c]));
        }
    }
}

/// The sub-triangle of a triangle with nodes at `places` that holds a position, and the weights of its corners there.
fn around(subs: &[[usize; 3]], places: &[[f64; 2]], position: [f64; 2]) -> ([usize; 3], [f64; 3]) {
    let weights = |corners: &[usize; 3]| {
        let [a, b, c] = corners.map(|corner| places[corner]);
        let doubled = |[a, b, c]: [[f64; 2]; 3]| (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
        let all = doubled([a, b, c]);
        [[position, b, c], [a, position, c], [a, b, position]].map(|part| doubled(part) / all)
    };
    let least = |weights: &[f64; 3]| weights.iter().copied().fold(f64::INFINITY, f64::min);
    let subs = subs.iter().map(|corners| (*corners, weights(corners)));
    subs.max_by(|(_, a), (_, b)| least(a).total_cmp(&least(b))).expect("a triangle has sub-triangles")
}
