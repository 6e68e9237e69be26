//! A few of the random bearings with temperatures across their films that the program `thermal` of these tests solves
//! by the hundred: those that take a second.

use oilwedge_full::random_thermal::ThermalBearing;
use oilwedge_study::result::Status;
use oilwedge_tests::journal_bearings::each;

/// Rounds in which the temperatures of a film are found.
const FEW: usize = 12;

/// At positions and under loads, with grooves and holes, the temperatures are found in a few rounds; the heat of the
/// film is what leaves it, and no oil is colder than all that cools it.
#[test]
fn temperatures_of_random_bearings_are_found() {
    each(&[0, 6, 38, 40, 52, 59, 62, 68, 92, 96], |&number: &u64| {
        let outcome = ThermalBearing::new(number).solved(false);
        let (head, rounds) = (&outcome.result.head, outcome.result.counts.temperature_steps);
        match (head.status, &outcome.fault) {
            (Status::Converged, None) if rounds <= FEW => Ok(()),
            (status, fault) => Err(format!("{number}: {status:?} in {rounds} rounds, {:?} {fault:?}", head.reason)),
        }
    });
}
