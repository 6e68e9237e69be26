//! Where the solver is stable: the hard cases beside each other, and the map of eccentricity against the coefficient of
//! the viscosity law over its limit, and against slenderness.

pub mod map;
pub mod map_picture;
pub mod page;
pub mod trends;
