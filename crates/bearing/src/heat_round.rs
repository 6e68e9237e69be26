//! One round of a thermal film: profiles by the temperatures, the film as a network, and the temperatures that balance
//! its heat.

use std::sync::Arc;

use oilwedge_fem::{Space, in_order};
use oilwedge_heat::{
    BushSide, FeedSupply, FilmCell, FilmNetwork, JournalSide, LayerProfile, LayerTemperatures, Layers, MOST_POINTS,
    NetworkFailure, NetworkOptions, OilProperties, SolvedNetwork, Thinning, TurbulentFlow, solve,
};
use oilwedge_reynolds::quantities::heat_network::{EddySources, NodeNetwork, heat_network};
use oilwedge_reynolds::{AcrossFilm, EddyFactors, SolvedFilm, ViscosityAcross};
use rayon::prelude::*;

/// Temperatures [K] whose difference shows how the viscosity falls.
const APART: f64 = 0.01;

/// What surrounds a film whose temperatures are found.
#[derive(Debug, Clone)]
pub struct HeatSurroundings {
    /// Heat capacity and conductivity of the oil.
    pub oil: OilProperties,
    /// Temperature of the oil that is fed [K].
    pub inlet: f64,
    /// The wall at rest.
    pub bush: BushSide,
    /// The wall that turns.
    pub journal: JournalSide,
    /// Change of the clearance with the temperatures of the walls; `None`: it does not change.
    pub expansion: Option<WallExpansion>,
}

/// Expansion of journal and bush by their mean temperatures.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct WallExpansion {
    /// Radius of the bore [m].
    pub radius: f64,
    /// Coefficient of the journal [1/K].
    pub journal: f64,
    /// Coefficient of the bush [1/K].
    pub bush: f64,
    /// Temperature at which the clearance is known [K].
    pub at: f64,
}

/// Temperatures at the points across the film of every dof [K], and how the oil answers to them.
pub(crate) struct LayeredFilm<'a> {
    /// The points.
    pub(crate) layers: &'a Layers,
    /// Temperatures, dof after dof.
    pub(crate) temperatures: Vec<f64>,
    /// Viscosity [Pa s] at a temperature [K].
    pub(crate) viscosity: &'a (dyn Fn(f64) -> f64 + Sync),
    /// Heat capacity and conductivity of the oil.
    pub(crate) oil: OilProperties,
    /// What makes the eddies of a turbulent film; none of a laminar one.
    pub(crate) eddies: Option<EddySources>,
}

/// Why a round has no temperatures.
#[derive(Debug, Clone, PartialEq)]
pub enum NoRound {
    /// The linear system was not solved.
    NotSolved(NetworkFailure),
    /// The film does not conserve oil.
    MakesOil,
    /// The control volumes do not fit in memory.
    TooLarge(oilwedge_fem::Error),
}

/// What a round has found.
pub(crate) struct RoundHeat {
    /// The film as it carries heat.
    pub(crate) network: FilmNetwork,
    /// Dof of each cell.
    pub(crate) dofs: Vec<usize>,
    /// Number of each feed among the regions of the supply.
    pub(crate) feeds: Vec<usize>,
    /// Profile of each cell.
    pub(crate) profiles: Vec<LayerProfile>,
    /// Temperatures of the profiles at the points of cell after cell [K].
    pub(crate) here: Vec<f64>,
    /// The temperatures that balance the heat.
    pub(crate) solved: SolvedNetwork,
}

