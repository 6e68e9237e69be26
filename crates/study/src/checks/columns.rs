//! Which columns the table of a sweep may have.

use oilwedge_scene::{Complaints, Scene};

use crate::column::Column;

pub(super) fn check(scene: &Scene, complaints: &mut Complaints) {
    let columns = scene.sweep.iter().flat_map(|plan| plan.columns.iter().flatten());
    for (index, wanted) in columns.enumerate() {
        if let Err((message, help)) = Column::wanted(wanted, scene) {
            complaints.add(&format!("sweep.columns[{index}]"), message, help);
        }
    }
}
