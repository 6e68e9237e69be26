//! Seconds that a function takes: of the processor, and on the wall.

use std::sync::LazyLock;
use std::time::Instant;

use cpu_time::ProcessTime;

/// What something took.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Spent {
    /// Processor time of all threads [s].
    pub cpu: f64,
    /// Time on the wall [s].
    pub wall: f64,
}

impl Spent {
    /// The time that counts on so many threads [s]: on one that of the processor, which a busy machine leaves alone.
    pub fn on(self, threads: usize) -> f64 {
        if threads == 1 { self.cpu } else { self.wall }
    }
}

/// Processor time of all threads since the first call [s].
pub fn processor_seconds() -> f64 {
    static START: LazyLock<ProcessTime> = LazyLock::new(ProcessTime::now);
    START.elapsed().as_secs_f64()
}

/// The value of `work`, and what it took.
pub fn timed<T>(work: impl FnOnce() -> T) -> (T, Spent) {
    let (cpu, wall) = (ProcessTime::now(), Instant::now());
    let value = work();
    let spent = Spent { cpu: cpu.elapsed().as_secs_f64(), wall: wall.elapsed().as_secs_f64() };
    (value, spent)
}

/// The median of what `work` took in `runs` runs, each part by itself.
pub fn median<T>(runs: usize, mut work: impl FnMut() -> T) -> Spent {
    median_of((0..runs).map(|_| timed(&mut work).1).collect())
}

/// The median of each part.
pub fn median_of(spent: Vec<Spent>) -> Spent {
    let middle = |mut seconds: Vec<f64>| {
        seconds.sort_by(f64::total_cmp);
        seconds[seconds.len() / 2]
    };
    Spent {
        cpu: middle(spent.iter().map(|it| it.cpu).collect()),
        wall: middle(spent.iter().map(|it| it.wall).collect()),
    }
}

/// `work` on so many threads.
///
/// # Panics
/// If the threads do not start.
pub fn on_threads<T: Send>(threads: usize, work: impl FnOnce() -> T + Send) -> T {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build();
    pool.expect("threads start").install(work)
}
