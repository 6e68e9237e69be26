//! Rough surfaces that touch: closed forms, tangents, and the positions of a second code.

mod closed_forms;
mod rest;
mod tangent;
