//! Where the journal is and how it turns.

/// Position and rotation of the journal in the frame of the bearing.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct JournalState {
    /// Offset `(e_x, e_y)` of the journal's centre from the bearing's [m].
    pub offset: [f64; 2],
    /// Angular velocity `omega` [rad/s], positive towards growing `phi`.
    pub speed: f64,
}

impl JournalState {
    /// From the relative eccentricity `eps = |e|/c` and the angle `phi_min` [rad] of the minimum film.
    pub fn at_eccentricity(eccentricity: f64, min_film_angle: f64, clearance: f64, speed: f64) -> Self {
        let (sin, cos) = min_film_angle.sin_cos();
        let e = eccentricity * clearance;
        Self {
            offset: [e * cos, e * sin],
            speed,
        }
    }

    /// Angle [rad] of the minimum film, `atan2(e_y, e_x)`; zero for a centred journal.
    pub fn min_film_angle(&self) -> f64 {
        self.offset[1].atan2(self.offset[0])
    }

    /// Distance `|e|` of the centres [m].
    pub fn eccentricity(&self) -> f64 {
        self.offset[0].hypot(self.offset[1])
    }
}
