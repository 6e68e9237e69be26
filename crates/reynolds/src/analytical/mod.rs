//! Closed forms, once, cited: what the numerical film is tested against.

pub mod iso7902;
pub mod ocvirk;
pub mod sommerfeld;
