//! A film for another operating point of the same bearing: physics is made anew, mesh and numbering stay.

use std::mem::discriminant;
use std::sync::Arc;

use oilwedge_reynolds::supply::{BoundaryKind, SupplyRegion};

use super::Film;
use super::made::problem;
use crate::model::Model;
use crate::outline::LinerOutline;
use crate::position::FilmState;
use oilwedge_scene::Feed;

impl Model {
    /// Whether two models make the same system of the same mesh, but for given pressures and the film's thickness.
    pub fn has_same_system(&self, other: &Self) -> bool {
        // Meshes are graded for the shape of the bore.
        self.mesh.bores == other.mesh.bores && self.has_same_unknowns(other)
    }

    /// Whether films of another model have the unknowns of those of this one on any mesh of this one.
    fn has_same_unknowns(&self, other: &Self) -> bool {
        let system = |model: &Self| {
            let sockets = &model.sockets;
            let closure = (sockets.form, discriminant(&sockets.cavitation));
            (sockets.theory, sockets.inlet_fraction, closure, sockets.load.is_some() || sockets.wall.is_some())
        };
        let is_same_region = |(a, b): (&Feed, &Feed)| {
            (&a.group, a.hole, a.groove, a.pressure.is_some()) == (&b.group, b.hole, b.groove, b.pressure.is_some())
        };
        // Feeds that overlap are one region as long as their pressures are equal.
        let names =
            |outline: &LinerOutline| outline.regions().into_iter().map(|region| region.name).collect::<Vec<String>>();
        let (one, other_mesh) = (&self.mesh, &other.mesh);
        let [outline, other_outline] = [&one.outline, &other_mesh.outline];
        one.source == other_mesh.source
            && (outline.liner, outline.film_start) == (other_outline.liner, other_outline.film_start)
            && system(self) == system(other)
            && outline.feeds.len() == other_outline.feeds.len()
            && outline.feeds.iter().zip(&other_outline.feeds).all(is_same_region)
            && names(outline) == names(other_outline)
    }
}

impl Model {
    /// The pressure [Pa] that this model gives in a region of a film of a model like it.
    fn given_pressure(&self, region: &SupplyRegion) -> f64 {
        let of_feed = || {
            let regions = self.mesh.outline.regions();
            regions.iter().find(|feed| feed.name == region.name)?.pressure()
        };
        match region.kind {
            BoundaryKind::Feed => of_feed().unwrap_or(region.pressure),
            BoundaryKind::End | BoundaryKind::Line | BoundaryKind::Sealed => self.mesh.bearing.end_pressure,
        }
    }
}

impl Film {
    /// The film of a model in a state on the system of this one, whose model [`Model::has_same_system`]; `None` where
    /// given pressures of regions that touch would differ, or another film shares the system.
    pub fn reused(self, model: &Arc<Model>, state: &FilmState) -> Option<Self> {
        let mut system = self.system;
        let problem = problem(model, system.space().mesh(), state);
        let pressure = |region: &SupplyRegion| model.given_pressure(region);
        let is_renewed = Arc::get_mut(&mut system)?.renew(&pressure, &problem.film_thickness);
        let film = |system| Self::made(model, state, problem, system);
        is_renewed.then(|| Self { origin: self.origin, seconds: self.seconds, ..film(system) })
    }
    /// The film of a model in a state on the mesh of this one, whose unknowns it has; `None` where it has others, or
    /// where given pressures of regions that touch would differ.
    pub(crate) fn beside(&self, model: &Arc<Model>, state: &FilmState) -> Option<Self> {
        if !self.model.has_same_unknowns(model) {
            return None;
        }
        let problem = problem(model, self.system.space().mesh(), state);
        let pressure = |region: &SupplyRegion| model.given_pressure(region);
        let is_given_so = |region: &SupplyRegion| pressure(region) == region.pressure;
        let system = match self.system.supply.regions().iter().all(is_given_so) {
            true => self.system.clone(),
            false => Arc::new(self.system.with_pressures(&pressure)?),
        };
        Some(Self { origin: self.origin.clone(), ..Self::made(model, state, problem, system) })
    }
}
