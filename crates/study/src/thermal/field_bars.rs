//! What layers and mesh leave open of a film whose temperatures are found across it.
//!
//! Two films stand beside the one that is reported, in balance with the same load: one with the temperatures of more
//! layers, and one with those that a finer mesh is expected to give, by the first order of the scheme, from those on
//! the vertices alone. What each number changes by is added to its bar; temperatures themselves are compared with those
//! on the vertices.

use std::borrow::Cow;
use std::collections::HashMap;
use std::sync::Arc;

use oilwedge_bearing::InitialGuess;
use oilwedge_bearing::film_heat::FilmHeat;
use oilwedge_bearing::heat_beside::HeatBeside;
use oilwedge_heat::Layers;
use oilwedge_reynolds::solve::Neighbour;
use oilwedge_reynolds::{ReferenceFilm, SolvedFilm};

use crate::film::Film;
use crate::isothermal::isothermal;
use crate::measure::measure;
use crate::quantities::{self, Quantity, View};
use crate::solved::{Errors, SolveOptions, Solved};
use crate::thermal_model::HeatFieldModel;

/// Layers more than those reported.
const MORE: usize = 2;

/// The solved film with what layers and mesh leave open, where errors are estimated.
pub(super) fn widened(solved: Solved, model: &HeatFieldModel, options: &SolveOptions) -> Solved {
    let Some(heat) = solved.film.heat.clone().filter(|_| options.errors == Errors::Estimated && !solved.is_ended())
    else {
        return solved;
    };
    let heat_bars = open(&solved, &heat, model, options).unwrap_or_default();
    Solved { heat_bars, ..solved }
}

/// What is left open of each number; none where one of the films beside does not exist.
fn open(
    solved: &Solved,
    heat: &FilmHeat,
    model: &HeatFieldModel,
    options: &SolveOptions,
) -> Option<HashMap<Cow<'static, str>, f64>> {
    let Some(ReferenceFilm::Coarse { film: coarse, .. }) = &solved.reference else { return None };
    let viscosity = |temperature: f64| solved.film.viscosity_at(temperature);
    let space = solved.film.system.space();
    let network = |film: &SolvedFilm| model.surroundings.network(film).ok();
    let here = (space, network(&solved.primary)?);
    let by_layers = heat.with_layers(&model.surroundings, here, &more_layers(heat)?, &viscosity).ok()?;
    let vertices = (space, coarse.system.space());
    let on_vertices = heat.on_vertices(&model.surroundings, vertices, network(coarse)?, &viscosity).ok()?;
    let across = heat.extrapolated(space, &on_vertices.heat, &viscosity);
    let by_mesh = HeatBeside { across, ..on_vertices };
    let here = numbers(&solved.film, &solved.primary);
    let mut open: HashMap<Cow<'static, str>, f64> = here.iter().map(|quantity| (quantity.name.clone(), 0.0)).collect();
    let of_layers = heat.layers.left_open(&by_layers.heat.layers);
    for (part, HeatBeside { heat, across }) in [(of_layers, by_layers), (1.0, by_mesh)] {
        let mut film = Film { heat: Some(Arc::new(heat)), ..solved.film.clone() };
        film.problem.viscosity_across = Some(across);
        let guess = InitialGuess::Near(Neighbour::Start(&solved.primary));
        let beside = isothermal(&film, &SolveOptions { errors: Errors::Omitted, guess, ..*options }).ok()?;
        let there = numbers(&beside.film, &beside.primary);
        for quantity in &here {
            let other = there.iter().find(|other| other.name == quantity.name)?;
            *open.get_mut(&quantity.name)? += part * quantity.row.difference(other.value, quantity.value).abs();
        }
    }
    Some(open)
}

/// Other layers than those of temperatures found: more of them, or less where there are no more.
pub(crate) fn more_layers(heat: &FilmHeat) -> Option<Layers> {
    let count = heat.layers.count();
    heat.layers.alike(count + MORE).or_else(|| heat.layers.alike(count - MORE))
}

fn numbers(film: &Film, solved: &SolvedFilm) -> Vec<Quantity> {
    let measured = measure(solved).with_dynamics(film, solved, None);
    quantities::measured(&View::new(film, &film.problem, &measured))
}
