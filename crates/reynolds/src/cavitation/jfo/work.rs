//! What the flows between cells work against the pressure: each balance times the pressure of its node, summed.
//!
//! `sum of P_i (K q + B theta)_i` falls into what pressure drives, what the journal drags and what the film takes up. Inside a cavity P is
//! even and the columns of B sum to zero, so that nothing is worked there.

use super::blocks::{Block, SIDES, blocks};
use crate::cavitation::FilmFraction;
use crate::film_law::FilmLaw;
use crate::quantities::power::Work;
use crate::{FilmProblem, FilmSolution, FilmSystem};

/// Powers [W] of a mass-conserving film with the pressures `excess` [Pa] above that of the ends; that of shear, `shear`, is given.
pub(crate) fn work(
    problem: &FilmProblem,
    system: &FilmSystem,
    film: &FilmSolution,
    fraction: &FilmFraction,
    excess: &[f64],
    shear: f64,
) -> Work {
    let mut sum = Work {
        shear,
        ..Work::default()
    };
    // The film was solved on them.
    let Ok(volumes) = system.volumes() else {
        return Work { shear: f64::NAN, ..sum };
    };
    let law = FilmLaw::new(problem, 1.0);
    let blocks = blocks(&law, system.space(), volumes);
    for (t, nodes) in volumes.triangles.iter().enumerate() {
        let at = |values: &[f64]| nodes.map(|node| values[node as usize]);
        let (p, q, theta) = (at(excess), at(&film.unknown), at(&fraction.values));
        let (pressure, squeeze) = carried(&blocks[t], fraction, t, p, theta);
        sum += Work {
            cavity_shear: 0.0,
            shear: 0.0,
            pressure,
            squeeze,
            driven: driven(&blocks[t], p, q),
        };
    }
    sum
}

/// What dragging oil along and taking it up works, in one sub-triangle.
fn carried(block: &Block, fraction: &FilmFraction, t: usize, p: [f64; 3], theta: [f64; 3]) -> (f64, f64) {
    let transport = block.transport(fraction.forms[t], block);
    let outflow: f64 = (0..3)
        .map(|i| p[i] * (0..3).map(|j| transport[i][j] * theta[j]).sum::<f64>())
        .sum();
    let stored: f64 = (0..3).map(|i| p[i] * block.storage[i] * theta[i]).sum();
    (stored - outflow, -stored)
}

fn driven(block: &Block, p: [f64; 3], q: [f64; 3]) -> f64 {
    let along = |(k, (a, b)): (usize, (usize, usize))| -block.stiffness[k] * (p[a] - p[b]) * (q[a] - q[b]);
    SIDES.into_iter().enumerate().map(along).sum()
}
