//! Stiffness and damping as scripts and rotor programs read them: whole matrices in two frames, and the stability of a
//! rotor.

use oilwedge_bearing::dynamics::{AtWhirl, Square, Whirling, depends_on_frequency, whirling};
use oilwedge_bearing::{Coefficients, Stability};
use serde::{Deserialize, Serialize};

use crate::film::Film;
use crate::measure::Measured;

/// How the film answers to small motions of the journal, at its temperature.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct DynamicsReport {
    /// Whether the coefficients depend on the frequency of the motion: a cavity conserves oil.
    pub depends_on_whirl: bool,
    /// Direction of the first axis of the frame along the load [deg]; `null` without a load.
    pub load_angle: Option<f64>,
    /// Arm of slopes and moments without dimension [m]: half of the bearing's length.
    pub arm: f64,
    /// The coefficients at each frequency asked for.
    pub coefficients: Vec<CoefficientReport>,
    /// Whether a rigid rotor on this bearing is stable.
    pub rotor: RotorReport,
}

/// Rows: W_x, W_y and, where the journal may tilt, m_x, m_y; columns: e_x, e_y, g_x, g_y or their rates.
pub type CoefficientMatrix = Vec<Vec<f64>>;

/// Stiffness and damping in one frame.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Pair {
    /// Stiffness.
    pub stiffness: CoefficientMatrix,
    /// Damping.
    pub damping: CoefficientMatrix,
}

/// Coefficients at one frequency.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct CoefficientReport {
    /// Frequency of the motion over the speed of the journal [1].
    pub whirl: f64,
    /// Coefficients in bearing axes [N/m, N/rad, N.m/rad, and these times s].
    #[serde(flatten)]
    pub in_bearing: Pair,
    /// Coefficients in axes along the load and 90 degrees on in the sense of rotation [N/m, N/rad, N.m/rad, and these
    /// times s]; `null` without a load.
    pub along_load: Option<Pair>,
    /// Coefficients without dimension, `K c/W` and `C c omega/W`; `null` without a load or at rest.
    pub without_dimension: Option<Pair>,
}

/// The rigid rotor whose journals stay parallel to themselves.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct RotorReport {
    /// Whether it is stable.
    pub stable: Stable,
    /// Frequency of the motion over the speed for which the coefficients that decide it hold [1].
    pub judged_at_whirl: f64,
    /// Mass at the threshold over `W/(c omega^2)` [1]; `null` where there is none.
    pub critical_mass_without_dimension: Option<f64>,
    /// Frequency of the whirl at the threshold [rad/s]; `null` where there is none.
    pub whirl_frequency: Option<f64>,
    /// Mass that the scene gives [kg].
    pub mass: Option<f64>,
    /// Frequency of the least damped whirl of a rotor of that mass [rad/s]; `null` where all its motions creep.
    pub damped_frequency: Option<f64>,
}

/// Whether a rotor is stable.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Stable {
    /// The rotor is stable with any mass.
    WithAnyMass,
    /// The rotor is stable below a critical mass.
    BelowCriticalMass,
    /// The rotor is stable with no mass.
    WithNoMass,
    /// Stability is not known.
    Undetermined,
}

impl DynamicsReport {
    /// The report of a film; `None` where dynamics is not asked for, or could not be computed.
    pub fn of(film: &Film, measured: &Measured) -> Option<Self> {
        let (asked, dynamics) = (film.model.sockets.dynamics.as_ref()?, measured.dynamics()?);
        let problem = &film.problem;
        let load = measured.load.magnitude();
        let frame = LoadAxes {
            load,
            angle: (load > 0.0).then(|| measured.load.angle()),
            speed: problem.journal.speed,
            clearance: problem.bearing.clearance,
            arm: 0.5 * problem.bearing.length,
        };
        let judged = &dynamics.judged;
        let threshold = match dynamics.stability {
            Stability::Below(threshold) => Some(threshold),
            Stability::Always | Stability::Never | Stability::Undetermined => None,
        };
        let unit = load / (frame.clearance * frame.speed * frame.speed);
        let damped: Option<Whirling> = asked.mass.and_then(|mass| whirling(&judged.coefficients, mass));
        Some(Self {
            depends_on_whirl: depends_on_frequency(problem),
            load_angle: frame.angle.map(|angle| angle.to_degrees().rem_euclid(360.0) % 360.0),
            arm: frame.arm,
            coefficients: dynamics.at.iter().map(|at| frame.report(at)).collect(),
            rotor: RotorReport {
                stable: match dynamics.stability {
                    Stability::Always => Stable::WithAnyMass,
                    Stability::Below(_) => Stable::BelowCriticalMass,
                    Stability::Never => Stable::WithNoMass,
                    Stability::Undetermined => Stable::Undetermined,
                },
                judged_at_whirl: judged.whirl,
                critical_mass_without_dimension: threshold
                    .map(|threshold| threshold.mass / unit)
                    .filter(|mass| mass.is_finite()),
                whirl_frequency: threshold.map(|threshold| threshold.frequency),
                mass: asked.mass,
                damped_frequency: damped.map(|whirling| whirling.frequency),
            },
        })
    }
}

/// What the frame along the load is made of.
struct LoadAxes {
    /// Magnitude of the load [N].
    load: f64,
    /// Direction of the load [rad], if there is one.
    angle: Option<f64>,
    /// Speed of the journal [rad/s].
    speed: f64,
    /// Clearance [m].
    clearance: f64,
    /// Half of the bearing's length [m].
    arm: f64,
}

impl LoadAxes {
    fn report(&self, at: &AtWhirl) -> CoefficientReport {
        let along = self.angle.map(|angle| at.coefficients.in_frame(angle, self.speed));
        let scaled = along.and_then(|along| along.without_dimension(self.load, self.clearance, self.speed, self.arm));
        CoefficientReport {
            whirl: at.whirl,
            in_bearing: Pair::of(&at.coefficients),
            along_load: along.as_ref().map(Pair::of),
            without_dimension: scaled.as_ref().map(Pair::of),
        }
    }
}

impl Pair {
    fn of(coefficients: &Coefficients) -> Self {
        let order = coefficients.order;
        let matrix = |of: &Square| of[..order].iter().map(|row| row[..order].to_vec()).collect();
        Self { stiffness: matrix(&coefficients.stiffness), damping: matrix(&coefficients.damping) }
    }
}
