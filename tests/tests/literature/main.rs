//! Closed forms and published numbers, one source a file.

mod barus_1893;
mod flexpde_2016;
mod ocvirk_1952;
mod rayleigh_1918;
mod sommerfeld_1904;
