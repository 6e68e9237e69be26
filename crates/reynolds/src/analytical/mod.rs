//! Closed forms, once, cited: what the numerical film is tested against.

pub mod bearing_curve;
pub mod iso7902;
pub mod ocvirk;
pub mod sommerfeld;
