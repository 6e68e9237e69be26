//! # Beams in space: how a piece of a shaft resists the motions of its ends
//!
//! **Equation.** A beam along the axis t of a frame (a, b, t) with one end held bends under a force P and a moment M at
//! the other one, in the plane of a and t, as
//! ```text
//! u_a = P (L^3/(3 E I_a) + L/(G A_a)) + M L^2/(2 E I_a),     theta_b = P L^2/(2 E I_a) + M L/(E I_a)
//! ```
//! and in that of b and t likewise with -theta_a; along and about its axis `u_t = P L/(E A)`, `theta_t = M L/(G J)`.
//! The inverse is the stiffness of that end. A rigid arm r from a node to the end makes the motion of the end
//! `u + theta x r`, and so does the beam itself, held as a rigid body, for the motion of its other end: the energy is
//! that of the difference of both.
//!
//! | symbol | unit | code |
//! |---|---|---|
//! | E, G | Pa | [`Material`] |
//! | A; I_a, I_b; J | m2; m4; m4 | [`Section::area`], [`Section::second_moments`], [`Section::torsion`] |
//! | A_a, A_b | 1 | [`Section::shear_factors`], over A |
//! | u, theta | m, rad | the first and last three entries of a motion |
//!
//! **Source.** S. P. Timoshenko, Phil. Mag. 41 (1921) 744; J. S. Przemieniecki, Theory of Matrix Structural Analysis,
//! 1968, ch. 5; shear factors: G. R. Cowper, J. Appl. Mech. 33 (1966) 335; torsion of rectangles: W. C. Young, Roark's
//! Formulas for Stress and Strain, 1989, table 20. **Range.** Small strains; straight beams of one section; no warping.
//! Without a shear modulus the beam of Euler and Bernoulli: rigid in shear, and in torsion as if G were E.
//! **Verified by** the tests below and of `shaft/frame.rs`.

use std::f64::consts::PI;

/// A point or a vector [m].
pub type Point = [f64; 3];
/// Displacement [m] and rotation [rad] of a node, or force [N] and moment [N m] on it.
pub type NodeMotion = [f64; 6];

/// What a shaft is made of.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Material {
    /// Young's modulus E [Pa].
    pub youngs_modulus: f64,
    /// Shear modulus G [Pa]; `None`: beams do not shear.
    pub shear_modulus: Option<f64>,
}

/// The section of a beam; lists are for displacements towards the first and the second axis of the section.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Section {
    /// Area A [m2].
    pub area: f64,
    /// Second moments of area I [m4] that resist bending towards each axis.
    pub second_moments: [f64; 2],
    /// Constant J of torsion [m4].
    pub torsion: f64,
    /// Part of the area that bears shear towards each axis [1].
    pub shear_factors: [f64; 2],
}

/// Displacement towards a goes with a rotation about b, towards b with one against a.
const PLANES: [(usize, usize, f64); 2] = [(0, 4, 1.0), (1, 3, -1.0)];

impl Material {
    /// Poisson's ratio [1]; 0.3 for a beam that does not shear.
    fn poissons_ratio(&self) -> f64 {
        self.shear_modulus.map_or(0.3, |shear| 0.5 * self.youngs_modulus / shear - 1.0)
    }

    /// A round section with a bore [m], which may be zero.
    pub fn round(&self, diameter: f64, bore: f64) -> Section {
        let nu = self.poissons_ratio();
        let square = (bore / diameter).powi(2);
        let hollow = (1.0 + square).powi(2);
        let shear = 6.0 * (1.0 + nu) * hollow / ((7.0 + 6.0 * nu) * hollow + (20.0 + 12.0 * nu) * square);
        let second = PI / 64.0 * (diameter.powi(4) - bore.powi(4));
        Section {
            area: 0.25 * PI * (diameter * diameter - bore * bore),
            second_moments: [second; 2],
            torsion: 2.0 * second,
            shear_factors: [shear; 2],
        }
    }

    /// A rectangle with these sides [m] along the first and the second axis.
    pub fn rectangle(&self, first: f64, second: f64) -> Section {
        let nu = self.poissons_ratio();
        let shear = 10.0 * (1.0 + nu) / (12.0 + 11.0 * nu);
        let (long, short) = (first.max(second), first.min(second));
        let ratio = short / long;
        Section {
            area: first * second,
            second_moments: [second * first.powi(3) / 12.0, first * second.powi(3) / 12.0],
            torsion: long * short.powi(3) * (1.0 / 3.0 - 0.21 * ratio * (1.0 - ratio.powi(4) / 12.0)),
            shear_factors: [shear; 2],
        }
    }
}

