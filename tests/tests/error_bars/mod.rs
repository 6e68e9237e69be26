//! Error bars: their parts add up, they tell the true error, and they are told wherever they can be and nowhere else.

mod balanced;
mod effectivity;
mod films;
mod heat;
mod nothing;
mod rims;
mod shares;
mod tolerance;
