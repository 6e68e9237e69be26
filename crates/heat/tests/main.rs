//! Tests of the crate against closed forms and an independent march.

mod bush;
mod eddies;
mod journal_film;
mod layers;
mod nahme;
mod ring;
mod slider;
