//! # Run-in bore: worn until no position of the journal leaves less than a given film
//!
//! **Equation.** `d = max(0, h_w - min_i h_i)`, `h_i = c - (e_i + z g_i).n`: at each angle the lines of the journal's
//! surface in its positions i have a lower envelope, a broken line along the axis, and the bore wears until it runs
//! parallel to it at the distance h_w.
//!
//! | symbol | unit | code |
//! |---|---|---|
//! | h_w | m | `film` |
//! | e_i, g_i | m, rad | `positions` |
//! | c, R | m | `clearance`, `radius` |
//!
//! **Source.** Zharov, Modelling of the tribosystem crankshaft - bearings - supports (dissertation, VNIIZhT Moscow,
//! 1996), the settled shape of a section, which wears at the same rate all along it.
//! **Range.** Positions of the journal that do not change as the bore wears. **Verified by**
//! `no_position_leaves_less_than_the_film` and `slopes_and_variations_match_differences`.
//!
//! **Which positions count.** In a sector of angles a position is left out where another one reaches as far at both of
//! its angles and both ends of the bearing: their difference `(e + z g).n` is linear in z and, within a sector narrower
//! than half a turn, a positive combination of its values at the two angles, so the other one reaches as far everywhere
//! between.
//!
//! **Edges.** The slope jumps at the edges of the worn place and where one position takes over from the next. With
//! positions close to each other, as those of an orbit, the second kind of jumps are a bend, and by the bend over
//! lengths that a film feels a mesh is graded for both.

use std::f64::consts::TAU;

use super::profile::{Profile, Relief};
use crate::Bearing;

/// Sectors in which positions are selected.
const SECTORS: usize = 180;
/// Second derivatives around are differences over so many radians.
const BEND_OVER: f64 = 0.15;
/// Second derivatives along the axis are differences over this part of the length.
const BEND_ALONG: f64 = 0.125;

/// A journal that wears its bore.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Wearing {
    /// Offset at mid-length [m].
    pub offset: [f64; 2],
    /// Slope of the axis [rad].
    pub tilt: [f64; 2],
}

impl Wearing {
    /// Offset at `z` [m].
    fn at(&self, z: f64) -> [f64; 2] {
        [0, 1].map(|d| self.offset[d] + z * self.tilt[d])
    }
}

/// A bore worn by a journal in several positions.
#[derive(Debug, Clone, PartialEq)]
pub struct Envelope {
    /// Radius R [m].
    radius: f64,
    /// Half of the length [m].
    half_length: f64,
    /// Film that is left less the radial clearance [m].
    film_less_clearance: f64,
    /// Positions that reach furthest somewhere in each sector.
    sectors: Vec<Vec<Wearing>>,
}

impl Envelope {
    /// The bore that journals in these positions leave, with this film [m] in each.
    pub fn new(bearing: &Bearing, film: f64, positions: &[Wearing]) -> Self {
        let half_length = 0.5 * bearing.length;
        let sector = |k: usize| {
            let angles = [k, k + 1].map(|k| TAU * k as f64 / SECTORS as f64);
            furthest(positions, angles, half_length)
        };
        Self {
            radius: bearing.radius,
            half_length,
            film_less_clearance: film - bearing.clearance,
            sectors: (0..SECTORS).map(sector).collect(),
        }
    }

    /// The wear at a place; negative where nothing is worn.
    fn wear(&self, [x, z]: [f64; 2]) -> Option<Relief> {
        let angle = x / self.radius;
        let (sin, cos) = angle.sin_cos();
        let sector = (angle / TAU).rem_euclid(1.0) * SECTORS as f64;
        let reach = |wearing: &Wearing| {
            let [x, y] = wearing.at(z);
            let [g_x, g_y] = wearing.tilt;
            (x * cos + y * sin, [y * cos - x * sin, g_x * cos + g_y * sin])
        };
        let reaches = self.sectors[(sector as usize).min(SECTORS - 1)].iter().map(reach);
        let (reach, [around, along]) = reaches.reduce(|most, other| if other.0 > most.0 { other } else { most })?;
        Some(Relief { depth: self.film_less_clearance + reach, slope: [around / self.radius, along] })
    }
}

