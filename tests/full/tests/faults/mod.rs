//! Faults of the machine that take long to show: kills at random moments, full disks, interrupts, limits of time and
//! size.
#![cfg(unix)]

mod full_disk;
mod interrupts;
mod kill;
mod limits;
mod same_bits;
mod shared;
