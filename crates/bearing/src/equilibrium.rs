//! # Equilibrium: the position in which the film carries the load, and the tilt in which it carries its moment
//!
//! **Equation.** `W(e) = F` for the journal's offset `e`; where the tilt g is free, `W(e, g) = F` and
//! `m(e, g) = M + k (g_0 - g)` for offset and slope. Newton's method with the exact tangent of the film bordered by
//! that of the load: `dW/de = -(dW/dp) (dR/dp)^-1 (dR/de)`, the cavity held.
//!
//! | symbol | unit | code |
//! |---|---|---|
//! | F | N | `load` |
//! | W | N | `force` |
//! | M, k, g_0 | N m, N m/rad, rad | `Tilting` |
//! | dW/de | N/m | `stiffness` |
//!
//! The crate's one Newton iteration finds it, in rigid walls and in walls that give way.
//!
//! **Source.** Definition; Hamrock, Schmid, Jacobson (2004), ch. 10, for the limits of the load. **Range.** Steady
//! positions; the velocity of a moving centre turns with the line of centres. **Verified by**
//! `tests/tests/equilibrium.rs`: the tangent against differences, and eccentricities recovered from their loads.

use oilwedge_reynolds::SolvedFilm;

use crate::{Coordinates, FoundWarmth, Stiffness, WallByPlace, Work};

/// The balance has been found when force and load differ by this part of the load.
pub(crate) const BALANCED: f64 = 1e-12;
/// On coarser meshes, which only give a start, this part is enough.
pub const ROUGHLY_BALANCED: f64 = 1e-4;
/// Where force and load differ by less than this part of the load the tangent predicts the distance to the balance.
pub const NEAR: f64 = 0.1;

/// A journal in balance.
#[derive(Debug)]
pub struct Equilibrium {
    /// The film with the journal in the position found.
    pub film: SolvedFilm,
    /// The film there in cubic elements, where that carries the load.
    pub cubic: Option<SolvedFilm>,
    /// Load less force of the film, relative to the load (to the reference force if there is none).
    pub residual: f64,
    /// Load less force of the film [N].
    pub unbalanced: f64,
    /// Load less force of the forces alone, and of the moments alone as forces at half of the bearing's length, both
    /// relative to the load.
    pub parts: [f64; 2],
    /// What is free.
    pub coordinates: Coordinates,
    /// Positions tried on the mesh of the film.
    pub steps: usize,
    /// What the search has cost.
    pub work: Work,
    /// True where the deadline passed before the load was balanced: the film is that of the position reached.
    pub is_ended: bool,
    /// `dW/de` [N/m] in these coordinates, row: force; of a search from nearby and of a cubic balance as corrected by
    /// its steps: the error is of the order of the square root of the residual that they gained.
    pub stiffness: Stiffness,
    /// How the wall follows in that tangent.
    pub wall: WallByPlace,
    /// The heat of the film, where its temperature was found.
    pub warming: Option<FoundWarmth>,
}
