//! Journals whose axis is inclined: the film, its moment and their balance, against closed identities and the numbers
//! of a second code.

mod balance;
mod characteristics;
mod film;
mod moment;
