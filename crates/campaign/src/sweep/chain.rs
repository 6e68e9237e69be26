//! Chains: runs of neighbouring cases along the last axis, each computed in its order by one worker.
//!
//! They are cut by the numbers of cases alone, so that a case has the same neighbours on any number of threads and
//! after any interruption.

use std::ops::Range;

use super::Plan;

/// Least chains of a sweep, if they are not too short then.
const MANY: usize = 16;
/// Least and most cases of a chain.
const LENGTH: [usize; 2] = [4, 32];

/// The cases of each chain, in the order of the cases.
pub(super) fn chains(plan: &Plan) -> Vec<Range<usize>> {
    let cases = plan.cases();
    let along = plan.axes.last().map_or(0, |axis| axis.values.len());
    if along == 0 {
        return Vec::new();
    }
    let [least, most] = LENGTH;
    let length = cases.div_ceil(MANY).clamp(least, most);
    let pieces = along.div_ceil(length);
    let cut = |piece: usize| piece * along / pieces;
    (0..cases / along)
        .flat_map(|row| (0..pieces).map(move |piece| row * along + cut(piece)..row * along + cut(piece + 1)))
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use oilwedge_scene::sweep::{AxisValue, SweepAxis};

    fn plan(lengths: &[usize]) -> Plan {
        let axis = |length: &usize| SweepAxis {
            name: String::new(),
            path: String::new(),
            unit: String::new(),
            values: vec![AxisValue::Number(0.0); *length],
            span: 0..0,
        };
        Plan {
            axes: lengths.iter().map(axis).collect(),
            columns: None,
            draws: None,
            text: String::new(),
            path: "".into(),
        }
    }

    #[test]
    fn chains_hold_every_case_once_and_stay_on_the_last_axis() {
        for lengths in [&[1][..], &[18], &[1000], &[40, 25], &[3, 100, 7], &[1000, 1], &[5, 33]] {
            let plan = plan(lengths);
            let chains = chains(&plan);
            let cases: Vec<usize> = chains.iter().cloned().flatten().collect();
            assert!(cases.iter().copied().eq(0..plan.cases()), "{lengths:?}");
            for chain in &chains {
                assert!(!chain.is_empty() && chain.len() <= LENGTH[1], "{lengths:?}");
                let row = |case: usize| plan.indices(case)[..lengths.len() - 1].to_vec();
                assert_eq!(row(chain.start), row(chain.end - 1), "{lengths:?}");
            }
        }
        assert!(chains(&plan(&[18])).len() >= 4);
        assert!(chains(&plan(&[1000])).len() >= 32);
    }
}
