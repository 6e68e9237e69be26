//! The full tier: what takes minutes, or compares pages of figures. `cargo test --release --workspace --test full cavitation` runs
//! a part of it.

#[cfg(unix)]
mod book;
mod cavitation {
    mod along_flow;
    mod counts;
    mod random;
}
mod coverage;
mod crosscheck;
mod deletion;
#[cfg(unix)]
mod faults {
    mod kill;
}
mod fuzzing;
mod hard_cases;
mod liner {
    mod search;
}
mod literature {
    mod short_crankshaft_page;
}
mod mesh_readers;
mod pages;
mod performance;
mod reference;
mod shaft {
    mod random;
}
mod tilt {
    mod random;
}
