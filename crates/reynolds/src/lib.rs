//! One oil film: Reynolds' equation for a given journal state.
//!
//! Mass balance over the film thickness (Reynolds 1886): what pressure drives and what the journal
//! drags along must not pile up,
//!
//! ```text
//! div J + dh/dt = 0,    J = (U h / 2, 0) - h^3 / (12 mu(p)) grad p
//! ```
//!
//! on the developed surface `(x = R phi, z)`, with pressure given at the ends and where oil is fed.
//! With the reduced pressure `q = Int_0^p mu0/mu(s) ds` it is linear for any law `mu(p)`:
//!
//! ```text
//! div( U h / 2 ) + dh/dt = div( h^3 / (12 mu0) grad q )
//! ```
//!
//! | symbol | unit | code | where |
//! |---|---|---|---|
//! | R, B, c | m | `radius`, `length`, `clearance` | [`Bearing`] |
//! | p_e | Pa | `end_pressure` | [`Bearing`] |
//! | (e_x, e_y), (e_x', e_y'), omega | m, m/s, rad/s | `offset`, `velocity`, `speed` | [`JournalState`] |
//! | (g_x, g_y), (g_x', g_y') | rad, rad/s | `tilt`, `tilt_rate` | [`JournalState`] |
//! | h, grad h, dh/dt | m, -, m/s | `thickness`, `slope`, `rate` | [`FilmPoint`], [`film_thickness`] |
//! | U = omega R | m/s | `velocity` | [`FilmPoint`] |
//! | mu0, mu(p), q(p) | Pa s, Pa | `viscosity`, `viscosity_ratio`, `reduced_pressure` | [`lubricant`] |
//! | h^3/(12 mu0) | m4/(N s) | `conductance` | [`terms::Poiseuille`] |
//! | U h/2 | m2/s | `flux` | [`terms::Couette`] |
//! | dh/dt | m/s | `storage` | [`terms::squeeze`] |
//! | d(theta h)/dt | m/s | `per_time`, `known` | [`Storage`], in orbits of films that conserve oil |
//! | d | m | `coefficients` | [`film_thickness::Deflection`] of a [`wall`] that gives way |
//! | W | N | `force` | [`quantities::load`] |
//! | p_a(h) | Pa | `pressure` | [`contact`], where rough surfaces touch |
//!
//! All pressures are gauge. The bearing is at rest; `phi` counts from +x towards +y; the minimum
//! film lies at `atan2(e_y, e_x)`; `W` is the external force that the film carries.
//!
//! Reading order: [`terms`] (start with `poiseuille.rs`), [`film_thickness`], [`lubricant`], [`gap`] (where the film is
//! least), [`supply`] (where pressure is given), [`film_problem`] (all of it compiled), [`SolvedFilm`] (solved: what is
//! asked about), [`sharp`] (the pressure over the cavity that finite volumes have found), [`quantities`] (what is
//! reported), [`analytical`] (closed forms to test against). An effect is an entry in one of these places; an empty
//! place costs nothing.

pub mod analytical;
pub mod angles;
pub mod bearing;
pub mod cavitation;
mod chebyshev;
mod chord;
pub mod contact;
mod cubic_film;
pub mod error_bar;
pub mod existence;
mod fallback;
mod film_change;
mod film_law;
pub mod film_point;
pub mod film_problem;
mod film_start;
pub mod film_thickness;
pub mod flow_factors;
pub mod gap;
pub mod journal_state;
pub mod levels;
pub mod lubricant;
mod position_sensitivity;
pub mod quantities;
mod reference_film;
mod reuse;
pub mod sharp;
pub mod solve;
mod solved_film;
mod storage;
pub mod supply;
pub mod terms;
pub mod theory;
mod viscosity_across;
pub mod wall;
mod whirl;

pub use bearing::Bearing;
pub use cavitation::Cavitation;
pub use existence::NoFilm;
pub use fallback::Fallback;
pub use film_change::FilmChange;
pub use film_point::{FilmFlow, FilmPoint};
pub use film_problem::{FilmProblem, FilmSolution, FilmSystem, FilmTrace, Form};
pub use film_start::FilmStart;
pub use gap::{Gap, Thinnest};
pub use journal_state::{CentreVelocity, JournalChange, JournalState};
pub use position_sensitivity::MixedChange;
pub use reference_film::ReferenceFilm;
pub use solved_film::SolvedFilm;
pub use storage::Storage;
pub use theory::Theory;
pub use viscosity_across::{AcrossFilm, EddyFactors, ViscosityAcross};
pub use whirl::Whirl;
