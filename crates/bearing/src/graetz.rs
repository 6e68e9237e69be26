//! # Graetz number: which of conduction and transport rules the temperature across a film
//!
//! **Equation.** `Gz = rho c u h^2/(k l)`: heat that is carried along a way l over that which is conducted across the
//! film. Around the bearing `u = U, l = R`; over the land beside a feed of the pressure p_f `u = h^2 (p_f - p_e)/(12 mu
//! l)`, l the distance of the feed from the nearer end.
//!
//! | symbol | unit | code |
//! |---|---|---|
//! | Gz | 1 | [`graetz_number`] |
//! | rho c, k | J/(m3 K), W/(m K) | `oil` |
//!
//! **Source.** Graetz, Ann. Phys. 254 (1882) 79. **Range.** A polynomial of degree N across the film follows Gz up to
//! some N^4: beyond, temperatures at the walls go wild (`docs/theory/thermal_film.md`). **Verified by**
//! `tests/tests/thermal_film.rs`.

use oilwedge_heat::{OilProperties, PortKind};
use oilwedge_reynolds::SolvedFilm;
use oilwedge_reynolds::quantities::heat_network::NodeNetwork;

/// Share of the area whose film is thicker: pockets are no land.
const THICKER: f64 = 0.1;
/// A land is at least this part of the length of the bearing wide: a feed that reaches the end has none.
const LEAST_LAND: f64 = 1e-2;

/// The greatest Graetz number of a film, around it and over the lands beside its feeds.
pub fn graetz_number(film: &SolvedFilm, network: &NodeNetwork, oil: &OilProperties) -> f64 {
    let (bearing, per) = (&film.problem.bearing, oil.capacity / oil.conductivity);
    let [speed, _] = film.problem.surface_velocity();
    let thickness = thick_film(network);
    let around = per * speed.abs() * thickness * thickness / bearing.radius;
    let land = |(feed, &region): (usize, &usize)| {
        let pressure = film.system.supply.regions()[region].pressure - bearing.end_pressure;
        let at = |along: f64| (0.5 - along.abs()).max(LEAST_LAND) * bearing.length;
        let ports = network.ports.iter().filter(|port| port.kind == PortKind::Feed(feed));
        let cells: Vec<_> = ports.map(|port| &network.cells[port.cell]).collect();
        let way = cells.iter().map(|cell| at(cell.along)).fold(f64::INFINITY, f64::min);
        let gap = cells.iter().map(|cell| cell.thickness).sum::<f64>() / cells.len().max(1) as f64;
        let velocity = gap * gap * pressure.abs() / (12.0 * film.problem.lubricant.viscosity * way);
        per * velocity * gap * gap / way
    };
    network.feeds.iter().enumerate().map(land).fold(around, f64::max)
}

/// The thickness [m] that the film exceeds in a tenth of its area.
fn thick_film(network: &NodeNetwork) -> f64 {
    let mut cells: Vec<[f64; 2]> = network.cells.iter().map(|cell| [cell.thickness, cell.wall_area]).collect();
    cells.sort_by(|a, b| b[0].total_cmp(&a[0]));
    let all: f64 = cells.iter().map(|[_, area]| area).sum();
    let mut passed = 0.0;
    for [thickness, area] in &cells {
        passed += area;
        if passed >= THICKER * all {
            return *thickness;
        }
    }
    0.0
}
