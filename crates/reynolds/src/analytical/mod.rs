//! Closed forms, once, cited: what the numerical film is tested against, and the wall of a liner that is a ring.

pub mod bearing_curve;
pub mod elastic_ring;
pub mod iso7902;
pub mod ocvirk;
pub mod sommerfeld;
