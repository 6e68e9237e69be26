//! All tests that cross crates, as one program; `cargo test -p oilwedge-tests cli::sweep` runs some of them.

mod architecture;
mod catalogue;
mod cavitation;
mod cli;
mod contact;
mod convergence;
mod crosscheck;
mod defaults;
mod dependencies;
mod difficult_films;
mod duty_cycle;
mod dynamics;
mod equilibrium;
mod error_bars;
mod faults;
mod feeds;
mod fields;
mod friction;
mod guembel_flows;
mod invariance;
mod limits;
mod liner;
mod literature;
mod oil_balance;
mod orbit;
mod pages;
mod pictures;
mod refinement;
#[cfg(target_os = "linux")]
mod reported_numbers;
mod scene_properties;
mod scenes;
mod shaft;
mod shapes;
mod tilt;
mod verdicts;
