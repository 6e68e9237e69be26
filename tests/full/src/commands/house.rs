//! `house`: which files know an effect, import circles, and sizes of the crates.

use oilwedge_tests::house::{EFFECTS, circles, knowing, sources};

/// Runs the command.
pub(crate) fn run(_: &[String]) {
    let sources = sources();
    for (effect, most) in EFFECTS {
        let files = knowing(&sources, effect);
        println!("{effect}: {} files, at most {most}", files.len());
        files.iter().for_each(|file| println!("    {file}"));
    }
    let mut packages: Vec<&str> = sources.iter().map(|source| source.package.as_str()).collect();
    packages.dedup();
    let all: usize = sources.iter().map(|source| source.lines_of_code()).sum();
    println!("{all} lines of code");
    for package in packages {
        let own = sources.iter().filter(|source| source.package == package);
        let lines: usize = own.map(|source| source.lines_of_code()).sum();
        println!("    {package}: {lines}, {:.1} %", 100.0 * lines as f64 / all as f64);
        for circle in circles(&sources, package) {
            println!("        circle of {}: {}", circle.len(), Vec::from_iter(circle).join(" "));
        }
    }
}
