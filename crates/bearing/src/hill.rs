//! The balance of the hill of a mass-conserving film ([`oilwedge_reynolds::sharp`]): from the balance of the film
//! itself, by its tangent.
//!
//! The two forces differ by a hundredth or less, and each step corrects the tangent. The first step, and each long one,
//! finds the cavities anew; the others keep them, so that the force depends smoothly on the position, as it does not
//! where nodes change sides. What it changes by if the cavities are found anew at the balanced position is a part of
//! its error bar.

use oilwedge_reynolds::SolvedFilm;
use oilwedge_reynolds::sharp::{HillStart, SharpFilm};
use oilwedge_reynolds::solve::Neighbour;

use crate::coordinates::{Vector, length, moved};
use crate::equilibrium::Equilibrium;
use crate::search::{Search, Trial};
use crate::search_options::SearchOptions;
use crate::{JournalLoad, Stiffness, WallByPlace};

/// The balance has been found when force and load differ by this part of the load.
const BALANCED: f64 = 1e-10;
/// Most positions tried.
const MOST_STEPS: usize = 12;
/// A step that is longer than this part of the least film thickness finds cavities anew.
const SHORT: f64 = 1e-2;

/// The position at which the hill carries the `load`, and the hill there, from that of the `film`, its `hill` and its
/// `tangent` dW/de [N/m]; none where a film nearby has no hill, or forces do not come to the load.
pub fn balance_hill(
    (film, hill): (&SolvedFilm, SharpFilm),
    load: JournalLoad,
    tangent: Stiffness,
    options: &SearchOptions,
) -> Option<(Equilibrium, SharpFilm)> {
    let search = Search::new(&film.problem, &film.system, load, *options);
    let carried = search.coordinates.forces(&hill.cubic.load.resultant());
    let [x, y] = load.force;
    let step = tangent.solve(moved([x, y, 0.0, 0.0], -1.0, carried));
    let (mut trial, mut hill) = search.hill_trial(film, step, HillStart::Near(hill))?;
    let change = moved(search.response(&trial), -1.0, carried);
    let mut stiffness = tangent.corrected(step, moved(change, -1.0, tangent.times(step)));
    let mut last = step;
    for steps in 1..MOST_STEPS {
        let residual = search.residual(&trial);
        if residual < BALANCED {
            let hill = trial.film.cavities_checked(hill).ok()?;
            let found = Equilibrium {
                residual,
                unbalanced: residual * search.scale,
                parts: search.parts(&trial),
                coordinates: search.coordinates,
                is_ended: false,
                stiffness: tangent,
                // Films in walls that give way have no hill.
                wall: WallByPlace::default(),
                warming: None,
                film: trial.film,
                cubic: None,
                work: search.record().work,
                steps,
            };
            return Some((found, hill));
        }
        if options.deadline.is_over() {
            return None;
        }
        let step = stiffness.solve(search.excess(&trial).map(|excess| -excess));
        let gap = search.gap.least(&trial.film.problem.journal);
        let start = match length(step) < SHORT * gap {
            true => HillStart::SameCavities(hill),
            false => HillStart::Near(hill),
        };
        let next;
        (next, hill) = search.hill_trial(&trial.film, step, start)?;
        if search.residual(&next) >= residual {
            return None;
        }
        let change = moved(search.response(&next), -1.0, search.response(&trial));
        let missed = moved(change, -1.0, stiffness.times(step));
        stiffness = stiffness.corrected_beside(last, step, missed);
        (trial, last) = (next, step);
    }
    None
}

impl Search<'_> {
    /// The trial by the force of the hill a `step` [m] from another one, and the hill; none where there is none.
    fn hill_trial(&self, from: &SolvedFilm, step: Vector, start: HillStart) -> Option<(Trial, SharpFilm)> {
        let place = moved(self.coordinates.at(&from.problem.journal), 1.0, step);
        let film = self.placed(&from.problem, place).solve_from(self.system, Neighbour::Start(from)).ok()?;
        let hill = film.sharp_film(start).ok()??;
        let trial = self.recorded(Trial::of(film, hill.cubic.load.resultant()));
        Some((trial, hill))
    }
}
