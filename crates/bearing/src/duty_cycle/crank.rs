//! # Slider crank: the forces on the pin of the big end and on the main bearings
//!
//! **Equation.** In the frame of the cylinder, for a crank that turns from x to y, with the pin at
//! `r (cos theta, sin theta)`:
//! ```text
//! sin beta = lambda sin theta,   lambda = r/l,      beta' = lambda cos theta/cos beta
//! s = r cos theta + l cos beta   (small end),       v_p = omega s',   a_p = omega^2 s''
//! T = F_gas + m_p a_p,           F = (-T, T tan beta) + m_r r omega^2 (cos theta, sin theta)
//! ```
//! F is the force of the rod on the pin, primes are derivatives with respect to theta; no series in lambda. The power
//! balances at every angle: `F . v_pin + (F_gas + m_p a_p) v_p = 0`. The rod is two masses, at its eyes; that is exact
//! where its moment of inertia is m a b with the distances a, b of its centre of mass from the eyes. The piston has no
//! offset, and friction is left out.
//!
//! A crankshaft is cut at its main bearings: each throw rests on those beside it as a beam on two supports. With the
//! shares w of the throws beside it, whose cranks follow by the angles phi, a main bearing has the load
//! ```text
//! sum of w (F(theta - phi) + m_w r omega^2 (cos(theta - phi), sin(theta - phi)))
//! ```
//!
//! | symbol | unit | code |
//! |---|---|---|
//! | r, l | m | [`Linkage`] |
//! | m_p, m_r | kg | [`Crank::reciprocating_mass`], [`Crank::rotating_mass`] |
//! | w, phi, m_w | 1, rad, kg | [`Throw`] |
//! | F_gas | N | `gas_force` |
//! | theta, beta | rad | `angle`, `inclination` |
//! | omega | rad/s | `speed` |
//!
//! **Source.** C. F. Taylor, The Internal Combustion Engine in Theory and Practice, 1985, vol. 2, ch. 8 (exact forms
//! derived here). **Range.** lambda < 1.
//! **Verified by** `duty_cycle/tests.rs` and `tests/tests/duty_cycle.rs`.

use std::f64::consts::{PI, TAU};

use super::PeriodicSpline;

/// Crank and rod.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Linkage {
    /// Radius r of the crank [m], less than the length of the rod.
    pub radius: f64,
    /// Length l of the rod between its eyes [m].
    pub rod_length: f64,
}

impl Linkage {
    fn ratio(&self) -> f64 {
        self.radius / self.rod_length
    }

    /// Inclination beta of the rod against the axis of the cylinder [rad] at a crank angle [rad].
    pub fn inclination(&self, angle: f64) -> f64 {
        (self.ratio() * angle.sin()).asin()
    }

    /// Derivative of the inclination with respect to the crank angle [1].
    pub fn inclination_rate(&self, angle: f64) -> f64 {
        self.ratio() * angle.cos() / self.inclination(angle).cos()
    }

    /// First and second derivative of the place of the small end with respect to the crank angle [m].
    fn small_end(&self, angle: f64) -> [f64; 2] {
        let (sin, cos) = angle.sin_cos();
        let (sin_beta, cos_beta) = self.inclination(angle).sin_cos();
        let rate = self.inclination_rate(angle);
        let second = (sin_beta * rate * rate - self.ratio() * sin) / cos_beta;
        let first = -self.radius * sin - self.rod_length * sin_beta * rate;
        [first, -self.radius * cos - self.rod_length * (cos_beta * rate * rate + sin_beta * second)]
    }

    /// Velocity of the piston [m/s], away from the crank, at a crank angle [rad] and an angular speed [rad/s].
    pub fn piston_velocity(&self, angle: f64, speed: f64) -> f64 {
        speed * self.small_end(angle)[0]
    }

    /// Acceleration of the piston [m/s2], away from the crank, at a crank angle [rad] and an angular speed [rad/s].
    pub fn piston_acceleration(&self, angle: f64, speed: f64) -> f64 {
        speed * speed * self.small_end(angle)[1]
    }
}

