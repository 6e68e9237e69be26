//! Values that are computed in parallel, in their order.

use rayon::prelude::*;

/// The values of an iterator in their order. Rayon's `collect` gives the same, but is also compiled for iterators of
/// unknown length: twice the code for each.
pub fn in_order<T: Send>(values: impl IndexedParallelIterator<Item = T>) -> Vec<T> {
    let mut all = Vec::new();
    values.collect_into_vec(&mut all);
    all
}
