//! One oil film: Reynolds' equation for a given journal state.
pub mod analytical;
pub mod cavitation;
mod film_law;
pub mod film_point;
pub mod film_problem;
pub mod film_thickness;
pub mod journal_state;
pub mod liner;
pub mod lubricant;
pub mod quantities;
pub mod supply;
pub mod terms;

pub use cavitation::Cavitation;
pub use film_point::{FilmFlow, FilmPoint};
pub use film_problem::{FilmProblem, FilmSolution, FilmSystem, Form, NoFilm};
pub use journal_state::JournalState;
pub use liner::Liner;
