//! The flows of a film along the sides of its sub-triangles, from node to node.

use std::collections::HashMap;

use oilwedge_fem::Error;
use oilwedge_fem::control_volumes::sub_triangles;

use super::blocks::{Block, SIDES, blocks};
use crate::SolvedFilm;
use crate::film_law::FilmLaw;
use crate::quantities::power::excess;

/// Oil that flows from one node to another one.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct FilmSide {
    /// Dof that it leaves where the flows are positive.
    pub(crate) from: usize,
    /// Dof that it comes to.
    pub(crate) to: usize,
    /// Flow that the journal drags along [m3/s].
    pub(crate) dragged: f64,
    /// Flow that pressure drives [m3/s].
    pub(crate) driven: f64,
    /// Heat of the driven flow [W].
    pub(crate) driven_power: f64,
}

/// A sub-triangle of the film.
#[derive(Debug, Clone, Copy)]
pub(crate) struct FilmPiece {
    /// Dofs at its corners.
    pub(crate) dofs: [usize; 3],
    /// Gradients of their linear functions [1/m].
    pub(crate) gradients: [[f64; 2]; 3],
    /// Area [m2].
    pub(crate) area: f64,
    /// Volume of the piece of each corner's cell [m3].
    pub(crate) volume: [f64; 3],
}

/// What flows from node to node of a film, where no feed covers it.
pub(crate) struct FilmSides {
    /// One entry for each two neighbours.
    pub(crate) sides: Vec<FilmSide>,
    /// The sub-triangles.
    pub(crate) pieces: Vec<FilmPiece>,
}

/// The flows between the nodes of a solved film.
///
/// # Errors
/// The sub-mesh does not fit in memory.
pub(crate) fn film_sides(film: &SolvedFilm) -> Result<FilmSides, Error> {
    let SolvedFilm { problem, system, solution } = film;
    let (space, volumes) = (system.space(), system.volumes()?);
    let blocks = blocks(&FilmLaw::new(problem, 1.0), space, volumes);
    let is_film = system.supply.film(space.mesh());
    let theta = |dof: usize| solution.film_fraction.as_ref().map_or(1.0, |fraction| fraction.values[dof]);
    let (mut sides, mut place) = (Vec::<FilmSide>::new(), HashMap::<u32, usize>::new());
    let mut pieces = Vec::new();
    for (s, block) in blocks.iter().enumerate().filter(|(s, _)| is_film[s / volumes.per_triangle]) {
        let (cell, local) = (s / volumes.per_triangle, s % volumes.per_triangle);
        let nodes = space.mesh().nodes(cell);
        let dofs = volumes.triangles[s].map(|dof| dof as usize);
        pieces.push(piece(dofs, sub_triangles(space, cell)[local].map(|node| nodes[node]), block));
        for (k, (a, b)) in SIDES.into_iter().enumerate() {
            let (a, b) = if dofs[a] < dofs[b] { (a, b) } else { (b, a) };
            let side = *place.entry(volumes.addresses[s][a][b]).or_insert_with(|| {
                sides.push(FilmSide { from: dofs[a], to: dofs[b], ..FilmSide::default() });
                sides.len() - 1
            });
            let (from, to) = (dofs[a], dofs[b]);
            let transport = block.transport();
            sides[side].dragged += transport[a][b] * theta(to) - transport[b][a] * theta(from);
            let [q_a, q_b] = [solution.unknown[from], solution.unknown[to]];
            sides[side].driven += block.stiffness[k] * (q_b - q_a);
            let fall = excess(problem, q_a) - excess(problem, q_b);
            sides[side].driven_power += block.stiffness[k] * (q_b - q_a) * fall;
        }
    }
    Ok(FilmSides { sides, pieces })
}

fn piece(dofs: [usize; 3], x: [[f64; 2]; 3], block: &Block) -> FilmPiece {
    let doubled = (x[1][0] - x[0][0]) * (x[2][1] - x[0][1]) - (x[1][1] - x[0][1]) * (x[2][0] - x[0][0]);
    let gradients = [0, 1, 2].map(|i| {
        let (b, c) = (x[(i + 1) % 3], x[(i + 2) % 3]);
        [(b[1] - c[1]) / doubled, (c[0] - b[0]) / doubled]
    });
    FilmPiece { dofs, gradients, area: 0.5 * doubled, volume: block.volume }
}
