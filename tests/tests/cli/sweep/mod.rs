//! `sweep`: many operating points at one command, in a table that survives its writer.

mod cases;
mod columns;
mod draws;
mod forecast;
mod rotor;
mod rows;
mod survival;
mod warnings;
