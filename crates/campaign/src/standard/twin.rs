//! The bearing of a scene by the standard, at one viscosity and at the temperature of its own balance of heat.

use oilwedge_bearing::ThermalFlows;
use oilwedge_bearing::thermal_balance::find;
use oilwedge_reynolds::analytical::iso7902;
pub(super) use oilwedge_reynolds::analytical::iso7902::StandardFeed;
use oilwedge_reynolds::lubricant::density::ZERO_CELSIUS;
use oilwedge_scene::{Mixing, Scene};
use oilwedge_study::effects::Sockets;
use oilwedge_study::oil::Oil;
use oilwedge_study::oil::first_temperature;
use oilwedge_study::quantities::{
    ECCENTRICITY, FILM_THICKNESS_MIN, FRICTION_POWER, LOAD, Quantity, SIDE_FLOW, TEMPERATURE_EFFECTIVE,
    TEMPERATURE_OUTLET, VISCOSITY_EFFECTIVE,
};

/// The name of the standard.
pub(super) const NAME: &str = "ISO 7902 (DIN 31652)";

/// Part of the friction to which its heat is balanced.
const BALANCED: f64 = 1e-12;

/// What the standard and the film are both given.
#[derive(Debug, Clone, Copy)]
pub(super) enum Given {
    /// The load [N].
    Load(f64),
    /// The eccentricity [1].
    Eccentricity(f64),
}

impl Given {
    pub(super) fn name(self) -> &'static str {
        match self {
            Self::Load(_) => LOAD.name,
            Self::Eccentricity(_) => ECCENTRICITY.name,
        }
    }
}

/// Bearings side by side that the standard makes of the liner, and their common length over the diameter.
pub(super) struct Lands {
    pub(super) count: f64,
    pub(super) slenderness: f64,
}

impl Lands {
    fn of(scene: &Scene) -> Self {
        let bearing = &scene.bearing;
        let around = scene.feeds.iter().filter(|feed| feed.pressure.is_some());
        let around = around.filter_map(|feed| feed.groove).find(|groove| groove.arc.is_none());
        match around {
            Some(groove) => Self { count: 2.0, slenderness: 0.5 * (bearing.length - groove.width) / bearing.diameter },
            None => Self { count: 1.0, slenderness: bearing.length / bearing.diameter },
        }
    }
}

/// The feed in the terms of the standard and its pressure [Pa], or why it has none like that.
pub(super) type Fed = Result<Option<(StandardFeed, f64)>, String>;

/// The bearing by the standard.
pub(super) struct Twin {
    pub(super) lands: Lands,
    /// Sommerfeld number of the bearing [1].
    pub(super) number: f64,
    /// Eccentricity of the bearing [1].
    pub(super) eccentricity: f64,
    /// Load on the bearing [N].
    pub(super) load: f64,
    /// Coefficient of friction of the bearing [1].
    pub(super) coefficient: f64,
    /// The power [W] of that friction.
    pub(super) power: f64,
    /// Q_3 [m3/s].
    pub(super) by_film: f64,
    /// Q_p [m3/s], where there is a feed.
    pub(super) by_feed: Option<f64>,
    /// Sum of Q_3 and Q_p [m3/s]; none where the standard has no such feed.
    pub(super) flow: Option<f64>,
}

impl Twin {
    /// The bearing with oil of `viscosity` [Pa.s]; none without load.
    pub(super) fn of(scene: &Scene, viscosity: f64, given: Given, feed: &Fed) -> Option<Self> {
        let bearing = &scene.bearing;
        let psi = bearing.clearance / bearing.radius();
        let speed = scene.journal.speed.abs();
        let lands = Lands::of(scene);
        let per_number = lands.count * bearing.diameter.powi(2) * lands.slenderness * viscosity * speed / psi.powi(2);
        let eccentricity = match given {
            Given::Load(load) => iso7902::eccentricity(load / per_number, lands.slenderness)?,
            Given::Eccentricity(eccentricity) => eccentricity,
        };
        if eccentricity <= 0.0 {
            return None;
        }
        let number = iso7902::sommerfeld_number(eccentricity, lands.slenderness);
        let load = number * per_number;
        let coefficient = psi * iso7902::friction(number, eccentricity, lands.slenderness);
        let side = iso7902::side_flow_number(eccentricity, lands.slenderness);
        let by_film = lands.count * bearing.diameter.powi(3) * psi * speed * side;
        let through = |(kind, pressure): &(StandardFeed, f64)| {
            let unit = (bearing.diameter * psi).powi(3) * pressure / viscosity;
            unit * iso7902::feed_flow_number(*kind, eccentricity, bearing.length / bearing.diameter)
        };
        let by_feed = (feed.as_ref().ok()).and_then(|feed| feed.as_ref()).map(through);
        Some(Self {
            number,
            eccentricity,
            load,
            coefficient,
            power: coefficient * load * speed * bearing.radius(),
            by_film,
            by_feed,
            flow: feed.is_ok().then(|| by_film + by_feed.unwrap_or(0.0)),
            lands,
        })
    }

    /// Attitude angle of the journal [rad].
    pub(super) fn attitude(&self) -> f64 {
        iso7902::attitude(self.eccentricity, self.lands.slenderness)
    }

    /// Least film thickness of the bearing [m].
    pub(super) fn least_film(&self, scene: &Scene) -> f64 {
        scene.bearing.clearance * (1.0 - self.eccentricity)
    }
}

/// The standard's own balance of heat, friction by its fits carried off by its flows: temperatures of film and outlet,
/// viscosity and the bearing there. Empty without `[heat]`, and where it has no flow through the feed or no balance.
pub(super) fn own_balance(scene: &Scene, given: Given, feed: &Fed) -> Vec<Quantity> {
    balanced(scene, given, feed).unwrap_or_default()
}

fn balanced(scene: &Scene, given: Given, feed: &Fed) -> Option<Vec<Quantity>> {
    let model = Sockets::of(scene).thermal?;
    // The oil carried round, of which a share mixes, is none of its numbers.
    let carried_over = match model.mixing {
        None => 0.0,
        Some(Mixing::Ratio(ratio)) => ratio,
        Some(Mixing::Share(_)) => return None,
    };
    let oil = Oil::of(scene);
    let at = |temperature: f64| {
        let viscosity = oil.at(temperature).viscosity;
        Twin::of(scene, viscosity, given, feed).map(|twin| (twin, viscosity))
    };
    let film = |temperature: f64| {
        let (twin, _) = at(temperature).ok_or(())?;
        Ok::<_, ()>(ThermalFlows { power: twin.power, flow: twin.flow.ok_or(())?, carried_over })
    };
    let balance = model.balance;
    let found = find(&balance, first_temperature(balance.inlet), BALANCED, film).ok()?;
    let (twin, viscosity) = at(found.temperature)?;
    let [_, outlet] = balance.ends(found.temperature, carried_over);
    Some(vec![
        Quantity::new(&TEMPERATURE_EFFECTIVE, found.temperature - ZERO_CELSIUS),
        Quantity::new(&TEMPERATURE_OUTLET, outlet - ZERO_CELSIUS),
        Quantity::new(&VISCOSITY_EFFECTIVE, viscosity),
        Quantity::new(&ECCENTRICITY, twin.eccentricity),
        Quantity::new(&FILM_THICKNESS_MIN, twin.least_film(scene)),
        Quantity::new(&FRICTION_POWER, twin.power),
        Quantity::new(&SIDE_FLOW, twin.flow?),
    ])
}
