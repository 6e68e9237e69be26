//! The time that the processor gives the threads that compute together, whatever else the process and the machine do.

use std::cell::OnceCell;
use std::fs;
use std::path::PathBuf;
use std::sync::{Arc, Mutex, PoisonError};

use cpu_time::ProcessTime;
use rayon::{ThreadPool, ThreadPoolBuildError, ThreadPoolBuilder};

thread_local! {
    /// The threads that compute with this one, if they count their time together.
    static TOGETHER: OnceCell<Arc<Threads>> = const { OnceCell::new() };
}

/// The files in which the system keeps the times of some threads.
#[derive(Debug, Default)]
struct Threads(Mutex<Vec<PathBuf>>);

impl Threads {
    /// Counts the time of the calling thread among theirs.
    fn join(self: Arc<Self>) {
        // Systems other than Linux have no such file.
        if let Ok(own) = fs::read_link("/proc/thread-self") {
            self.0
                .lock()
                .unwrap_or_else(PoisonError::into_inner)
                .push(PathBuf::from("/proc").join(own).join("schedstat"));
        }
        TOGETHER.with(|together| drop(together.set(self)));
    }

    /// Time of the threads [s], where the system keeps it.
    fn seconds(&self) -> Option<f64> {
        let files = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        let of_thread = |file: &PathBuf| {
            let nanoseconds: f64 = fs::read_to_string(file).ok()?.split_whitespace().next()?.parse().ok()?;
            Some(1e-9 * nanoseconds)
        };
        let times: Option<Vec<f64>> = files.iter().map(of_thread).collect();
        times.filter(|times| !times.is_empty()).map(|times| times.iter().sum())
    }
}

/// A pool of so many threads that count their time together, apart from all others of the process.
///
/// # Errors
/// They cannot be started.
pub fn pool(threads: usize) -> Result<ThreadPool, ThreadPoolBuildError> {
    let together = Arc::<Threads>::default();
    ThreadPoolBuilder::new().num_threads(threads).start_handler(move |_| Arc::clone(&together).join()).build()
}

/// The time of the threads of the [`pool`] of the calling thread or, of one without, of the whole process [s].
pub(crate) fn seconds() -> f64 {
    let of_pool = TOGETHER.with(|together| together.get().and_then(|threads| threads.seconds()));
    of_pool.unwrap_or_else(|| ProcessTime::now().as_duration().as_secs_f64())
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::hint::black_box;
    use std::time::{Duration, Instant};

    /// Adds numbers for so long [s] on the processor.
    fn work(seconds: f64) -> f64 {
        let (begun, mut sum) = (super::seconds(), 0.0);
        let limit = Instant::now() + Duration::from_secs(20);
        while super::seconds() - begun < seconds && Instant::now() < limit {
            sum += (0..10_000).map(f64::from).map(f64::sqrt).map(black_box).sum::<f64>();
        }
        sum
    }

    #[test]
    fn threads_count_their_time_apart_from_others() {
        let [busy, idle] = [pool(1), pool(1)].map(|pool| pool.expect("a thread"));
        let before = idle.install(seconds);
        busy.install(|| work(0.05));
        let taken = idle.install(seconds) - before;
        if cfg!(target_os = "linux") {
            assert!(taken < 0.02, "{taken}");
        }
    }
}
