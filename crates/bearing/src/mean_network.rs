//! # The films of a cycle as one network of heat
//!
//! **Equation.** Temperatures that do not follow the motion of the journal see the means over the cycle of what
//! carries, makes and conducts heat: of the flows between cells, of their powers, and of `theta/h`. What the cells hold
//! at the end of a cycle is what they held at its beginning, so that the mean flows of each cell sum to zero but for
//! what steps in time leave over, `d_i`. A flow along the network takes it to the boundary: `w (phi_i - phi_j)` from i
//! to j, w what flows there on average, by `sum_j w (phi_i - phi_j) = d_i` with phi = 0 at the boundary.
//!
//! | symbol | unit | code |
//! |---|---|---|
//! | d, w, phi | m3/s, m3/s, 1 | `left_over`, `weights`, `potential` |
//!
//! **Source.** `docs/theory/thermal_film.md`; Hestenes, Stiefel, J. Res. NBS 49 (1952) 409, for the equation of phi.
//! **Range.** Laminar films of one mesh. **Verified by** `tests/tests/thermal_cycle.rs`.

use oilwedge_heat::{FilmCell, FilmLink, FilmPort};
use oilwedge_reynolds::quantities::heat_network::NodeNetwork;

/// Part of the flow that is left over, at which the potential is found.
const FOUND: f64 = 1e-15;
/// Part of the greatest weight that each link has at least.
const LEAST_WEIGHT: f64 = 1e-9;

/// The mean of the networks of a cycle, weighed by these parts of its time; `None` where there are none.
pub fn mean_network(weighed: &[(f64, &NodeNetwork)]) -> Option<NodeNetwork> {
    let (_, first) = weighed.first()?;
    let all: f64 = weighed.iter().map(|(weight, _)| weight).sum();
    let mean =
        |of: &dyn Fn(&NodeNetwork) -> f64| weighed.iter().map(|(weight, one)| weight * of(one)).sum::<f64>() / all;
    let cell = |k: usize| {
        let thickness = mean(&|one| one.cells[k].thickness);
        FilmCell {
            thickness,
            film_fraction: thickness * mean(&|one| one.cells[k].film_fraction / one.cells[k].thickness),
            shear_power: mean(&|one| one.cells[k].shear_power),
            driven_power: mean(&|one| one.cells[k].driven_power),
            cross_power: mean(&|one| one.cells[k].cross_power),
            ..first.cells[k]
        }
    };
    let link = |k: usize| FilmLink {
        dragged: mean(&|one| one.links[k].dragged),
        driven: mean(&|one| one.links[k].driven),
        ..first.links[k]
    };
    let port = |k: usize| FilmPort {
        dragged: mean(&|one| one.ports[k].dragged),
        driven: mean(&|one| one.ports[k].driven),
        ..first.ports[k]
    };
    let mut network = NodeNetwork {
        dofs: first.dofs.clone(),
        cells: (0..first.cells.len()).map(cell).collect(),
        links: (0..first.links.len()).map(link).collect(),
        ports: (0..first.ports.len()).map(port).collect(),
        feeds: first.feeds.clone(),
        eddies: first.eddies.clone(),
    };
    conserve(&mut network);
    Some(network)
}

/// Flow that leaves each cell, ports included [m3/s].
fn left_over(network: &NodeNetwork) -> Vec<f64> {
    let mut leaving = vec![0.0; network.cells.len()];
    for link in &network.links {
        leaving[link.from] += link.dragged + link.driven;
        leaving[link.to] -= link.dragged + link.driven;
    }
    network.ports.iter().for_each(|port| leaving[port.cell] -= port.dragged + port.driven);
    leaving
}

/// Takes what is left over to the boundary.
fn conserve(network: &mut NodeNetwork) {
    let flows: Vec<f64> = network.links.iter().map(|link| (link.dragged + link.driven).abs()).collect();
    let least = LEAST_WEIGHT * flows.iter().copied().fold(f64::MIN_POSITIVE, f64::max);
    let weights: Vec<f64> = flows.iter().map(|flow| flow + least).collect();
    let mut is_free = vec![true; network.cells.len()];
    network.ports.iter().for_each(|port| is_free[port.cell] = false);
    let mut wanted = left_over(network);
    wanted.iter_mut().zip(&is_free).for_each(|(wanted, &free)| *wanted *= f64::from(u8::from(free)));
    let potential = potential(network, (&weights, &is_free), &wanted);
    for (link, weight) in network.links.iter_mut().zip(&weights) {
        link.driven -= weight * (potential[link.from] - potential[link.to]);
    }
    let rest = left_over(network);
    network.ports.iter_mut().for_each(|port| port.driven += rest[port.cell]);
}

/// The potential whose flow leaves what is wanted to the boundary: by conjugate gradients.
fn potential(network: &NodeNetwork, (weights, is_free): (&[f64], &[bool]), wanted: &[f64]) -> Vec<f64> {
    let count = wanted.len();
    let mut diagonal = vec![f64::MIN_POSITIVE; count];
    for (link, weight) in network.links.iter().zip(weights) {
        diagonal[link.from] += weight;
        diagonal[link.to] += weight;
    }
    let apply = |x: &[f64]| {
        let mut y = vec![0.0; count];
        for (link, weight) in network.links.iter().zip(weights) {
            let flow = weight * (x[link.from] - x[link.to]);
            y[link.from] += flow;
            y[link.to] -= flow;
        }
        y.iter_mut().zip(is_free).filter(|(_, free)| !**free).for_each(|(y, _)| *y = 0.0);
        y
    };
    let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
    let (mut x, mut rest) = (vec![0.0; count], wanted.to_vec());
    let scaled = |rest: &[f64]| rest.iter().zip(&diagonal).map(|(rest, by)| rest / by).collect::<Vec<f64>>();
    let mut along = scaled(&rest);
    let mut size = dot(&rest, &along);
    let enough = FOUND * FOUND * size;
    for _ in 0..count {
        if size <= enough {
            break;
        }
        let image = apply(&along);
        let step = size / dot(&along, &image);
        x.iter_mut().zip(&along).for_each(|(x, along)| *x += step * along);
        rest.iter_mut().zip(&image).for_each(|(rest, image)| *rest -= step * image);
        let next = scaled(&rest);
        let grown = dot(&rest, &next);
        along.iter_mut().zip(&next).for_each(|(along, next)| *along = next + grown / size * *along);
        size = grown;
    }
    x
}
