//! A few of the random tilted bearings that the program `tilted` of these tests solves by the hundred: those that take milliseconds.

use oilwedge_study::result::Status;
use oilwedge_tests::journal_bearings::each;
use oilwedge_tests::random_tilted::{TiltedBearing, solved};

/// Given, held and free tilts with holes and grooves: each converges, and force and moment balance to 1e-10.
#[test]
fn random_tilted_bearings_converge() {
    each(&[7, 27, 28, 30, 32, 33], |&number: &u64| {
        let (result, fault) = solved(&TiltedBearing::new(number));
        match (result.status, fault) {
            (Status::Converged, None) => Ok(()),
            (status, fault) => Err(format!("{number}: {status:?} {:?} {fault:?}", result.reason)),
        }
    });
}
