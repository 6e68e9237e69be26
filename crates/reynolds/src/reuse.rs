//! A system for another operating point: given pressures and film thickness change; mesh, numbering and analysis stay.

use std::sync::{Arc, Mutex, OnceLock};

use oilwedge_fem::Assembler;
use oilwedge_mesh::Mesh;

use crate::FilmSystem;
use crate::film_thickness::FilmContribution;
use crate::supply::{Disc, SupplyRegion};

impl FilmSystem {
    /// This system with other given pressures [Pa], for films that are not searched: it has no coarser meshes. `None`
    /// where feeds that touch would get different pressures.
    pub fn with_pressures(&self, pressure: &dyn Fn(&SupplyRegion) -> f64) -> Option<Self> {
        let mut supply = self.supply.clone();
        supply.fits(self.space(), pressure).then(|| supply.set_pressures(pressure))?;
        Some(Self {
            supply,
            between: self.between.clone(),
            volumes: self.volumes.clone(),
            ..self.of_same_unknowns(self.assembler.clone())
        })
    }

    /// This system on a mesh whose vertices lie elsewhere, with the triangles of this one, for films that are not
    /// searched; `disc` is the exact shape of each region there.
    pub fn on_moved(&self, mesh: Arc<Mesh>, disc: &dyn Fn(&SupplyRegion) -> Option<Disc>) -> Self {
        let mut system = self.of_same_unknowns(Arc::new(self.assembler.on_moved(mesh)));
        system.supply.set_discs(disc);
        system
    }

    /// A system of these unknowns and given pressures by another assembler.
    fn of_same_unknowns(&self, assembler: Arc<Assembler>) -> Self {
        Self {
            assembler,
            supply: self.supply.clone(),
            coarser: None,
            analysis: self.analysis.clone(),
            worth_multigrid: self.worth_multigrid,
            between: OnceLock::new(),
            volumes: OnceLock::new(),
            unsymmetric: self.unsymmetric.clone(),
            pressing: Mutex::default(),
            cubic: OnceLock::new(),
            vertices: OnceLock::new(),
        }
    }

    /// Gives each region the pressure [Pa] that `pressure` has for it, and coarser meshes their part of
    /// `film_thickness`: the system is then the one that would be made anew. False, and nothing changes, where feeds
    /// that touch would get different pressures, or a film of a coarser mesh still lives.
    pub fn renew(
        &mut self,
        pressure: &dyn Fn(&SupplyRegion) -> f64,
        film_thickness: &[Arc<dyn FilmContribution>],
    ) -> bool {
        if !self.supply.fits(self.space(), pressure) {
            return false;
        }
        if let Some(coarser) = &mut self.coarser {
            let Some(system) = Arc::get_mut(&mut coarser.system) else { return false };
            let own: Vec<_> =
                (film_thickness.iter()).map(|contribution| contribution.carried(&coarser.parents)).collect();
            system.renew(pressure, &own);
            coarser.film_thickness = own;
        }
        self.supply.set_pressures(pressure);
        let more = [self.cubic.get_mut().map(|cubic| &mut cubic.system), self.vertices.get_mut()];
        match more.into_iter().flatten().map(Arc::get_mut).collect::<Option<Vec<_>>>() {
            Some(systems) => systems.into_iter().for_each(|system| system.supply.set_pressures(pressure)),
            // Films that still live keep theirs; they are made anew.
            None => (self.cubic, self.vertices) = Default::default(),
        }
        true
    }
}
