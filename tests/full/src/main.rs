//! `cargo run --release -p oilwedge-full -- COMMAND [..]`: measures, or writes pages of `docs` anew.

mod commands;

use std::error::Error;
use std::process::ExitCode;

use commands::{
    accuracy, compare, crates, house, orbits, performance, prices, shafts, stability, thermal, tilted, validation,
};

/// What each command is for; the head of its file in `src/commands` tells its arguments.
const COMMANDS: [(&str, &str); 12] = [
    ("accuracy", "how often error bars hold: docs/validation/accuracy.md"),
    ("compare", "what differs between two programs: scenes, engines, random bearings"),
    ("crates", "the drawing of docs/architecture.md: docs/images/crates.svg"),
    ("house", "files that know an effect, circles of imports, sizes of the crates"),
    ("orbits", "bars of random orbits"),
    ("performance", "times: docs/performance.md; `performance gate` counts instructions"),
    ("prices", "what the next digit costs: docs/validation/prices.md"),
    ("shafts", "random shafts over their cycles"),
    ("stability", "hard cases and the map of stability: docs/validation/stability.md"),
    ("thermal", "random bearings with temperatures across their films"),
    ("tilted", "random tilted and elastic bearings: docs/validation/random_bearings.md"),
    ("validation", "computed tables and figures of the other pages"),
];

fn main() -> Result<ExitCode, Box<dyn Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let Some((command, arguments)) = arguments.split_first() else {
        return Ok(usage());
    };
    match command.as_str() {
        "accuracy" => accuracy::run(arguments)?,
        "compare" => compare::run(arguments)?,
        "crates" => crates::run()?,
        "house" => house::run(arguments),
        "orbits" => orbits::run(arguments),
        "performance" => return Ok(performance::run(arguments)?),
        "prices" => prices::run(arguments)?,
        "shafts" => shafts::run(arguments),
        "stability" => stability::run()?,
        "thermal" => thermal::run(arguments),
        "tilted" => tilted::run(arguments)?,
        "validation" => validation::run(arguments)?,
        _ => return Ok(usage()),
    }
    Ok(ExitCode::SUCCESS)
}

/// Lists the commands.
fn usage() -> ExitCode {
    COMMANDS.iter().for_each(|(name, what)| eprintln!("{name:22} {what}"));
    ExitCode::from(2)
}
