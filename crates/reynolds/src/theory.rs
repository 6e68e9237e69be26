//! # Short and long bearings: one of the two pressure flows left out
//!
//! **Equation.** Short: `d/dz( h^3/(12 mu) dp/dz ) = div( U h/2 ) + dh/dt`, each line along the axis by itself. Long: p
//! depends on phi alone; with a gap that does not vary along the axis that is the film between sealed ends, through
//! which nothing flows.
//!
//! | symbol | unit | code |
//! |---|---|---|
//! | parts of h^3/(12 mu) along x and z | 1 | `directions` |
//!
//! **Source.** Sommerfeld, Z. Math. Phys. 50 (1904) 97 (long); Ocvirk, NACA TN 2808 (1952) (short).
//! **Range.** Short: B/D to a quarter, a ring, for a pressure given along a line of constant phi has no meaning; no
//! jumps of h along x. Long: B/D from 2 on, h the same all along the axis, and a line of given pressure.
//! **Verified by** `literature/short_crankshaft_bearing`, `literature/short_bearing_finite_length`,
//! `literature/sommerfeld_1904`.

/// The directions in which pressure drives oil.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub enum Theory {
    /// Pressure drives oil around and along the axis.
    #[default]
    Full,
    /// Pressure drives oil along the axis only.
    Short,
    /// Pressure drives oil around only: the ends are sealed ([`crate::supply::BoundaryKind::Sealed`]).
    Long,
}

impl Theory {
    /// Parts of the conductance along x and along z [1].
    pub(crate) fn directions(self) -> [f64; 2] {
        match self {
            // Between sealed ends no pressure drives oil along the axis.
            Self::Full | Self::Long => [1.0; 2],
            Self::Short => [0.0, 1.0],
        }
    }

    /// Name of the theory in scenes and reports.
    pub fn name(self) -> &'static str {
        match self {
            Self::Full => "full",
            Self::Short => "short",
            Self::Long => "long",
        }
    }
}
