//! The second, independent answer: scikit-fem solves the same meshes, pyvista reads our fields, Python uses the
//! package.
//!
//! Left out, and named, on machines without Python's venv or the libraries of gmsh and VTK.

use oilwedge_tests::left_out::{is_left_out, missing_for_python};
use oilwedge_tests::python_environment::{Tier, crosscheck};

#[test]
fn scikit_fem_and_pyvista_agree() {
    if !is_left_out("cross-check by scikit-fem, gmsh and pyvista", &missing_for_python()) {
        crosscheck(Tier::Quick);
    }
}
