//! The ways out: what a user can change in a scene or on the command line where there is no film, no position, or no supply.
//!
//! Physics errors carry data and name no key; the sentence that follows them is found here.

use oilwedge_bearing::NoEquilibrium;
use oilwedge_fem::newton::Failure;
use oilwedge_reynolds::NoFilm;
use oilwedge_reynolds::supply::SupplyError;

use crate::analysis::NoAnswer;

/// What a user can do about a missing answer; none where nothing is known to help, or the reason says it itself.
pub fn way_out(reason: &NoAnswer) -> Option<&'static str> {
    let film = match reason {
        NoAnswer::Film(film) | NoAnswer::Equilibrium(NoEquilibrium::Film(film)) => film,
        NoAnswer::Equilibrium(reason) => return of_position(reason),
        NoAnswer::Heat(_) => return None,
    };
    Some(match film {
        NoFilm::AboveLimit { .. } => {
            "lower speed, eccentricity or viscosity, or use a law that grows slower (Roelands)"
        }
        NoFilm::NearLimit { .. } => "give a finer mesh ([mesh] size or tolerance), or another speed",
        NoFilm::AtFold { .. } => {
            "give a finer mesh ([mesh] size or tolerance), another speed, or form = \"conservative\""
        }
        NoFilm::BelowFloor { .. } => "add [cavitation]",
        NoFilm::Fold { .. } => "lower speed or eccentricity, or use form = \"conservative\"",
        NoFilm::NoSupply { .. } => "add a [[feed]], a film_start, or ends above cavitation.pressure",
        NoFilm::FilmFraction { .. } => {
            "use another mesh, without obtuse angles and finer where the film is thin ([mesh] size draws one)"
        }
        NoFilm::NotConverged(Failure::Cycling { .. }) => "another mesh ([mesh] size) may help",
        _ => return None,
    })
}

fn of_position(reason: &NoEquilibrium) -> Option<&'static str> {
    match reason {
        NoEquilibrium::Unreachable { .. } => Some("change the load, its angle, or the pressure and place of feeds"),
        NoEquilibrium::BeyondCapacity { .. } => Some("lower the load, or raise speed, viscosity or size"),
        NoEquilibrium::BelowRounding { .. } => Some("give no load (0 N), or a larger one"),
        NoEquilibrium::NotConverged { .. } => {
            Some("give another mesh ([mesh] size), or solve at a given position to see the film")
        }
        NoEquilibrium::Ended { .. } => Some("give it more time (--max-seconds)"),
        _ => None,
    }
}

/// What a user can do about regions of given pressure that do not fit the mesh.
pub fn way_out_of_supply(fault: &SupplyError) -> &'static str {
    match fault {
        SupplyError::Unassigned { .. } => {
            "put them in end_low, end_high, arc_from, arc_to or in the group of a [[feed]]"
        }
        SupplyError::Conflict { .. } => "separate them or give them one pressure",
        SupplyError::OpenRim { .. } => "complete the group, or mesh the region as a surface",
        SupplyError::NoLine { .. } => "mesh the liner with its seam there",
        _ => "correct the groups of the mesh",
    }
}
