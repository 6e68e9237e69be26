//! Lagrange finite elements for scalar conservation laws on triangles. Knows no oil.
//!
//! Physics states a [`ConservationLaw`]: flux and source at a point. Reading order: [`lagrange`] and [`quadrature`]
//! (the reference triangle), [`mapping`], [`space`] (degrees of freedom), [`field`] (functions), [`extrema`],
//! [`conservation_law`], [`element`] and [`assembly`] (the one element loop), [`integrate`](mod@integrate) (all other
//! integrals), [`in_order`](mod@in_order), [`sparsity`], [`ordering`], [`factorization`] and [`unsymmetric`]
//! ([`harmonic`]: systems of harmonic motions), [`newton`], [`complementarity`] (obstacles), [`linear_solver`],
//! [`linearisation`]; for large systems `conjugate_gradients`, `multigrid` (on `sweeps`, [`linear_prolongation`] and
//! `aggregation`), and `iterated`, which gives up on it where it is slow. [`prolongation`] and [`nested`]: cubic
//! elements on top of quadratic ones, for error bars. [`marking`] chooses triangles to refine;
//! [`transfer`](mod@transfer) carries a field to the refined mesh. [`control_volumes`] is the sub-mesh of schemes of
//! finite volumes.

mod aggregation;
pub mod assembly;
pub mod complementarity;
mod conjugate_gradients;
pub mod conservation_law;
pub mod constraints;
pub mod control_volumes;
pub mod dual;
pub mod element;
pub mod error;
pub mod extrema;
pub mod factorization;
pub mod field;
mod front;
pub mod harmonic;
pub mod in_order;
pub mod integrate;
mod iterated;
pub mod kink_rule;
pub mod lagrange;
pub mod linear_prolongation;
pub mod linear_solver;
pub mod linearisation;
pub mod mapping;
pub mod marking;
pub mod matrix;
mod multigrid;
pub mod nested;
pub mod newton;
pub mod ordering;
pub mod pattern;
pub mod prolongation;
pub mod quadrature;
pub mod space;
pub mod sparsity;
mod sweeps;
pub mod transfer;
pub mod unsymmetric;

pub use assembly::Assembler;
pub use conservation_law::{ConservationLaw, TangentKind};
pub use constraints::Constraints;
pub use control_volumes::ControlVolumes;
pub use dual::Dual;
pub use error::Error;
pub use factorization::{Analysis, Factorization};
pub use field::Field;
pub use harmonic::{HarmonicAnalysis, HarmonicSystem};
pub use in_order::in_order;
pub use integrate::integrate;
pub use kink_rule::KinkRule;
pub use linear_prolongation::LinearProlongation;
pub use linear_solver::LinearSolver;
pub use linearisation::Linearisation;
pub use matrix::Matrix;
pub use pattern::Pattern;
pub use prolongation::Prolongation;
pub use quadrature::Quadrature;
pub use space::Space;
pub use transfer::transfer;
pub use unsymmetric::{UnsymmetricAnalysis, UnsymmetricFactorization};
