//! Why a search has found no balance, as far as that is known.

use std::f64::consts::{PI, TAU};

use oilwedge_reynolds::FilmSystem;

use crate::NoEquilibrium;
use crate::no_equilibrium::{AT_REST, SearchEnd};
use crate::search::{Nearest, Search, Trial};

/// A load that was not balanced and is less than this part of the reference force is below round-off.
const LOST: f64 = 1e-7;
/// A force within this factor of the load, at most, leaves open whether little is carried in contact.
const NEARLY: f64 = 2.0;
/// A force within this angle [rad] of the load leaves open whether little is carried in contact.
const ASTRAY: f64 = 0.5;

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
            // What the film carries in contact all around is known, unless a force like the load was found on the way.
            NoEquilibrium::Unreachable { why: SearchEnd::FarBelow, .. } if !self.found_alike() => reason,
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

    /// Whether a force was found that is as large as the load by [`NEARLY`] and points its way by [`ASTRAY`].
    fn found_alike(&self) -> bool {
        self.record().nearest.is_some_and(|Nearest { force: [x, y], .. }| {
            let [load_x, load_y] = self.load.force;
            let ratio = x.hypot(y) / load_x.hypot(load_y);
            let turn = (x * load_y - y * load_x).atan2(x * load_x + y * load_y);
            (1.0 / NEARLY..NEARLY).contains(&ratio) && turn.abs() < ASTRAY
        })
    }

    /// The reason with the nearest of all trials, where the search ended with this one.
    pub(crate) fn unreachable(&self, trial: &Trial, why: SearchEnd) -> NoEquilibrium {
        self.unreachable_from(
            Nearest { distance: self.distance(trial), force: trial.carried.force, journal: trial.film.problem.journal },
            why,
        )
    }

    /// As [`Self::unreachable`].
    pub(crate) fn unreachable_from(&self, last: Nearest, why: SearchEnd) -> NoEquilibrium {
        let degrees = |[x, y]: [f64; 2]| y.atan2(x).to_degrees().rem_euclid(360.0);
        let nearest = self.record().nearest.filter(|nearest| nearest.distance < last.distance);
        let nearest = nearest.unwrap_or(last);
        NoEquilibrium::Unreachable {
            asked: self.load.magnitude(),
            towards: degrees(self.load.force),
            nearest: nearest.force[0].hypot(nearest.force[1]),
            nearest_towards: degrees(nearest.force),
            eccentricity: nearest.journal.eccentricity() / self.gap.bearing().clearance,
            journal: Box::new(last.journal),
            why,
        }
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
