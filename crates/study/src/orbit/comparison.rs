//! Error bars of an orbit whose film conserves its oil: by two more orbits on the vertices of the mesh alone.
//!
//! What such a film is off by is handed on from one time to the next with its oil, so that no single film shows it. An
//! orbit on the vertices has edges of twice the length; the scheme is of first order in space at least, so that a
//! number is off by no more than it differs between both, to leading order. One more orbit there with a wider tolerance
//! shows what the steps in time do.
//!
//! ```text
//! mesh: |J - J_vertices|        time: |J_vertices(tolerance) - J_vertices(4 tolerance)|
//! ```

use oilwedge_bearing::coordinates::Vector;
use oilwedge_bearing::orbit::{Motion, OrbitEnd, OrbitOptions};
use oilwedge_reynolds::error_bar::Bar;

use super::measured;
use crate::film::Film;
use crate::quantities::Quantity;
use crate::run_options::RunOptions;

/// Tolerance of the last orbit, over that of the others.
const WIDER: f64 = 4.0;

/// Gives the numbers of an orbit their bars; none where an orbit of the comparison does not come to its end. Whether
/// the deadline has ended one.
pub(super) fn compare(
    motion: &Motion,
    (film, model): (&Film, &oilwedge_scene::OrbitTable),
    (begin, orbit): (Vector, OrbitOptions),
    options: &RunOptions,
    quantities: &mut [Quantity],
) -> bool {
    let film = film.on_vertices();
    let motion = Motion { problem: &film.problem, system: &film.system, gap: film.gap(), ..*motion };
    let numbers_alone = RunOptions { bars: false, frames: 0, observer: None, ..*options };
    let [alike, wider] = compared(&orbit, |options| {
        let orbit = motion.orbit(begin, options).ok().filter(|orbit| orbit.end != OrbitEnd::Ended)?;
        Some(measured(&film, &motion, model, orbit, &numbers_alone).ok()?.quantities)
    });
    let both = alike.as_deref().zip(wider.as_deref());
    judge(both, quantities);
    both.is_none() && orbit.deadline.is_over()
}

/// Numbers on the vertices alone by a tolerance and by a wider one.
pub(crate) fn compared<T: Send>(
    orbit: &OrbitOptions,
    numbers: impl Fn(&OrbitOptions) -> Option<T> + Sync,
) -> [Option<T>; 2] {
    let with = |tolerance: f64| numbers(&OrbitOptions { tolerance, observer: None, ..*orbit });
    let (alike, wider) = rayon::join(|| with(orbit.tolerance), || with(WIDER * orbit.tolerance));
    [alike, wider]
}

/// Gives numbers their bars by those on the vertices alone, with the same tolerance and with a wider one; none where
/// these are not known.
pub(crate) fn judge(both: Option<(&[Quantity], &[Quantity])>, quantities: &mut [Quantity]) {
    let (alike, wider) = both.unwrap_or_default();
    let find = |list: &[Quantity], name: &str| list.iter().find(|it| it.name == name).map(|it| it.value);
    for quantity in quantities {
        let there = find(alike, &quantity.name).zip(find(wider, &quantity.name));
        quantity.set_bar(there.map(|(alike, wider)| Bar {
            discretisation: quantity.row.difference(quantity.value, alike).abs(),
            time: quantity.row.difference(alike, wider).abs(),
            ..Bar::default()
        }));
    }
}
