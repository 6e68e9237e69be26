//! The longer part of the cross-check in Python: Dask with kills, the notebook, the code of the pages.

use oilwedge_tests::left_out::{is_left_out, missing_for_python};
use oilwedge_tests::python_environment::{Tier, crosscheck};

#[test]
fn the_long_tests_in_python_pass() {
    if !is_left_out("long tests in Python", &missing_for_python()) {
        crosscheck(Tier::Full);
    }
}
