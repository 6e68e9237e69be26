//! A film for another operating point of the same bearing: physics is made anew, mesh and numbering stay.

use std::mem::discriminant;
use std::sync::Arc;

use oilwedge_mesh::generate::moved;
use oilwedge_reynolds::FilmSystem;
use oilwedge_reynolds::supply::{BoundaryKind, SupplyRegion};

use super::Film;
use super::made::{disc, problem};
use crate::model::Model;
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
        let drawn = |model: &Self| model.mesh.outline.blueprint();
        self.has_same_kinds(other) && drawn(self) == drawn(other)
    }

    /// Whether another model has the kinds of unknowns, the parts of the bearing and the mesh source of this one.
    fn has_same_kinds(&self, other: &Self) -> bool {
        let system = |model: &Self| {
            let sockets = &model.sockets;
            let closure = (sockets.form, discriminant(&sockets.cavitation));
            (sockets.theory, sockets.inlet_fraction, closure, sockets.load.is_some() || sockets.wall.is_some())
        };
        let is_same_region = |(a, b): (&Feed, &Feed)| {
            let kind = |feed: &Feed| (feed.hole.is_some(), feed.groove.is_some(), feed.pressure.is_some());
            a.group == b.group && kind(a) == kind(b)
        };
        // Feeds that overlap are one region as long as their pressures are equal.
        let names = |model: &Self| -> Vec<String> {
            model.mesh.outline.regions().into_iter().map(|region| region.name).collect()
        };
        let (one, another) = (&self.mesh, &other.mesh);
        one.source == another.source
            && system(self) == system(other)
            && one.outline.feeds.len() == another.outline.feeds.len()
            && one.outline.feeds.iter().zip(&another.outline.feeds).all(is_same_region)
            && names(self) == names(other)
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

    /// The film of a model in a state on the mesh of this one or, where the bearing is drawn a little differently, on
    /// that mesh moved; `None` where it has other unknowns, or where given pressures of regions that touch would
    /// differ.
    pub(crate) fn beside(&self, model: &Arc<Model>, state: &FilmState) -> Option<Self> {
        let system = match self.model.has_same_unknowns(model) {
            true => self.system.clone(),
            false => Arc::new(self.on_moved_mesh(model)?),
        };
        let problem = problem(model, system.space().mesh(), state);
        let pressure = |region: &SupplyRegion| model.given_pressure(region);
        let is_given_so = |region: &SupplyRegion| pressure(region) == region.pressure;
        let system = match system.supply.regions().iter().all(is_given_so) {
            true => system,
            false => Arc::new(system.with_pressures(&pressure)?),
        };
        Some(Self { origin: self.origin.clone(), ..Self::made(model, state, problem, system) })
    }

    /// The system of this film on its mesh as it moves to the drawing of another model; `None` where it cannot.
    fn on_moved_mesh(&self, model: &Model) -> Option<FilmSystem> {
        if !self.model.has_same_kinds(model) || model.mesh.source.path().is_some() {
            return None;
        }
        let [from, to] = [&self.model, model].map(|model| model.mesh.outline.blueprint());
        let mesh = moved(self.system.space().mesh(), &from, &to)?;
        let (regions, radius) = (model.mesh.outline.regions(), model.mesh.bearing.radius);
        let disc_of = |region: &SupplyRegion| disc(radius, regions.iter().find(|feed| feed.name == region.name)?);
        Some(self.system.on_moved(Arc::new(mesh), &disc_of))
    }
}
