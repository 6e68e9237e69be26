//! The full tier of the crate: meshes of random liners. `cargo test --release --workspace --test full` runs it.

mod random;
mod random_liners;
