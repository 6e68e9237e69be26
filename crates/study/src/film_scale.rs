//! The length over which a film changes, by which its mesh is graded: from the journal's position, its tilt, and the
//! profiles of the surfaces.
//!
//! **Equation.** Around: `0.65 sqrt(2 h/h_xx)`, over which the thickness doubles at its minimum; with tilt or slopes
//! along the axis also `0.65 h/|h_z|`, and with profiles `1.3 h/|h_x|` and `0.65 sqrt(2 h/h_zz)`; near a place where a
//! profile's slope jumps what the profile asks for. **Verified by** `tests/tests/shapes` and the convergence of all
//! graded meshes.

use oilwedge_reynolds::Bearing;

use crate::mesh_plan::MeshPlan;
use crate::position::Position;

/// Bounds of the scale, in radii.
pub(crate) const LONGEST: f64 = 0.6;
const SHORTEST: f64 = 0.01;
/// Longest edges of a mesh without a wanted size, over those that resolve the film's scale: two halvings.
const FINENESS: f64 = 0.25;
/// Edges along the axis, at least, of a mesh without a wanted size.
const ACROSS: f64 = 4.0;
/// The scale over the length in which the film doubles.
const PART: f64 = 0.65;
/// Edges of the mesh of an orbit, over those of a film at rest at its greatest eccentricity: the film is thinnest for a
/// moment only, and at one place.
const ON_ORBIT: f64 = 2.0;

/// Longest edges [m] of a mesh without a wanted size, in a bearing of this radius [m] and length [m].
pub(crate) fn needed_size(radius: f64, length: f64) -> f64 {
    (FINENESS * LONGEST * radius).min(length / ACROSS)
}

/// The scale of a film.
pub(crate) struct FilmScale<'a> {
    plan: &'a MeshPlan,
    position: Position,
}

impl<'a> FilmScale<'a> {
    /// The scale of a film with the journal at `position`.
    pub(crate) fn of(plan: &'a MeshPlan, position: Position) -> Self {
        Self { plan, position }
    }

    /// Scale [radii] at `(x, z)` [m].
    pub(crate) fn at(&self, [x, z]: [f64; 2]) -> f64 {
        let Bearing { radius, clearance, .. } = self.plan.bearing;
        let scale = match (self.plan.is_of_orbit, self.plan.profiles.is_empty()) {
            (true, true) => self.on_orbit(),
            (true, false) => self.on_orbit().min(self.by_profiles([x, z])),
            (false, true) => around(self.position.at(z, clearance), x / radius).min(self.along_by_tilt([x, z])),
            (false, false) => self.by_profiles([x, z]),
        };
        match self.plan.touching {
            None => scale,
            Some(touching) => scale.min(self.by_contact([x, z], touching)),
        }
    }

    /// Scale of the zone in which surfaces touch: over which the gap grows from its least by the scale of the law of
    /// contact.
    fn by_contact(&self, [x, z]: [f64; 2], touching: f64) -> f64 {
        /// Gaps within which surfaces carry by contact, in scales of its law.
        const IN_CONTACT: f64 = 4.0;
        let Bearing { radius, clearance, .. } = self.plan.bearing;
        let here = self.position.at(z, clearance);
        let circles = clearance * (1.0 - here.eccentricity * (x / radius - here.min_film_angle).cos());
        let thickness = (self.plan.profiles.iter()).fold(circles, |sum, profile| sum + profile.at([x, z]).depth);
        match thickness < IN_CONTACT * touching && !self.plan.is_of_orbit {
            true => (PART * (2.0 * touching / clearance).sqrt()).clamp(SHORTEST, LONGEST),
            false => LONGEST,
        }
    }

    /// The least scale [radii] all along the axis.
    pub(crate) fn all_along(&self, x: f64) -> f64 {
        let half = 0.5 * self.plan.bearing.length;
        let at_ends = self.at([x, -half]).min(self.at([x, half]));
        match self.plan.profiles.is_empty() {
            true => at_ends,
            false => at_ends.min(self.at([x, 0.0])),
        }
    }

