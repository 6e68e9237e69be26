//! A system for another operating point: given pressures and film thickness change; mesh, numbering and analysis stay.

use std::sync::Arc;

use crate::FilmSystem;
use crate::film_thickness::FilmContribution;
use crate::supply::SupplyRegion;

impl FilmSystem {
    /// Gives each region the pressure [Pa] that `pressure` has for it, and coarser meshes their part of `film_thickness`: the
    /// system is then the one that would be made anew. False, and nothing changes, where feeds that touch would get different pressures.
    pub fn renew(
        &mut self,
        pressure: &dyn Fn(&SupplyRegion) -> f64,
        film_thickness: &[Arc<dyn FilmContribution>],
    ) -> bool {
        if !self.supply.fits(self.space(), pressure) {
            return false;
        }
        self.supply.set_pressures(pressure);
        if let Some(cubic) = self.cubic.get_mut() {
            cubic.system.supply.set_pressures(pressure);
        }
        if let Some(vertices) = self.vertices.get_mut() {
            vertices.supply.set_pressures(pressure);
        }
        if let Some(coarser) = &mut self.coarser {
            let own: Vec<_> =
                (film_thickness.iter()).map(|contribution| contribution.carried(&coarser.parents)).collect();
            coarser.system.renew(pressure, &own);
            coarser.film_thickness = own;
        }
        true
    }
}
