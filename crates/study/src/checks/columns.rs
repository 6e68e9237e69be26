//! Columns that the table of a sweep may have.

use oilwedge_scene::sweep::{Plan, WantedColumn};
use oilwedge_scene::{Complaint, Complaints, Scene, SceneError};

use crate::column::{Column, Fault};
use crate::scope::Scope;

pub(super) fn check(scene: &Scene, complaints: &mut Complaints) {
    for (key, _, (message, help)) in scene.sweep.iter().flat_map(|plan| faults(plan, std::slice::from_ref(scene))) {
        complaints.add(&key, message, help);
    }
    if let Some(design) = &scene.design
        && let Err((message, help)) = Column::wanted(&design.objective, &Scope::of(scene))
    {
        complaints.add(&format!("design.{}", design.sense.name()), message, help);
    }
}

/// Checks the columns of a sweep of crankshafts by the scenes of their bearings.
///
/// # Errors
/// [`SceneError::Complaints`]: a column is a quantity of none of them.
pub fn check_columns(plan: &Plan, bearings: &[Scene]) -> Result<(), SceneError> {
    let complaint = |(key, wanted, (message, help)): (String, &WantedColumn, Fault)| Complaint {
        key,
        value: plan.text[wanted.span.clone()].to_owned(),
        message,
        help,
        span: Some(wanted.span.clone()),
    };
    match faults(plan, bearings).map(complaint).collect::<Vec<_>>() {
        none if none.is_empty() => Ok(()),
        complaints => Err(SceneError::Complaints { path: plan.path.clone(), text: plan.text.clone(), complaints }),
    }
}

/// Key, column and fault of those columns that no scene has.
fn faults<'a>(plan: &'a Plan, scenes: &'a [Scene]) -> impl Iterator<Item = (String, &'a WantedColumn, Fault)> {
    let columns = plan.columns.iter().flatten().enumerate();
    columns.filter_map(|(index, wanted)| {
        let fault = Column::wanted_in(scenes, wanted)?.err()?;
        Some((format!("sweep.columns[{index}]"), wanted, fault))
    })
}
