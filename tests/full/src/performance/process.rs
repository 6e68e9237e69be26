//! The program as its user runs it: what a whole process takes.

use std::path::Path;
use std::process::{Command, Stdio};
use std::time::Instant;

use wait4::Wait4;

use super::clock::Spent;

/// What a process took.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Process {
    /// Time of the process.
    pub spent: Spent,
    /// Most memory that it held [B].
    pub peak: u64,
}

/// `oilwedge solve SCENE` on so many threads, output included, with error bars or without; results go to a folder
/// beside the scene.
///
/// # Panics
/// If it fails.
pub fn run(program: &Path, scene: &Path, threads: usize, bars: bool) -> Process {
    let start = Instant::now();
    let mut child = command(program, scene, threads, bars).spawn().expect("the program starts");
    let ended = child.wait4().expect("the program ends");
    let wall = start.elapsed().as_secs_f64();
    assert!(ended.status.success(), "{} fails", scene.display());
    let cpu = (ended.rusage.utime + ended.rusage.stime).as_secs_f64();
    Process { spent: Spent { cpu, wall }, peak: ended.rusage.maxrss }
}

/// `oilwedge sweep SCENE` on so many threads, without error bars.
///
/// # Panics
/// If it fails.
pub fn sweep(program: &Path, scene: &Path, threads: usize) -> Spent {
    let start = Instant::now();
    let mut child = Command::new(program)
        .args(["sweep", "--fresh", "--bars", "none", "--threads", &threads.to_string(), "--out"])
        .arg(scene.with_extension("out"))
        .arg(scene)
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .spawn()
        .expect("the program starts");
    let ended = child.wait4().expect("the program ends");
    assert!(ended.status.success(), "{} fails", scene.display());
    Spent { cpu: (ended.rusage.utime + ended.rusage.stime).as_secs_f64(), wall: start.elapsed().as_secs_f64() }
}

/// Processor time [s] of a program that may fail; what it prints is dropped.
///
/// # Errors
/// The program does not start.
pub fn processor_time(mut command: Command) -> std::io::Result<f64> {
    let ended = command.stdout(Stdio::null()).stderr(Stdio::null()).spawn()?.wait4()?;
    Ok((ended.rusage.utime + ended.rusage.stime).as_secs_f64())
}

/// The command of [`run`].
pub fn command(program: &Path, scene: &Path, threads: usize, bars: bool) -> Command {
    let mut command = Command::new(program);
    command
        .args(["solve", "--bars", if bars { "auto" } else { "none" }])
        .args(["--threads", &threads.to_string(), "--out"])
        .arg(scene.with_extension("out"))
        .arg(scene)
        .stdout(Stdio::null())
        .stderr(Stdio::null());
    command
}

/// Argument by which the command `performance` is asked to run [`run`] for [`apart`].
pub const APART: &str = "apart";

/// [`run`] from a small process of its own: what a process held at most counts from before its program was loaded, when
/// it still shares the memory of the one that started it.
///
/// # Panics
/// If it fails.
pub fn apart(program: &Path, scene: &Path, threads: usize, bars: bool) -> Process {
    let own = std::env::current_exe().expect("path of this program");
    let mut command = Command::new(own);
    command.args(["performance", APART]).arg(program).arg(scene);
    command.args([threads.to_string(), bars.to_string()]);
    let told = command.output().expect("this program starts").stdout;
    let told = String::from_utf8_lossy(&told);
    let numbers: Vec<f64> = told.split_whitespace().filter_map(|word| word.parse().ok()).collect();
    let [cpu, wall, peak] = numbers[..] else {
        panic!("{} fails", scene.display());
    };
    Process { spent: Spent { cpu, wall }, peak: peak as u64 }
}

/// The other side of [`apart`]: takes its arguments, prints what it measured.
///
/// # Panics
/// If the arguments are not those.
pub fn answer(arguments: &[String]) {
    let [program, scene, threads, bars] = arguments else {
        panic!("program, scene, threads, bars");
    };
    let threads = threads.parse().expect("a number of threads");
    let Process { spent, peak } = run(Path::new(program), Path::new(scene), threads, bars == "true");
    println!("{} {} {peak}", spent.cpu, spent.wall);
}
