//! Why a search has found no balance, as far as that is known.

use std::f64::consts::{PI, TAU};

use oilwedge_reynolds::FilmSystem;

use crate::NoEquilibrium;
use crate::no_equilibrium::{AT_REST, SearchEnd};
use crate::search::{Nearest, Search, Trial};

/// Loads below this part of the reference force are below the round-off of the film's force.
const LEAST_LOAD: f64 = 1e-10;
/// A load that was not balanced and is less than this part of the reference force is below round-off.
const LOST: f64 = 1e-7;

impl Search<'_> {
    /// The reason as far as it is known. A search that was ended, or found no better position, does not prove that
    /// there is none, unless the film carries nothing anywhere or the load points out of the shell; a load near
    /// round-off is reported as one.
    pub(crate) fn confirmed(&self, reason: NoEquilibrium) -> NoEquilibrium {
        let least = LOST * self.reference_force;
        match reason {
            NoEquilibrium::Unreachable { asked, .. } | NoEquilibrium::NotConverged { asked, .. } if asked < least => {
                NoEquilibrium::BelowRounding { asked, least }
            }
            NoEquilibrium::Unreachable { asked, nearest, journal, .. } if self.options.deadline.is_over() => {
                NoEquilibrium::Ended { asked, nearest, journal, history: std::mem::take(&mut self.record().tried) }
            }
            mut reason @ NoEquilibrium::Unreachable { .. } if self.points_out() => {
                if let NoEquilibrium::Unreachable { why, .. } = &mut reason {
                    *why = SearchEnd::OutOfShell;
                }
                reason
            }
            NoEquilibrium::Unreachable { asked, nearest, journal, .. } if nearest > AT_REST * asked => {
                let history = std::mem::take(&mut self.record().tried);
                NoEquilibrium::NotConverged {
                    asked,
                    residual: history.iter().copied().fold(f64::INFINITY, f64::min),
                    journal,
                    history,
                }
            }
            reason => reason,
        }
    }

    /// Whether a film that only pushes has no force towards the load, for that points out of the shell of an arc.
    fn points_out(&self) -> bool {
        /// Rounding of the ends of a half shell.
        const ROUNDING: f64 = 1e-9;
        let [x, y] = self.load.force;
        self.only_pushes && opening(self.system, self.gap.bearing().radius, y.atan2(x)) > PI - ROUNDING
    }

    /// The reason with the nearest of all trials, where the search ended with this one.
    pub(crate) fn unreachable(&self, trial: &Trial, why: SearchEnd) -> NoEquilibrium {
        let degrees = |[x, y]: [f64; 2]| y.atan2(x).to_degrees().rem_euclid(360.0);
        let (distance, journal) = (self.distance(trial), trial.film.problem.journal);
        let last = Nearest { distance, force: trial.carried.force, journal };
        let nearest = self.record().nearest.filter(|nearest| nearest.distance < distance).unwrap_or(last);
        NoEquilibrium::Unreachable {
            asked: self.load.magnitude(),
            towards: degrees(self.load.force),
            nearest: nearest.force[0].hypot(nearest.force[1]),
            nearest_towards: degrees(nearest.force),
            eccentricity: nearest.journal.eccentricity() / self.gap.bearing().clearance,
            journal: Box::new(journal),
            why,
        }
    }

    /// The reason if the load is below the round-off of the film's force.
    pub(crate) fn below_rounding(&self) -> Option<NoEquilibrium> {
        let asked = self.load.magnitude();
        let least = LEAST_LOAD * self.reference_force;
        (asked > 0.0 && asked < least).then_some(NoEquilibrium::BelowRounding { asked, least })
    }
}

/// Angle [rad] between the nodes of a film on both sides of a direction [rad]: more than pi where the shell of an arc
/// does not reach around it.
pub(crate) fn opening(system: &FilmSystem, radius: f64, direction: f64) -> f64 {
    let beyond = |[x, _]: [f64; 2]| (x / radius - direction).rem_euclid(TAU);
    let places = system.space().positions().into_iter().map(beyond);
    let [next, last] = places.fold([TAU, 0.0], |[next, last], beyond| [next.min(beyond), f64::max(last, beyond)]);
    next + TAU - last
}
