//! Place and motion of the journal.

/// Position, inclination, rotation and velocity of the journal in the frame of the bearing.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct JournalState {
    /// Offset `(e_x, e_y)` of the journal's centre from the bearing's at mid-length [m].
    pub offset: [f64; 2],
    /// Velocity `(e_x', e_y')` of the journal's centre at mid-length [m/s].
    pub velocity: [f64; 2],
    /// Slope `(g_x, g_y)` of the journal's axis against that of the bearing [rad]: the offset grows by it for each
    /// metre of z.
    pub tilt: [f64; 2],
    /// Rate `(g_x', g_y')` of that slope [rad/s].
    pub tilt_rate: [f64; 2],
    /// Angular velocity `omega` [rad/s], positive towards growing `phi`.
    pub speed: f64,
    /// Velocity [m/s] of the journal along its axis.
    pub axial_velocity: f64,
}

/// A small change of position and velocity, as equilibrium and dynamic coefficients ask for.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct JournalChange {
    /// Change of the offset [m].
    pub offset: [f64; 2],
    /// Change of the centre's velocity [m/s].
    pub velocity: [f64; 2],
    /// Change of the slope of the axis [rad].
    pub tilt: [f64; 2],
    /// Change of the rate of that slope [rad/s].
    pub tilt_rate: [f64; 2],
}

/// Coordinates of the place of a journal: its offset and the slope of its axis.
pub(crate) const COORDINATES: usize = 4;

impl JournalChange {
    /// A change by one of a coordinate of the place: e_x, e_y [m], g_x, g_y [rad].
    pub(crate) fn of_coordinate(number: usize) -> Self {
        let mut change = Self::default();
        match number {
            0 | 1 => change.offset[number] = 1.0,
            _ => change.tilt[number - 2] = 1.0,
        }
        change
    }

    /// What changes of each of these coordinates; none where the velocity changes too.
    pub(crate) fn of_place(&self) -> Option<[f64; COORDINATES]> {
        let is_still = [self.velocity, self.tilt_rate] == [[0.0; 2]; 2];
        let ([e_x, e_y], [g_x, g_y]) = (self.offset, self.tilt);
        is_still.then_some([e_x, e_y, g_x, g_y])
    }

    /// The change of place of this one as a rate [1/s]: velocity and rate of the slope change by what offset and slope
    /// did, which do not change.
    #[must_use]
    pub fn as_rate(&self) -> Self {
        Self { velocity: self.offset, tilt_rate: self.tilt, ..Self::default() }
    }
}

/// Velocity of the journal's centre [m/s] in the frame of the line of centres.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct CentreVelocity {
    /// Velocity along the line of centres, outwards.
    pub radial: f64,
    /// Velocity across the line of centres, towards growing angles.
    pub tangential: f64,
}

impl CentreVelocity {
    /// Magnitude [m/s].
    pub fn speed(&self) -> f64 {
        self.radial.hypot(self.tangential)
    }

    /// The change of a journal that moves by `step` [m]: the velocity turns with the line of centres.
    pub fn change(&self, journal: &JournalState, step: [f64; 2]) -> JournalChange {
        let e = journal.eccentricity();
        let velocity = match e > 0.0 {
            true => {
                let along = journal.offset.map(|x| x / e);
                let across = [-along[1], along[0]];
                let turn = (across[0] * step[0] + across[1] * step[1]) / e;
                [0, 1].map(|d| turn * (self.radial * across[d] - self.tangential * along[d]))
            }
            false => [0.0; 2],
        };
        JournalChange { offset: step, velocity, ..JournalChange::default() }
    }
}

impl JournalState {
    /// A journal at the relative eccentricity `eps = |e|/c` and the angle `phi_min` [rad] of the minimum film; the
    /// centre rests.
    pub fn at_eccentricity(eccentricity: f64, min_film_angle: f64, clearance: f64, speed: f64) -> Self {
        let (sin, cos) = min_film_angle.sin_cos();
        let e = eccentricity * clearance;
        Self { offset: [e * cos, e * sin], velocity: [0.0; 2], speed, ..Self::default() }
    }

    /// This position with the centre moving at `velocity`, where the line of centres points to the angle
    /// `min_film_angle` [rad].
    pub fn with_centre_velocity(self, velocity: CentreVelocity, min_film_angle: f64) -> Self {
        let CentreVelocity { radial, tangential } = velocity;
        let (sin, cos) = min_film_angle.sin_cos();
        Self { velocity: [radial * cos - tangential * sin, radial * sin + tangential * cos], ..self }
    }

    /// Angle [rad] of the minimum film, `atan2(e_y, e_x)`; zero for a centred journal.
    pub fn min_film_angle(&self) -> f64 {
        self.offset[1].atan2(self.offset[0])
    }

    /// Distance `|e|` of the centres at mid-length [m].
    pub fn eccentricity(&self) -> f64 {
        self.offset[0].hypot(self.offset[1])
    }

    /// Offset `e + z g` of the centre [m] at the axial position `z` [m].
    pub fn offset_at(&self, z: f64) -> [f64; 2] {
        [0, 1].map(|d| self.offset[d] + z * self.tilt[d])
    }

    /// True where the axes of journal and bearing are parallel.
    pub fn is_parallel(&self) -> bool {
        self.tilt == [0.0; 2]
    }

    /// True where neither the centre moves nor the axis turns.
    pub fn is_still(&self) -> bool {
        self.velocity == [0.0; 2] && self.tilt_rate == [0.0; 2]
    }

    /// Greatest speed [m/s] at which the film can grow or shrink within `half_length` [m] of mid-length.
    pub fn gap_speed(&self, half_length: f64) -> f64 {
        let [[v_x, v_y], [w_x, w_y]] = [self.velocity, self.tilt_rate];
        v_x.hypot(v_y) + half_length * w_x.hypot(w_y)
    }

    /// The journal after a `change`.
    pub fn changed(&self, change: &JournalChange) -> Self {
        let sum = |a: [f64; 2], b: [f64; 2]| [0, 1].map(|d| a[d] + b[d]);
        Self {
            offset: sum(self.offset, change.offset),
            velocity: sum(self.velocity, change.velocity),
            tilt: sum(self.tilt, change.tilt),
            tilt_rate: sum(self.tilt_rate, change.tilt_rate),
            ..*self
        }
    }
}