/// The positions that reach furthest somewhere between two angles [rad], at most all along a bearing.
fn furthest(positions: &[Wearing], angles: [f64; 2], half_length: f64) -> Vec<Wearing> {
    let corners = |wearing: &Wearing| -> [f64; 4] {
        let reach = |angle: f64, z: f64| {
            let [x, y] = wearing.at(z);
            x * angle.cos() + y * angle.sin()
        };
        let [a, b] = angles;
        [reach(a, -half_length), reach(a, half_length), reach(b, -half_length), reach(b, half_length)]
    };
    let mut all: Vec<([f64; 4], Wearing)> = positions.iter().map(|it| (corners(it), *it)).collect();
    // A position is beaten by one with a greater sum alone.
    let sum = |corners: &[f64; 4]| corners.iter().sum::<f64>();
    all.sort_by(|a, b| sum(&b.0).total_cmp(&sum(&a.0)));
    let mut kept: Vec<([f64; 4], Wearing)> = Vec::new();
    for (corners, wearing) in all {
        let is_beaten = |(others, _): &([f64; 4], Wearing)| (0..4).all(|k| others[k] >= corners[k]);
        if !kept.iter().any(is_beaten) {
            kept.push((corners, wearing));
        }
    }
    kept.into_iter().map(|(_, wearing)| wearing).collect()
}

impl Profile for Envelope {
    fn at(&self, position: [f64; 2]) -> Relief {
        let worn = self.wear(position).filter(|relief| relief.depth > 0.0);
        worn.unwrap_or_default()
    }

    /// Differences over lengths that a film feels.
    fn bends(&self, [x, z]: [f64; 2]) -> [f64; 2] {
        let [over, along] = [BEND_OVER * self.radius, 2.0 * BEND_ALONG * self.half_length];
        // Beyond an end there is no bore.
        let room = (self.half_length - along).max(0.0);
        let z_within = z.clamp(-room, room);
        let depth = |x: f64, z: f64| self.at([x, z]).depth;
        [
            (depth(x + over, z) - 2.0 * depth(x, z) + depth(x - over, z)) / (over * over),
            (depth(x, z_within + along) - 2.0 * depth(x, z_within) + depth(x, z_within - along)) / (along * along),
        ]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Positions on a path around, with a slope that turns.
    fn path(count: u32) -> Vec<Wearing> {
        let wearing = |k: u32| {
            let a = TAU * f64::from(k) / f64::from(count);
            Wearing {
                offset: [3e-5 * a.cos() + 1e-5, 4.5e-5 * a.sin()],
                tilt: [3e-4 * (2.0 * a).sin(), 2e-4 * a.cos()],
            }
        };
        (0..count).map(wearing).collect()
    }

    #[test]
    fn few_positions_count_in_a_sector_and_they_are_those_that_reach_furthest() {
        let bearing = Bearing { radius: 0.05, length: 0.05, clearance: 5e-5, end_pressure: 0.0 };
        let positions = path(1000);
        let envelope = Envelope::new(&bearing, 8e-6, &positions);
        let most = envelope.sectors.iter().map(Vec::len).max().unwrap_or(0);
        assert!((1..200).contains(&most), "{most}");
        for k in 0..4000 {
            let (phi, z) = (0.01 * f64::from(k), 0.025 * (f64::from(k) * 0.37).sin());
            let reach = |it: &Wearing| it.at(z)[0] * phi.cos() + it.at(z)[1] * phi.sin();
            let all = positions.iter().map(reach).fold(f64::NEG_INFINITY, f64::max);
            let found = envelope.wear([0.05 * phi, z]).expect("a position").depth;
            assert!((found - (8e-6 - 5e-5 + all)).abs() < 1e-18, "{k}");
        }
    }

    #[test]
    fn no_position_leaves_less_than_the_film() {
        let wearing = |offset, tilt| Wearing { offset, tilt };
        let positions = [
            wearing([4.5e-5, 0.0], [0.0, 0.0]),
            wearing([4.0e-5, 1.0e-5], [3e-4, -1e-4]),
            wearing([4.0e-5, -0.5e-5], [-4e-4, 2e-4]),
        ];
        let bearing = Bearing { radius: 0.05, length: 0.05, clearance: 5e-5, end_pressure: 0.0 };
        let envelope = Envelope::new(&bearing, 8e-6, &positions);
        let mut worn = 0;
        for i in 0..360 {
            for j in 0..=20 {
                let (x, z) = (0.05 * f64::from(i).to_radians(), 0.05 * (f64::from(j) / 20.0 - 0.5));
                let relief = envelope.at([x, z]);
                let (sin, cos) = (x / 0.05).sin_cos();
                let film = |it: &Wearing| 5e-5 - it.at(z)[0] * cos - it.at(z)[1] * sin + relief.depth;
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
