//! Fields carried to a refined mesh.
//!
//! A child triangle is a piece of its parent in the parent's reference coordinates. The polynomial of
//! the parent, taken there at the nodes of the child, is the same polynomial: the spaces are nested
//! and nothing is lost, as long as the degree does not fall. Where edges are curved the spaces are
//! nested in reference coordinates, and the function moves with the geometry.
//! Verified by `tests/tests/refinement.rs`.

use oilwedge_mesh::refine::Child;

use crate::field::evaluate;
use crate::{Field, Space, lagrange};

/// Nodal values on `fine` of the field `coarse`; `lineage` gives where in the mesh of `coarse` each triangle
/// of `fine` lies ([`oilwedge_mesh::Refined`]). The degrees may differ; a lower one interpolates.
pub fn transfer(coarse: &Field, fine: &Space, lineage: &[Child]) -> Vec<f64> {
    let nodes: Vec<[f64; 3]> = lagrange::nodes(fine.degree()).into_iter().map(lagrange::barycentric).collect();
    let mut values = vec![0.0; fine.dofs()];
    for (t, child) in lineage.iter().enumerate() {
        let nodal = coarse.element_values(child.parent as usize);
        for (&dof, weights) in fine.element_dofs(t).iter().zip(&nodes) {
            let point = [0, 1].map(|d| (0..3).map(|k| weights[k] * child.corners[k][d]).sum());
            values[dof] = evaluate(coarse.space.degree(), &nodal, point);
        }
    }
    values
}
