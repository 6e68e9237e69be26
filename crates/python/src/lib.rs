//! The native part of the Python package `oilwedge`: scenes in, results out. It is thin: what people call is typed
//! Python, in `python/oilwedge`.
//!
//! Long work runs on threads of its own (`work.rs`), without Python's lock and with an eye on Ctrl-C; a panic ends
//! there. Fields are moved into numpy's arrays, not copied (`film.rs`). What goes wrong is an exception of the package
//! (`failure.rs`).
//!
//! Reading order: `scene.rs`, `run.rs`, `numbers.rs`, `film.rs`, `figures.rs`, `sweep.rs`, `cases.rs`, `catalogue.rs`;
//! `work.rs`, `shelf.rs`, `node.rs`, `failure.rs`.

mod cases;
mod catalogue;
mod failure;
mod figures;
mod film;
mod node;
mod numbers;
mod run;
mod scene;
mod shelf;
mod sweep;
mod work;

use pyo3::prelude::*;

/// The native module.
#[pymodule]
mod _native {
    #[pymodule_export]
    use crate::cases::Cases;
    #[pymodule_export]
    use crate::catalogue::{catalogue, converted, explain, shown, texts, version};
    #[pymodule_export]
    use crate::figures::{figure, page, sampled, sweep_page};
    #[pymodule_export]
    use crate::numbers::Numbers;
    #[pymodule_export]
    use crate::run::solve;
    #[pymodule_export]
    use crate::scene::{PyScene, kind, kinds};
    #[pymodule_export]
    use crate::sweep::sweep;
}
