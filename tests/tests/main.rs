//! All tests that cross crates, as one program; `cargo test -p oilwedge-tests cli::sweep` runs some of them.

mod architecture;
mod cavitation;
mod cli;
mod convergence;
mod coverage;
mod crosscheck;
mod deletion;
mod dependencies;
mod equilibrium;
mod error_bars;
mod faults;
mod fields;
mod film_places;
mod friction;
mod fuzzing;
mod hard_cases;
mod invariance;
mod literature;
mod mesh_readers;
mod oil_balance;
mod performance;
mod reference;
mod refinement;
mod reported_numbers;
mod scene_properties;
mod scenes;
