//! The shares of the triangles are all of the difference: nothing is lost where it is told where the error comes from.

use std::sync::OnceLock;

use oilwedge_reynolds::error_bar::FlowGoal;
use oilwedge_reynolds::quantities::load::load;
use oilwedge_reynolds::quantities::power::power;
use oilwedge_reynolds::supply::BoundaryKind;
use oilwedge_reynolds::{FilmSolution, SolvedFilm};

use super::films::{Judged, constant, drawn, set};

/// The quadratic film as a cubic one, so that both loads are integrated by one rule.
fn raised(judged: &Judged) -> SolvedFilm {
    let film = &judged.film.solution;
    let cubic = &judged.cubic;
    let solution = FilmSolution {
        unknown: judged.film.system.cubic().prolongation.prolong(&film.unknown),
        inflow: Vec::new(),
        cavity: vec![false; cubic.solution.unknown.len()],
        film_fraction: None,
        linearisation: film.linearisation.clone(),
        gap_tangent: OnceLock::new(),
        wrong: Vec::new(),
        history: Vec::new(),
        seconds: film.seconds,
        levels: 0,
        fallbacks: Vec::new(),
    };
    SolvedFilm::new(cubic.problem.clone(), &cubic.system, solution)
}

fn net(film: &SolvedFilm, is_asked: impl Fn(&str, BoundaryKind) -> bool) -> f64 {
    let SolvedFilm { system, solution, .. } = film;
    let regions = system.supply.regions();
    let owned = |dof: usize| {
        let owner = system.supply.owner(dof);
        owner.is_some_and(|k| is_asked(&regions[k].name, regions[k].kind))
    };
    let dofs = solution.inflow.iter().enumerate();
    dofs.filter(|(dof, _)| owned(*dof)).map(|(_, inflow)| inflow).sum()
}

#[track_caller]
fn add_up(judged: &Judged) {
    let before = load(&raised(judged)).total;
    let after = load(&judged.cubic).total;
    let wanted = [after.force[0] - before.force[0], after.force[1] - before.force[1], after.pressure - before.pressure];
    let size = wanted.iter().fold(0.0_f64, |size, eta| size.max(eta.abs()));
    assert!(size > 0.0);
    for (goal, wanted) in judged.error.goals.iter().zip(wanted) {
        let sum: f64 = goal.shares.iter().sum();
        assert!((sum - wanted).abs() < 1e-10 * size, "{sum:e} is not {wanted:e}");
    }
    // The powers of shear and of pressure nearly so: their vectors are tangents where viscosity or the cavity change
    // with the film.
    let before = power(&raised(judged));
    let after = power(&judged.cubic);
    let wanted = [after.shear - before.shear, after.pressure - before.pressure];
    for (goal, wanted) in judged.error.drag.iter().zip(wanted) {
        let sum: f64 = goal.shares.iter().sum();
        let rounding = 1e-13 * before.shear;
        assert!((sum - wanted).abs() < 0.25 * wanted.abs() + rounding, "{sum:e} is not {wanted:e}");
    }
}

#[test]
fn of_load_and_drag() {
    add_up(&Judged::of_scene(&drawn("04_flexpde_ring", 8.0, constant)));
    add_up(&Judged::of_scene(&drawn("11_swift_stieber_ring", 8.0, |scene| set(scene, "journal", "eccentricity", 0.9))));
    for name in ["09_drawn_ring", "02_flexpde_shell", "06_flexpde_as_printed", "12_flexpde_shell_cavitated"] {
        add_up(&Judged::of_scene(&drawn(name, 8.0, |_| ())));
    }
}

/// Flows: what the nodes of given pressure let through in cubic elements, less what they do in quadratic ones.
#[test]
fn of_flows() {
    // Where no two regions meet: a node that two share is booked to one of them.
    for scene in [drawn("04_flexpde_ring", 8.0, constant), drawn("04_flexpde_ring", 8.0, |_| ())] {
        let judged = Judged::of_scene(&scene);
        for (goal, error) in &judged.error.flows {
            let is_asked = |name: &str, kind: BoundaryKind| match goal {
                FlowGoal::Ends => kind == BoundaryKind::End,
                FlowGoal::Region(region) => name == region,
            };
            let after = net(&judged.cubic, is_asked);
            let wanted = after - net(&judged.film, is_asked);
            let sum: f64 = error.shares.iter().sum();
            // The functions differ by one that the cubic film balances, to the residual of its iterations.
            assert!((sum - wanted).abs() < 1e-5 * wanted.abs(), "{sum:e} is not {wanted:e}");
        }
    }
}
