//! A few of the random shafts that the program `shafts` of these tests follows by the dozen.

use oilwedge_full::random_shafts::{bearing, fault, scene, solved};
use oilwedge_study::result::Status;

/// Two throws with a support that yields, which close; four throws, and one throw whose webs bend, which are squeezed
/// out.
const NUMBERS: [u64; 3] = [1, 13, 15];

/// Each closes or says why not, with films inside, balances kept, and no number lost.
#[test]
fn random_shafts_close_or_say_why_not() {
    let folder = tempfile::tempdir().expect("a folder");
    let bearing = bearing(folder.path());
    let mut closed = 0;
    for number in NUMBERS {
        let scene = scene(number, &bearing);
        let result = solved(&scene, f64::INFINITY);
        let fault = fault(&result);
        assert!(fault.is_none(), "{number}: {fault:?}\n{scene}");
        closed += usize::from(result.head.status == Status::Converged);
    }
    assert!(closed >= 1, "none of {NUMBERS:?} closes");
}