/// A beam between two nodes, to which rigid arms may hold it.
#[derive(Debug, Clone, PartialEq)]
pub struct Beam {
    /// Numbers of its nodes.
    pub nodes: [usize; 2],
    /// Ends of the beam [m].
    pub ends: [Point; 2],
    /// First axis of its section, across the beam, of any length.
    pub first_axis: Point,
    /// Section of the beam.
    pub section: Section,
    /// What it is made of.
    pub material: Material,
}

impl Beam {
    /// The stiffness by the motions of both nodes, which stand at these points [m]: rows are forces.
    pub(super) fn stiffness(&self, nodes: [Point; 2]) -> [[f64; 12]; 12] {
        let [from, to] = self.ends;
        let local = self.at_end();
        let axes = self.axes();
        // The motion of the end against that which the beam would give it as a rigid body, in the frame of the beam.
        let mut relative = [[0.0; 12]; 6];
        for column in 0..12 {
            let mut unit = [0.0; 6];
            unit[column % 6] = 1.0;
            let node = column / 6;
            let moved = carried(unit, between(nodes[node], to));
            let sign = if node == 0 { -1.0 } else { 1.0 };
            for k in 0..3 {
                relative[k][column] = sign * dot(axes[k], [moved[0], moved[1], moved[2]]);
                relative[k + 3][column] = sign * dot(axes[k], [moved[3], moved[4], moved[5]]);
            }
        }
        debug_assert!(dot(between(from, to), axes[2]) > 0.0);
        let forces = local.map(|row| -> [f64; 12] {
            std::array::from_fn(|column| (0..6).map(|k| row[k] * relative[k][column]).sum())
        });
        std::array::from_fn(|i| std::array::from_fn(|j| (0..6).map(|k| relative[k][i] * forces[k][j]).sum()))
    }

    /// Where its section at this part of its length lies [m], and how that moves with its nodes, which stand at these
    /// points.
    pub(super) fn section_at(&self, part: f64, nodes: [Point; 2], motions: [NodeMotion; 2]) -> (Point, NodeMotion) {
        let [from, to] = self.ends;
        let (axes, span) = (self.axes(), between(from, to));
        let [held, moved] = [0, 1].map(|k: usize| carried(motions[k], between(nodes[k], self.ends[k])));
        let rigid = carried(held, span);
        let difference: NodeMotion = std::array::from_fn(|k| moved[k] - rigid[k]);
        // In the frame of the beam.
        let relative = axes.map(|axis| dot(axis, [difference[0], difference[1], difference[2]]));
        let turned = axes.map(|axis| dot(axis, [difference[3], difference[4], difference[5]]));
        let end: NodeMotion = [relative[0], relative[1], relative[2], turned[0], turned[1], turned[2]];
        let force = self.at_end().map(|row| (0..6).map(|k| row[k] * end[k]).sum::<f64>());
        let length = dot(span, span).sqrt();
        let (along, rest) = (part * length, (1.0 - part) * length);
        let mut own = end.map(|it| part * it);
        for (towards, about, sign) in PLANES {
            let bending = self.material.youngs_modulus * self.section.second_moments[towards];
            let sheared = self
                .material
                .shear_modulus
                .map_or(0.0, |modulus| along / (modulus * self.section.shear_factors[towards] * self.section.area));
            let push = force[towards];
            let moment = sign * force[about] + rest * push;
            own[towards] =
                push * (along.powi(3) / (3.0 * bending) + sheared) + moment * along * along / (2.0 * bending);
            own[about] = sign * (push * along * along / (2.0 * bending) + moment * along / bending);
        }
        let at = span.map(|it| part * it);
        let rigid = carried(held, at);
        let back = |from: usize, k: usize| (0..3).map(|axis| axes[axis][k] * own[from + axis]).sum::<f64>();
        let motion = std::array::from_fn(|k| rigid[k] + back(k / 3 * 3, k % 3));
        ([0, 1, 2].map(|k| from[k] + at[k]), motion)
    }

    /// The frame (a, b, t) of the beam.
    fn axes(&self) -> [Point; 3] {
        let along = unit(between(self.ends[0], self.ends[1]));
        let off = dot(self.first_axis, along);
        let first = unit([0, 1, 2].map(|k| self.first_axis[k] - off * along[k]));
        [first, cross(along, first), along]
    }