impl LayeredFilm<'_> {
    /// Profiles of flow and friction at all dofs.
    pub(crate) fn profiles(&self) -> Vec<LayerProfile> {
        let points = self.layers.points.len();
        let profile = |(dof, at): (usize, &[f64])| {
            let mut viscosities = [0.0; MOST_POINTS];
            viscosities.iter_mut().zip(at).for_each(|(mu, &temperature)| *mu = (self.viscosity)(temperature));
            match &self.eddies {
                None => LayerProfile::of(self.layers, &viscosities[..points]),
                Some(EddySources { gaps, speed, density }) => {
                    let flow = TurbulentFlow { gap: gaps[dof], speed: *speed, density: *density, oil: self.oil };
                    LayerProfile::turbulent(self.layers, &viscosities[..points], &flow)
                }
            }
        };
        in_order(self.temperatures.par_chunks(points).enumerate().map(profile))
    }

    /// The viscosity across the film that these temperatures make.
    pub(crate) fn across(&self, space: &Space) -> Arc<ViscosityAcross> {
        self.across_by(space, &self.profiles())
    }

    /// The viscosity across the film with these profiles at all dofs.
    pub(crate) fn across_by(&self, space: &Space, profiles: &[LayerProfile]) -> Arc<ViscosityAcross> {
        let gap = |dof: usize| self.eddies.as_ref().map(|eddies| eddies.gaps[dof]);
        let nodes = profiles.iter().enumerate().map(|(dof, profile)| across_film(profile, gap(dof))).collect();
        Arc::new(ViscosityAcross::new(space, nodes))
    }

    /// The temperatures that balance the heat of a film, as a network, with the profiles at all dofs. Those of a round
    /// before are where the linear system begins; with `thins` friction falls as the oil warms.
    ///
    /// # Errors
    /// [`NoRound`]: the reason why there are none.
    pub(crate) fn round(
        &self,
        surroundings: &HeatSurroundings,
        (NodeNetwork { dofs, cells, links, ports, feeds, eddies: _ }, all): (NodeNetwork, &[LayerProfile]),
        before: Option<&LayerTemperatures>,
        (tolerance, thins): (f64, bool),
    ) -> Result<RoundHeat, NoRound> {
        let network = FilmNetwork {
            oil: surroundings.oil,
            cells,
            links,
            ports,
            feeds: vec![FeedSupply { temperature: surroundings.inlet }; feeds.len()],
            bush: surroundings.bush.clone(),
            journal: surroundings.journal,
        };
        let points = self.layers.points.len();
        let profiles: Vec<LayerProfile> = dofs.iter().map(|&dof| all[dof]).collect();
        let here: Vec<f64> =
            dofs.iter().flat_map(|dof| &self.temperatures[dof * points..][..points]).copied().collect();
        let fall = |&t: &f64| -((self.viscosity)(t + APART) / (self.viscosity)(t)).ln() / APART;
        let rates: Vec<f64> = if thins { here.iter().map(fall).collect() } else { Vec::new() };
        let thinning = thins.then_some(Thinning { temperatures: &here, rates: &rates });
        let options = NetworkOptions { tolerance, thinning, ..NetworkOptions::default() };
        let solved = solve(&network, self.layers, &profiles, before, &options).map_err(NoRound::NotSolved)?;
        Ok(RoundHeat { network, dofs, feeds, profiles, here, solved })
    }

    /// Sets the temperatures at the points of some dofs.
    pub(crate) fn set(&mut self, dofs: &[usize], temperatures: &[f64]) {
        let points = self.layers.points.len();
        for (at, &dof) in temperatures.chunks_exact(points).zip(dofs) {
            self.temperatures[dof * points..][..points].copy_from_slice(at);
        }
    }
}

/// What stands for the viscosity of a film with a profile.
fn across_film(profile: &LayerProfile, gap: Option<f64>) -> AcrossFilm {
    let eddies = profile.eddies.zip(gap);
    let [f0, f2] = eddies.map_or([profile.f0, profile.f2], |(scales, _)| [scales.laminar_f0, scales.laminar_f2]);
    AcrossFilm {
        viscosity: 1.0 / (12.0 * f2),
        shear_viscosity: 1.0 / f0,
        drag: profile.drag_share(),
        eddies: eddies.map(|(scales, gap)| EddyFactors {
            gap,
            conductance: scales.conductance,
            conductance_growth: scales.conductance_growth,
            shear: scales.shear,
            shear_growth: scales.shear_growth,
        }),
    }
}

impl HeatSurroundings {
    /// A film as a network between whose cells oil carries heat.
    ///
    /// # Errors
    /// [`NoRound`]: the film makes oil, or does not fit in memory.
    pub fn network(&self, film: &SolvedFilm) -> Result<NodeNetwork, NoRound> {
        heat_network(film, self.inlet).map_err(NoRound::TooLarge)?.ok_or(NoRound::MakesOil)
    }

    /// What the clearance grows by [m] at these temperatures of the walls: that of the bush is the mean over its bore.
    pub(crate) fn growth(&self, (layers, network): (&Layers, &FilmNetwork), found: &LayerTemperatures) -> f64 {
        let Some(WallExpansion { radius, journal, bush, at }) = self.expansion else {
            return 0.0;
        };
        let points = layers.points.len();
        let area: f64 = network.cells.iter().map(|cell| cell.wall_area).sum();
        let mean = |point: usize| {
            let of = |(cell, t): (&FilmCell, &[f64])| cell.wall_area * t[point];
            network.cells.iter().zip(found.layers.chunks_exact(points)).map(of).sum::<f64>() / area
        };
        let of_bush = match &network.bush {
            BushSide::Ring(ring) => ring.shape.ambient + found.bush[0],
            BushSide::Adiabatic | BushSide::Fixed(_) => mean(0),
        };
        let of_journal = found.journal.unwrap_or_else(|| mean(points - 1));
        radius * (bush * (of_bush - at) - journal * (of_journal - at))
    }
}
