//! Oil that goes round in a cavity which no full film, feed or inlet sends oil into.
//!
//! Along a row of nodes that is in the cavity all around the bearing transport alone does not say how much oil there
//! is: its balances have no unique solution. A leak too small to matter anywhere else does. Without a source the row is
//! empty then; where pressure presses oil into it the film fraction is far above one, and the row becomes full
//! somewhere, which is a source. In a film whose signs are all right nothing leaks.

use oilwedge_fem::Matrix;

/// Part of what leaves a node that leaks from it.
pub(super) const LEAK: f64 = 1e-8;
/// Part of what leaves a node below which a coupling is rounding.
const ROUNDING: f64 = 1e-9;

/// Nodes of the cavity that no oil is carried to from outside of it; `transport` says what each node (row) receives
/// from which (column).
pub(super) fn without_source(transport: &Matrix, cavity: &[bool], inflow: &[f64]) -> Vec<usize> {
    let pattern = &transport.pattern;
    let is_sent = |from: usize, to: usize| {
        let row = pattern.row(to);
        let place = pattern.columns[row.clone()].binary_search(&(from as u32));
        place.is_ok_and(|place| transport.values[row.start + place].abs() > ROUNDING * transport.diagonal(to).abs())
    };
    let mut reached: Vec<bool> = (0..cavity.len()).map(|dof| !cavity[dof] || inflow[dof] > 0.0).collect();
    let mut next: Vec<usize> = (0..cavity.len()).filter(|&dof| reached[dof]).collect();
    while let Some(from) = next.pop() {
        for k in pattern.row(from) {
            let to = pattern.columns[k] as usize;
            if !reached[to] && is_sent(from, to) {
                reached[to] = true;
                next.push(to);
            }
        }
    }
    let leaks = |&dof: &usize| !reached[dof] && transport.diagonal(dof) > 0.0;
    (0..cavity.len()).filter(leaks).collect()
}
