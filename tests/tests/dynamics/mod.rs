//! Stiffness, damping and the stability of a rotor: against differences of films, identities, and the numbers of second
//! codes.

mod reference;
mod tangent;