    /// Scale that resolves the film all around, which is thinnest at one place after the other.
    fn on_orbit(&self) -> f64 {
        (ON_ORBIT * around(self.position, self.position.min_film_angle)).min(LONGEST)
    }

    /// True of steady films between circles that do not touch, of a tilted journal: they change around, and along the
    /// axis, by lengths of their own.
    pub(crate) fn has_two_scales(&self) -> bool {
        let plan = self.plan;
        let is_between_circles = plan.profiles.is_empty() && plan.touching.is_none() && !plan.is_of_orbit;
        is_between_circles && self.position.tilt != [0.0; 2]
    }

    /// The least scale [radii] around, all along the axis.
    pub(crate) fn around_all_along(&self, x: f64) -> f64 {
        if !self.has_two_scales() {
            return self.all_along(x);
        }
        let Bearing { radius, length, clearance, .. } = self.plan.bearing;
        let half = 0.5 * length;
        let at = |z: f64| around(self.position.at(z, clearance), x / radius);
        at(-half).min(at(half))
    }

    /// Scale [radii] of a tilted journal's film along the axis.
    pub(crate) fn along_by_tilt(&self, [x, z]: [f64; 2]) -> f64 {
        let Bearing { radius, clearance, .. } = self.plan.bearing;
        let (sin, cos) = (x / radius).sin_cos();
        let [g_x, g_y] = self.position.tilt;
        let slope = (g_x * cos + g_y * sin).abs();
        let here = self.position.at(z, clearance);
        let thickness = clearance * (1.0 - here.eccentricity * (x / radius - here.min_film_angle).cos());
        (PART * thickness / (radius * slope)).clamp(SHORTEST, LONGEST)
    }

    /// Scale of a film between surfaces that are no circles.
    fn by_profiles(&self, [x, z]: [f64; 2]) -> f64 {
        let Bearing { radius, clearance, .. } = self.plan.bearing;
        let (sin, cos) = (x / radius).sin_cos();
        let [g_x, g_y] = self.position.tilt;
        let here = self.position.at(z, clearance);
        let (across, along) = (x / radius - here.min_film_angle).sin_cos();
        let mut thickness = clearance * (1.0 - here.eccentricity * along);
        let mut slopes = [here.eccentricity * clearance * across / radius, -(g_x * cos + g_y * sin)];
        let (mut bends, mut finest) = ([here.eccentricity * clearance / (radius * radius), 0.0], f64::INFINITY);
        for profile in &self.plan.profiles {
            let relief = profile.at([x, z]);
            thickness += relief.depth;
            let of_profile = profile.bends([x, z]);
            (0..2).for_each(|d| (slopes[d], bends[d]) = (slopes[d] + relief.slope[d], bends[d] + of_profile[d]));
            finest = finest.min(profile.finest([x, z]));
        }
        // An orbit passes through films of all thicknesses.
        let thickness = match self.plan.is_of_orbit {
            true => clearance,
            // Where the journal lies in the bore there is nothing to resolve.
            false if thickness <= 0.0 => return LONGEST,
            false => thickness,
        };
        let by_bends = bends.map(|bend| PART * (2.0 * thickness / bend.abs()).sqrt());
        let by_slopes = [2.0, 1.0].map(|times| PART * times * thickness);
        let by_slopes = (by_slopes[0] / slopes[0].abs()).min(by_slopes[1] / slopes[1].abs());
        let least = by_bends[0].min(by_bends[1]).min(by_slopes).min(finest);
        (least / radius).clamp(SHORTEST, LONGEST)
    }
}

/// Scale around at the angle `phi` [rad] of circular surfaces.
fn around(position: Position, phi: f64) -> f64 {
    let Position { eccentricity, min_film_angle, .. } = position;
    let thickness = 1.0 - eccentricity * (phi - min_film_angle).cos();
    (PART * (2.0 * thickness.max(0.0) / eccentricity).sqrt()).clamp(SHORTEST, LONGEST)
}
