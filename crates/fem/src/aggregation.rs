//! Coarser matrices by plain aggregation: unknowns are gathered in groups of neighbours that share one value.
//!
//! A group is an unknown and all neighbours to which it is strongly coupled, if none of them has a group yet; what is
//! left joins the group to which it is coupled most. The coarse matrix is the sum of entries,
//! `A_IJ = sum over i in I, j in J of a_ij`. Smoothing the functions of groups saves two steps in fifteen and costs as
//! much as it saves.
//!
//! Source: Vanek, Mandel, Brezina, Computing 56 (1996) 179 (groups); Notay, Electron. Trans. Numer. Anal. 37 (2010) 123
//! (plain aggregation, which needs a K-cycle).

use std::sync::Arc;

use crate::{Matrix, Pattern};

/// An unknown that belongs to no group: it is masked.
const NO_GROUP: u32 = u32::MAX;
/// A coupling is strong above this part of the geometric mean of the two diagonal entries.
const STRONG: f64 = 0.08;

/// Unknowns gathered in groups.
#[derive(Debug)]
pub(crate) struct Groups {
    /// The group of each unknown.
    group: Vec<u32>,
    /// Number of groups.
    pub(crate) count: usize,
}

impl Groups {
    /// Groups of the unknowns of `matrix` that are not masked.
    pub(crate) fn new(matrix: &Matrix, masked: &[bool]) -> Self {
        let n = matrix.pattern.dimension();
        let roots: Vec<f64> = (0..n).map(|i| matrix.diagonal(i).max(0.0).sqrt()).collect();
        let pulls = |i: usize| {
            let row = matrix.pattern.row(i);
            (matrix.pattern.columns[row.clone()].iter().map(|&j| j as usize))
                .zip(matrix.values[row].iter().map(|value| -value))
                .filter(move |&(j, _)| j != i && !masked[j])
        };
        let strong = |i: usize| {
            let (root, roots) = (roots[i], &roots);
            pulls(i).filter(move |&(j, pull)| pull > STRONG * root * roots[j]).map(|(j, _)| j)
        };
        let free = |&i: &usize| !masked[i];
        let mut group = vec![NO_GROUP; n];
        let mut count = 0;
        for i in (0..n).filter(free) {
            if group[i] == NO_GROUP && strong(i).all(|j| group[j] == NO_GROUP) {
                group[i] = count;
                strong(i).for_each(|j| group[j] = count);
                count += 1;
            }
        }
        let first = group.clone();
        for i in (0..n).filter(free).filter(|&i| first[i] == NO_GROUP) {
            let most =
                pulls(i).filter(|&(j, pull)| pull > 0.0 && first[j] != NO_GROUP).max_by(|a, b| a.1.total_cmp(&b.1));
            group[i] = most.map_or(NO_GROUP, |(j, _)| first[j]);
        }
        for i in (0..n).filter(free) {
            if group[i] == NO_GROUP {
                group[i] = count;
                count += 1;
            }
        }
        Self { group, count: count as usize }
    }

    /// Sums over groups.
    pub(crate) fn restrict(&self, r: &[f32]) -> Vec<f32> {
        let mut sums = vec![0.0; self.count];
        for (r, &group) in r.iter().zip(&self.group).filter(|(_, group)| **group != NO_GROUP) {
            sums[group as usize] += r;
        }
        sums
    }

    /// Adds to each unknown the value of its group.
    pub(crate) fn add_prolonged(&self, correction: &[f32], z: &mut [f32]) {
        for (z, &group) in z.iter_mut().zip(&self.group).filter(|(_, group)| **group != NO_GROUP) {
            *z += correction[group as usize];
        }
    }

    /// The matrix between groups.
    pub(crate) fn galerkin(&self, matrix: &Matrix) -> Matrix {
        let (start, members) = self.members();
        let mut row_start = Vec::with_capacity(self.count + 1);
        row_start.push(0);
        let (mut columns, mut values) = (Vec::<u32>::new(), Vec::<f64>::new());
        // Where the current row has an entry for a group; places before its beginning are stale.
        let mut place = vec![u32::MAX; self.count];
        for row in 0..self.count {
            let begin = columns.len() as u32;
            for &i in &members[start[row] as usize..start[row + 1] as usize] {
                for k in matrix.pattern.row(i as usize) {
                    let column = self.group[matrix.pattern.columns[k] as usize];
                    if column == NO_GROUP {
                        continue;
                    }
                    let at = &mut place[column as usize];
                    if *at == u32::MAX || *at < begin {
                        *at = columns.len() as u32;
                        columns.push(column);
                        values.push(0.0);
                    }
                    values[*at as usize] += matrix.values[k];
                }
            }
            row_start.push(columns.len() as u32);
        }
        Matrix { pattern: Arc::new(Pattern { row_start, columns }), values }
    }

    /// The unknowns of each group: those of group `k` are `members[start[k]..start[k + 1]]`.
    fn members(&self) -> (Vec<u32>, Vec<u32>) {
        let grouped = || (0u32..).zip(&self.group).filter(|(_, group)| **group != NO_GROUP);
        let mut start = vec![0u32; self.count + 1];
        for (_, &group) in grouped() {
            start[group as usize + 1] += 1;
        }
        for k in 0..self.count {
            start[k + 1] += start[k];
        }
        let mut next = start.clone();
        let mut members = vec![0u32; start[self.count] as usize];
        for (i, &group) in grouped() {
            members[next[group as usize] as usize] = i;
            next[group as usize] += 1;
        }
        (start, members)
    }
}