/// Pressure on the piston [Pa] over that of the crankcase, by crank angle.
#[derive(Debug, Clone, PartialEq)]
pub enum GasPressure {
    /// One peak in a period.
    Curve(PressureCurve),
    /// A curve through the rows of a table and within them, with its period [rad].
    Table(PeriodicSpline<1>, f64),
}

/// `p(theta) = peak exp(sharpness (cos(2 pi (theta - angle)/period) - 1))`: one smooth peak in a period.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PressureCurve {
    /// Greatest pressure [Pa].
    pub peak: f64,
    /// Crank angle of the peak [rad].
    pub angle: f64,
    /// How narrow the peak is [1]; half of the peak is reached at `cos = 1 - ln 2/sharpness`.
    pub sharpness: f64,
    /// Period [rad].
    pub period: f64,
}

impl GasPressure {
    /// Period of the crank angle [rad].
    pub fn period(&self) -> f64 {
        match self {
            Self::Curve(curve) => curve.period,
            Self::Table(_, period) => *period,
        }
    }

    /// The pressure [Pa] at a crank angle [rad].
    pub fn at(&self, angle: f64) -> f64 {
        match self {
            Self::Curve(curve) => {
                let phase = TAU * (angle - curve.angle) / curve.period;
                curve.peak * (curve.sharpness * (phase.cos() - 1.0)).exp()
            }
            Self::Table(spline, _) => spline.at(angle)[0],
        }
    }
}

/// A crank with its masses and the pressure on its piston.
#[derive(Debug, Clone, PartialEq)]
pub struct Crank {
    /// Crank and rod.
    pub linkage: Linkage,
    /// Mass m_p [kg] of the piston with ring and pin, and of the rod's share at its small end.
    pub reciprocating_mass: f64,
    /// Mass m_r [kg] of the rod's share at its big end.
    pub rotating_mass: f64,
    /// Bore of the cylinder [m].
    pub bore: f64,
    /// Pressure on the piston.
    pub gas: GasPressure,
}

/// A throw beside a main bearing.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Throw {
    /// Crank angle by which it follows [rad]: its own angle is that of the crank less this one, and so is its gas
    /// pressure.
    pub angle: f64,
    /// Share of its load that the main bearing takes [1].
    pub share: f64,
    /// Unbalance of its webs, counterweights taken off, over the radius of the crank [kg].
    pub web_mass: f64,
}

impl Crank {
    /// Force of the gas on the piston [N], towards the crank, at a crank angle [rad].
    pub fn gas_force(&self, angle: f64) -> f64 {
        0.25 * PI * self.bore * self.bore * self.gas.at(angle)
    }

    /// Work of the gas on the piston over a period [J], by the trapezoidal rule with `steps` steps.
    pub fn gas_work(&self, steps: u32) -> f64 {
        let step = self.gas.period() / f64::from(steps);
        let angles = (0..steps).map(|k| step * f64::from(k));
        -step * angles.map(|angle| self.gas_force(angle) * self.linkage.piston_velocity(angle, 1.0)).sum::<f64>()
    }

    /// Force of the rod on the pin [N] in the frame of the cylinder, at a crank angle [rad] and an angular speed
    /// [rad/s].
    pub fn force_on_pin(&self, angle: f64, speed: f64) -> [f64; 2] {
        let thrust = self.gas_force(angle) + self.reciprocating_mass * self.linkage.piston_acceleration(angle, speed);
        let centrifugal = self.rotating_mass * self.linkage.radius * speed * speed;
        [centrifugal * angle.cos() - thrust, centrifugal * angle.sin() + thrust * self.linkage.inclination(angle).tan()]
    }

    /// Force of the throws on a main journal [N] in the frame of the cylinders, at a crank angle [rad] and an angular
    /// speed [rad/s].
    pub fn force_on_main(&self, throws: &[Throw], angle: f64, speed: f64) -> [f64; 2] {
        throws.iter().fold([0.0; 2], |[x, y], throw| {
            let own = angle - throw.angle;
            let [f_x, f_y] = self.force_on_pin(own, speed);
            let centrifugal = throw.web_mass * self.linkage.radius * speed * speed;
            [x + throw.share * (f_x + centrifugal * own.cos()), y + throw.share * (f_y + centrifugal * own.sin())]
        })
    }
}
