//! What this machine can do: how fast it moves bytes and multiplies, measured in the same run as what is compared with
//! it.

use std::hint::black_box;

use faer::linalg::matmul::matmul;
use faer::{Accum, Mat, Par};
use rayon::prelude::*;

use super::clock::{on_threads, timed};

/// Numbers in each of the two arrays of the copy: far more than any cache holds.
const COPIED: usize = 16 << 20;
/// Rows of the dense matrices of the product: they stay in the cache.
const ROWS: usize = 256;
/// Runs of each; the quickest counts, for a rate is a property of the machine.
const RUNS: usize = 7;

/// Rates of this machine.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Machine {
    /// Bytes moved a second, that is read and written, by a copy of a great array, on one thread.
    pub bandwidth: f64,
    /// Rate of copying on two threads.
    pub bandwidth_of_two: f64,
    /// Additions and multiplications a second of a dense product in double precision, on one thread.
    pub flops: f64,
}

impl Machine {
    /// Measures this machine, in about a second.
    pub fn measured() -> Self {
        Self { bandwidth: bandwidth(1), bandwidth_of_two: bandwidth(2), flops: flops() }
    }

    /// Bytes copied a second on one thread: each is read and written.
    pub fn copied(&self) -> f64 {
        0.5 * self.bandwidth
    }

    /// Bandwidth on so many threads [B/s].
    pub fn bandwidth_on(&self, threads: usize) -> f64 {
        if threads == 1 { self.bandwidth } else { self.bandwidth_of_two }
    }
}

/// Seconds of the processor on one thread, on the wall on more, as everything is timed here.
fn quickest<T>(threads: usize, mut work: impl FnMut() -> T) -> f64 {
    let seconds = (0..RUNS).map(|_| timed(&mut work).1.on(threads));
    seconds.fold(f64::INFINITY, f64::min)
}

fn bandwidth(threads: usize) -> f64 {
    let from = vec![1.0_f64; COPIED];
    let mut to = vec![0.0_f64; COPIED];
    let part = COPIED / threads;
    let seconds = on_threads(threads, || {
        quickest(threads, || {
            let parts = to.par_chunks_mut(part).zip(from.par_chunks(part));
            parts.for_each(|(to, from)| black_box(to).copy_from_slice(black_box(from)));
        })
    });
    (2 * 8 * COPIED) as f64 / seconds
}

fn flops() -> f64 {
    let [a, b] = [1.0, 0.5].map(|x| Mat::from_fn(ROWS, ROWS, |i, j| x + (i + j) as f64));
    let mut c = Mat::<f64>::zeros(ROWS, ROWS);
    let product = || matmul(c.as_mut(), Accum::Replace, black_box(&a), black_box(&b), 1.0, Par::Seq);
    2.0 * (ROWS as f64).powi(3) / quickest(1, product)
}

/// How many threads wanted to run in the last minute, as the operating system tells it: on a quiet machine at most
/// those of this run.
pub fn busy() -> String {
    let load = std::fs::read_to_string("/proc/loadavg").unwrap_or_default();
    load.split(' ').next().unwrap_or_default().to_owned()
}

/// Name of the processor, as the operating system tells it.
pub fn processor() -> String {
    let facts = std::fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    let line = facts.lines().find_map(|line| line.strip_prefix("model name"));
    line.map_or("of an unknown name".to_owned(), |rest| rest.trim_start_matches([' ', '\t', ':']).to_owned())
}
