//! The temperatures of a film by another discretisation, which show what the one that is reported leaves open: with
//! more layers across the film, and on the vertices of the mesh alone.

use std::sync::Arc;

use oilwedge_fem::Space;
use oilwedge_heat::Layers;
use oilwedge_reynolds::ViscosityAcross;
use oilwedge_reynolds::quantities::heat_network::NodeNetwork;

use crate::film_heat::FilmHeat;
use crate::heat_round::{HeatSurroundings, LayeredFilm, NoRound, RoundHeat};

/// The temperatures of another discretisation of a film.
#[derive(Debug, Clone)]
pub struct HeatBeside {
    /// The temperatures, on the network of that film.
    pub heat: FilmHeat,
    /// The viscosity across the film that they make.
    pub across: Arc<ViscosityAcross>,
}

/// Rounds by which temperatures settle on a film that does not change.
const SETTLING: usize = 3;
/// Tolerance of their linear systems.
const SETTLED: f64 = 1e-9;

/// Tolerance of the linear system by which the heat of a film is balanced at last.
const BALANCED: f64 = 1e-12;

impl FilmHeat {
    /// The viscosity across the film that these temperatures make.
    pub fn viscosity_across(&self, space: &Space, viscosity: &(dyn Fn(f64) -> f64 + Sync)) -> Arc<ViscosityAcross> {
        self.layered(self.at_dofs.clone(), viscosity).across(space)
    }

    /// The film with these temperatures at the points of its dofs.
    fn layered<'a>(&'a self, temperatures: Vec<f64>, viscosity: &'a (dyn Fn(f64) -> f64 + Sync)) -> LayeredFilm<'a> {
        let (oil, eddies) = (self.network.oil, self.eddies.clone());
        LayeredFilm { layers: &self.layers, temperatures, viscosity, oil, eddies }
    }

    /// The temperatures that balance the heat of a film which differs a little from that of the last round.
    ///
    /// # Errors
    /// [`NoRound`]: the reason why there are none.
    pub fn balanced_on(
        self,
        surroundings: &HeatSurroundings,
        nodes: NodeNetwork,
        viscosity: &(dyn Fn(f64) -> f64 + Sync),
    ) -> Result<Self, NoRound> {
        let Self { layers, temperatures, growth, changes, at_dofs, .. } = self;
        let (oil, eddies) = (surroundings.oil, nodes.eddies.clone());
        let mut layered = LayeredFilm { layers: &layers, temperatures: at_dofs, viscosity, oil, eddies };
        let RoundHeat { network, dofs, feeds, profiles, solved, .. } =
            layered.round(surroundings, (nodes, &layered.profiles()), Some(&temperatures), (BALANCED, false))?;
        layered.set(&dofs, &solved.temperatures.layers);
        let (at_dofs, eddies) = (layered.temperatures, layered.eddies);
        let (temperatures, sheet) = (solved.temperatures, solved.sheet);
        Ok(Self { layers, network, dofs, profiles, eddies, at_dofs, feeds, temperatures, sheet, growth, changes })
    }

    /// The temperatures of a film at the points of other `layers`, near those found.
    ///
    /// # Errors
    /// [`NoRound`]: the reason why there are none.
    pub fn with_layers(
        &self,
        surroundings: &HeatSurroundings,
        (space, nodes): (&Space, NodeNetwork),
        layers: &Layers,
        viscosity: &(dyn Fn(f64) -> f64 + Sync),
    ) -> Result<HeatBeside, NoRound> {
        let at = |at: &[f64]| layers.points.iter().map(|&eta| self.layers.at(at, eta)).collect::<Vec<f64>>();
        let temperatures = self.at_dofs.chunks_exact(self.layers.points.len()).flat_map(at).collect();
        let layered = LayeredFilm { layers, eddies: nodes.eddies.clone(), ..self.layered(temperatures, viscosity) };
        self.settled(surroundings, (space, nodes), layered)
    }

    /// The temperatures of a film on the vertices of the mesh alone, which is a network there, near those found.
    ///
    /// # Errors
    /// [`NoRound`]: the reason why there are none.
    pub fn on_vertices(
        &self,
        surroundings: &HeatSurroundings,
        (fine, space): (&Space, &Space),
        nodes: NodeNetwork,
        viscosity: &(dyn Fn(f64) -> f64 + Sync),
    ) -> Result<HeatBeside, NoRound> {
        let points = self.layers.points.len();
        let mut temperatures = vec![0.0; space.dofs() * points];
        for vertex in 0..fine.mesh().points().len() as u32 {
            let (from, to) = (fine.vertex_dof(vertex) * points, space.vertex_dof(vertex) * points);
            temperatures[to..to + points].copy_from_slice(&self.at_dofs[from..from + points]);
        }
        let layered = LayeredFilm { eddies: nodes.eddies.clone(), ..self.layered(temperatures, viscosity) };
        self.settled(surroundings, (space, nodes), layered)
    }

    fn settled(
        &self,
        surroundings: &HeatSurroundings,
        (space, nodes): (&Space, NodeNetwork),
        mut layered: LayeredFilm<'_>,
    ) -> Result<HeatBeside, NoRound> {
        let mut found = layered.round(surroundings, (nodes.clone(), &layered.profiles()), None, (SETTLED, true))?;
        for _ in 1..SETTLING {
            layered.set(&found.dofs, &found.solved.temperatures.layers);
            let film = (nodes.clone(), &layered.profiles()[..]);
            found = layered.round(surroundings, film, Some(&found.solved.temperatures), (SETTLED, true))?;
        }
        layered.set(&found.dofs, &found.solved.temperatures.layers);
        let across = layered.across(space);
        let RoundHeat { network, dofs, feeds, profiles, solved, .. } = found;
        let heat = Self {
            layers: layered.layers.clone(),
            network,
            dofs,
            profiles,
            eddies: layered.eddies,
            at_dofs: layered.temperatures,
            feeds,
            temperatures: solved.temperatures,
            sheet: solved.sheet,
            growth: self.growth,
            changes: Vec::new(),
        };
        Ok(HeatBeside { heat, across })
    }

    /// The viscosity across the film of these temperatures less what those on the vertices alone differ by: what a
    /// finer mesh is expected to give, to first order.
    pub fn extrapolated(
        &self,
        fine: &Space,
        on_vertices: &Self,
        viscosity: &(dyn Fn(f64) -> f64 + Sync),
    ) -> Arc<ViscosityAcross> {
        let points = self.layers.points.len();
        let mut off = vec![f64::NAN; self.at_dofs.len()];
        for vertex in 0..fine.mesh().points().len() as u32 {
            // A space of linear elements has one dof a vertex.
            let (to, from) = (fine.vertex_dof(vertex) * points, vertex as usize * points);
            (0..points).for_each(|k| off[to + k] = on_vertices.at_dofs[from + k] - self.at_dofs[to + k]);
        }
        for t in 0..fine.mesh().triangles().len() {
            let dofs = fine.element_dofs(t);
            for (middle, [a, b]) in [[0, 1], [1, 2], [2, 0]].into_iter().enumerate() {
                let [a, b, to] = [dofs[a], dofs[b], dofs[3 + middle]].map(|dof| dof * points);
                (0..points).for_each(|k| off[to + k] = 0.5 * (off[a + k] + off[b + k]));
            }
        }
        let temperatures = self.at_dofs.iter().zip(&off).map(|(t, off)| t - off).collect();
        self.layered(temperatures, viscosity).across(fine)
    }
}
