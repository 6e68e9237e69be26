//! # Run-in bore: worn until no position of the journal leaves less than a given film
//!
//! **Equation.** `d = max(0, h_w - min_i h_i)`, `h_i = c - (e_i + z g_i).n`: at each angle the lines of the journal's surface in its positions i have a lower envelope, a broken line along the
//! axis, and the bore wears until it runs parallel to it at the distance h_w.
//!
//! | symbol | unit | code |
//! |---|---|---|
//! | h_w | m | `film` |
//! | e_i, g_i | m, rad | `positions` |
//! | c, R | m | `clearance`, `radius` |
//!
//! **Source.** Zharov, Modelling of the tribosystem crankshaft - bearings - supports (dissertation, VNIIZhT Moscow, 1996), the settled shape of a section, which wears at the same rate all along it.
//! **Range.** Positions of the journal that do not change as the bore wears. **Verified by** `no_position_leaves_less_than_the_film` and `slopes_and_variations_match_differences`.

use super::profile::{Profile, Relief};

/// Triangles show the edges of the worn place by sides of this part of the radius.
const FINEST: f64 = 0.1;

/// A bore worn by a journal in several positions.
#[derive(Debug, Clone, PartialEq)]
pub struct Envelope {
    /// Radius R [m].
    pub radius: f64,
    /// Radial clearance c [m].
    pub clearance: f64,
    /// Film that is left [m].
    pub film: f64,
    /// Offset at mid-length [m] and slope [rad] of the journal in each position.
    pub positions: Vec<([f64; 2], [f64; 2])>,
}

impl Envelope {
    /// The wear at a place and, of the position that wears it most, `(e + z g).n` [m]; none where nothing is worn.
    fn wearing(&self, [x, z]: [f64; 2]) -> Option<(Relief, f64)> {
        let (sin, cos) = (x / self.radius).sin_cos();
        let reaches = self.positions.iter().map(|(e, g)| {
            let [x, y] = [0, 1].map(|d| e[d] + z * g[d]);
            (x * cos + y * sin, [y * cos - x * sin, g[0] * cos + g[1] * sin])
        });
        let (reach, slopes) = reaches.reduce(|most, other| if other.0 > most.0 { other } else { most })?;
        let depth = self.film - self.clearance + reach;
        let slope = [slopes[0] / self.radius, slopes[1]];
        (depth > 0.0).then_some((Relief { depth, slope }, reach))
    }
}

impl Profile for Envelope {
    fn at(&self, position: [f64; 2]) -> Relief {
        self.wearing(position).map(|(relief, _)| relief).unwrap_or_default()
    }

    fn bends(&self, position: [f64; 2]) -> [f64; 2] {
        let reach = self.wearing(position).map_or(0.0, |(_, reach)| reach);
        [-reach / (self.radius * self.radius), 0.0]
    }

    fn finest(&self, _position: [f64; 2]) -> f64 {
        FINEST * self.radius
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_position_leaves_less_than_the_film() {
        let positions = vec![
            ([4.5e-5, 0.0], [0.0, 0.0]),
            ([4.0e-5, 1.0e-5], [3e-4, -1e-4]),
            ([4.0e-5, -0.5e-5], [-4e-4, 2e-4]),
        ];
        let envelope = Envelope {
            radius: 0.05,
            clearance: 5e-5,
            film: 8e-6,
            positions: positions.clone(),
        };
        let mut worn = 0;
        for i in 0..360 {
            for j in 0..=20 {
                let (x, z) = (0.05 * f64::from(i).to_radians(), 0.05 * (f64::from(j) / 20.0 - 0.5));
                let relief = envelope.at([x, z]);
                let (sin, cos) = (x / 0.05).sin_cos();
                let film = |(e, g): &([f64; 2], [f64; 2])| {
                    5e-5 - (e[0] + z * g[0]) * cos - (e[1] + z * g[1]) * sin + relief.depth
                };
                let least = positions.iter().map(film).fold(f64::INFINITY, f64::min);
                // Where it is worn one position leaves the film exactly.
                match relief.depth > 0.0 {
                    true => assert!((least - 8e-6).abs() < 1e-18, "{i} {j}"),
                    false => assert!(least >= 8e-6, "{i} {j}"),
                }
                worn += usize::from(relief.depth > 0.0);
            }
        }
        assert!((200..2000).contains(&worn), "{worn}");
    }
}
