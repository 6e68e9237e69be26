//! The full tier: what takes minutes, or compares pages of figures.
//! `cargo test --release --workspace --test full cavitation` runs a part of it.

mod big_end_orbit;
#[cfg(unix)]
mod book;
mod capabilities;
mod cavitation;
mod conserving_orbits;
mod contact;
mod coverage;
mod crate_arrows;
mod crosscheck;
mod cycles;
mod deletion;
mod dimensions;
mod faults;
mod film_places;
mod flexpde_limits;
mod frequency;
mod fuzzing;
mod hard_cases;
mod liner;
mod mesh_readers;
mod no_orbit;
mod orbits_of_scenes;
mod pages;
mod parts;
mod performance;
mod random_sensitivity;
mod random_shafts;
mod random_thermal;
mod random_tilted;
mod reference;
#[cfg(unix)]
mod release;
mod shaft_cycle;
mod shipped_scenes;
mod short_crankshaft_page;
mod stability;
mod standstill;
mod thermal_films;
mod toy_effect;
mod twenty_turns;
