//! # What must vanish at each step of a shaft: force, moment, and power
//!
//! **Equation.** The films carry all loads, with their moment about z = 0; and with the rate e' of the offsets in the
//! films at that step
//! ```text
//! F . e' + sum (T omega + supplied + cavity) = sum (dissipated + W_a . e') + (K u) . e'
//! ```
//! The loads F on the journals and what turns them put power in; it is dissipated in the films, or is stored in the
//! shaft and in the asperities that bear the force W_a. The rate is that of the last stage of the step, so all of this
//! holds for the films of the steps but for the residual of their equations and the round-off of the integrals: the
//! dissipation is an integral of flows over the films, while F and K u know nothing of pressures. How a yielding shell
//! stores and returns its own energy is not in it, nor how the loads bend the shaft between its journals. Films that
//! keep their oil and walls that give way take up power within a step: with them there is no such balance.
//!
//! | symbol | unit | code |
//! |---|---|---|
//! | F, K u | N | `asked`, `by_shaft` |
//! | e' | m/s | `velocity` |
//! | W_a | N | `by_asperities` |
//! | T omega, dissipated | W | [`oilwedge_reynolds::quantities::power::Power`] |
//!
//! **Source.** The balance of the journals (`bearing::shaft::films`) times e', and the energy integral of each film
//! (`reynolds::quantities::power`). **Range.** Steps of a shaft that is not cut. **Verified by**
//! `tests/full/tests/shaft_cycle.rs`.

use oilwedge_bearing::coordinates::Vector;
use oilwedge_bearing::orbit::{Instant, Orbits, PathStep};
use oilwedge_bearing::shaft::{Engine, Films, NoFilmAt, NodeForce, ShaftFilm};

use oilwedge_reynolds::solve::Neighbour;
use rayon::prelude::*;

use super::compile::Compiled;
use super::result::ShaftBalances;
use crate::measure::{Measured, measure};

/// The balances of the whole shaft at its worst step.
///
/// # Errors
/// [`NoFilmAt`]: a film that the shaft had is not found again.
pub(super) fn balances(engine: &Engine, compiled: &Compiled, orbits: &Orbits) -> Result<ShaftBalances, NoFilmAt> {
    let mut worst = ShaftBalances::default();
    let angle = |step: &[PathStep]| engine.speed * step[0].time;
    let magnitudes = |step: &Vec<PathStep>| {
        let loads = engine.loads(angle(step)).into_iter();
        loads.map(|load| load.force[0].hypot(load.force[1])).sum::<f64>()
    };
    let scale = orbits.steps.iter().map(magnitudes).fold(f64::MIN_POSITIVE, f64::max);
    let arm = compiled.loaded_at.iter().copied().fold(f64::MIN_POSITIVE, f64::max);
    let mut powers = [0.0f64, f64::MIN_POSITIVE];
    let films = compiled.films();
    let mut before: Option<Vec<Instant>> = None;
    for step in &orbits.steps {
        let [force, moment] = left_of_loads(engine, compiled, step).map(|[x, y]| x.hypot(y));
        worst.force = worst.force.max(force / scale);
        worst.moment = worst.moment.max(moment / (arm * scale));
        worst.journals = worst.journals.max(step[0].residual);
        let again = |(bearing, (film, step)): (usize, (&ShaftFilm, &PathStep))| {
            let near = before.as_ref().map_or(Neighbour::None, |before| Neighbour::Start(&before[bearing].film));
            film.motion().film_at(step, near).map_err(|reason| NoFilmAt { bearing, reason })
        };
        let journals = films.films.par_iter().zip(step).enumerate();
        let instants = journals.map(again).collect::<Result<Vec<Instant>, NoFilmAt>>()?;
        let [left, dissipated] = left_of_power(&films, &instants, &engine.loads(angle(step)), angle(step));
        before = Some(instants);
        powers = [powers[0].max(left.abs()), powers[1].max(dissipated)];
    }
    let keeps = |film: &ShaftFilm| film.problem.cavitation.conserves_oil() || film.problem.deflection().is_some();
    worst.power = (!films.films.iter().any(keeps)).then_some(powers[0] / powers[1]);
    Ok(worst)
}

/// Loads less forces of all films [N], and their moments about z = 0 [N m].
fn left_of_loads(engine: &Engine, compiled: &Compiled, step: &[PathStep]) -> [[f64; 2]; 2] {
    let loads = engine.loads(engine.speed * step[0].time);
    let (mut force, mut moment) = ([0.0; 2], [0.0; 2]);
    for k in 0..2 {
        for load in &loads {
            force[k] += load.force[k];
            moment[k] += compiled.loaded_at[load.place] * load.force[k];
        }
        for (PathStep { excess: carried, .. }, bearing) in step.iter().zip(&compiled.bearings) {
            force[k] -= carried[k];
            moment[k] -= bearing.at * carried[k] + bearing.coordinates().arm * carried[k + 2];
        }
    }
    [force, moment]
}

/// Power that is put in less power that is stored and dissipated [W], and what is dissipated [W].
fn left_of_power(films: &Films, instants: &[Instant], loads: &[NodeForce], angle: f64) -> [f64; 2] {
    let asked = films.shaft.loads(loads, angle);
    let [at, carried] = [|here: &Instant| here.at, |here: &Instant| here.excess]
        .map(|of: fn(&Instant) -> Vector| instants.iter().map(of).collect::<Vec<_>>());
    let displaced = films.joined(&asked, angle).displaced(&at, &carried);
    let by_shaft = films.shaft.forces(&displaced, angle);
    let [mut left, mut dissipated] = [0.0; 2];
    for (bearing, (here, film)) in instants.iter().zip(&films.films).enumerate() {
        let Measured { power, load, .. } = measure(&here.film);
        let by_asperities = load.contact.map_or([0.0; 4], |share| film.coordinates.forces(&share.resultant()));
        let driving = |k: usize| (asked[bearing][k] - by_shaft[bearing][k] - by_asperities[k]) * here.velocity[k];
        let lost = power.shear + power.driven + power.contact;
        left += (0..4).map(driving).sum::<f64>() + power.friction() + power.supplied + power.cavity - lost;
        dissipated += lost;
    }
    [left, dissipated]
}
