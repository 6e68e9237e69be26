//! Faults of the machine: a program that is killed, a disk that is full, a folder that cannot be written, two runs in
//! one folder, Ctrl-C, limits of time and size. Results are whole or absent, and what was finished is kept.
#![cfg(unix)]

mod places;