    /// The stiffness of one end in the frame of the beam, the other one held.
    fn at_end(&self) -> [[f64; 6]; 6] {
        let span = between(self.ends[0], self.ends[1]);
        let length = dot(span, span).sqrt();
        let (section, material) = (&self.section, &self.material);
        let twisting = material.shear_modulus.unwrap_or(material.youngs_modulus);
        let mut local = [[0.0; 6]; 6];
        local[2][2] = material.youngs_modulus * section.area / length;
        local[5][5] = twisting * section.torsion / length;
        for (towards, about, sign) in PLANES {
            let bending = material.youngs_modulus * section.second_moments[towards];
            let shear = material.shear_modulus.map_or(0.0, |modulus| {
                12.0 * bending / (modulus * section.shear_factors[towards] * section.area * length * length)
            });
            let unit = bending / (length * (1.0 + shear));
            local[towards][towards] = 12.0 * unit / (length * length);
            local[towards][about] = -sign * 6.0 * unit / length;
            local[about][towards] = local[towards][about];
            local[about][about] = (4.0 + shear) * unit;
        }
        local
    }
}

/// The motion that a rigid arm gives its far end.
pub(super) fn carried([u, v, w, a, b, c]: NodeMotion, arm: Point) -> NodeMotion {
    let [x, y, z] = cross([a, b, c], arm);
    [u + x, v + y, w + z, a, b, c]
}

/// The vector from a point to another.
pub(super) fn between(from: Point, to: Point) -> Point {
    [0, 1, 2].map(|k| to[k] - from[k])
}

fn dot(a: Point, b: Point) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn cross(a: Point, b: Point) -> Point {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

fn unit(vector: Point) -> Point {
    let length = dot(vector, vector).sqrt();
    vector.map(|part| part / length)
}

#[cfg(test)]
mod tests {
    use super::*;

    const STEEL: Material = Material { youngs_modulus: 206e9, shear_modulus: Some(79e9) };

    fn beam(material: Material) -> Beam {
        Beam {
            nodes: [0, 1],
            ends: [[0.1, -0.2, 0.3], [0.4, 0.2, 0.5]],
            first_axis: [0.0, 0.0, 1.0],
            section: material.rectangle(0.03, 0.05),
            material,
        }
    }

    #[test]
    fn rigid_motions_cost_nothing_arms_or_not() {
        let beam = beam(STEEL);
        for nodes in [beam.ends, [[0.0, 0.0, 0.2], [0.7, -0.1, 0.5]]] {
            let stiffness = beam.stiffness(nodes);
            let scale = stiffness[0][0].abs();
            for motion in [[1.0, 2.0, 3.0, 0.0, 0.0, 0.0], [0.0, 0.5, 0.0, 0.3, -0.2, 0.4]] {
                let motions = nodes.map(|node| carried(motion, node));
                let both: Vec<f64> = motions.concat();
                for row in stiffness {
                    let force: f64 = row.iter().zip(&both).map(|(a, b)| a * b).sum();
                    assert!(force.abs() < 1e-13 * scale, "{force:e} of {scale:e}");
                }
            }
        }
    }

    #[test]
    fn the_stiffness_is_symmetric() {
        let stiffness = beam(STEEL).stiffness([[0.0; 3], [1.0, 0.0, 0.0]]);
        for (i, row) in stiffness.iter().enumerate() {
            for (j, entry) in row.iter().enumerate() {
                assert!((entry - stiffness[j][i]).abs() < 1e-14 * stiffness[0][0], "{i} {j}");
            }
        }
    }

    #[test]
    fn sections_are_those_of_handbooks() {
        let round = STEEL.round(0.06, 0.0);
        assert!((round.second_moments[0] / 6.361_725e-7 - 1.0).abs() < 1e-6);
        assert_eq!(round.torsion, 2.0 * round.second_moments[0]);
        // A thin tube bears shear with about half of its area.
        assert!((STEEL.round(0.06, 0.0599).shear_factors[0] - 0.53).abs() < 0.01);
        // A square: J = 0.1406 a^4 (Young).
        assert!((STEEL.rectangle(0.1, 0.1).torsion / 0.1406e-4 - 1.0).abs() < 2e-3);
        let rectangle = STEEL.rectangle(0.02, 0.1);
        assert!((rectangle.second_moments[0] - 0.1 * 8e-6 / 12.0).abs() < 1e-18);
    }
}
