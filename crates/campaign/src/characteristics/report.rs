//! The characteristics of a film as scripts read them: `characteristics.json`.

use oilwedge_scene::Scene;
use oilwedge_study::oil::Oil;
use oilwedge_study::result::{ResultHead, RunResult, Status};
use oilwedge_study::warning::Warning;
use serde::Serialize;

use super::fit::Fit;
use super::motion::JournalMotion;

/// Name and version of the form of `characteristics.json`.
pub const CHARACTERISTICS_FORMAT: &str = "oilwedge-characteristics/1";

/// What a film carries for each motion of its journal.
#[derive(Debug, Clone, Default, PartialEq, Serialize)]
pub struct Characteristics {
    /// Scene and program; `converged` where every film is, else which film is not, and why.
    #[serde(flatten)]
    pub head: ResultHead,
    /// Place of the journal; `None` where no position carries the load.
    pub journal: Option<JournalFacts>,
    /// What turns characteristics into forces and moments.
    pub units: Option<Units>,
    /// The motions: rotation, squeeze, tilt along and across the line of centres; none without a position.
    pub parts: Vec<MotionPart>,
    /// What the parts carry together at the rates of the scene; `None` where one of them has no film.
    pub sum: Option<ForceAndMoment>,
    /// What the film with all motions of the scene carries; `None` where there is no film.
    pub film: Option<ForceAndMoment>,
    /// Warnings about that film, in sentences.
    pub warnings: Vec<Warning>,
    /// The fit over straight bearings, where it is asked for.
    pub fit: Option<Fit>,
}

/// Where a journal is, in the frame of its line of centres.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct JournalFacts {
    /// Offset over the clearance [1].
    pub eccentricity: f64,
    /// Direction of the line of centres [deg].
    pub min_film_angle_deg: f64,
    /// Tilt along the line of centres, times R/c [1].
    pub gamma_x: f64,
    /// Tilt across it, towards growing angles, times R/c [1].
    pub gamma_y: f64,
    /// Length of the bearing over its diameter [1].
    pub slenderness: f64,
    /// Least film thickness over the clearance [1].
    pub least_film: f64,
}

/// What turns characteristics into forces and moments.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Units {
    /// `mu R^2/psi^2` [N s]: force for each 1/s of a rate.
    pub force: f64,
    /// `mu R^3/psi^2` [N m s]: moment for each 1/s of a rate.
    pub moment: f64,
}

/// One motion.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct MotionPart {
    /// Name of the motion.
    pub part: &'static str,
    /// Symbol and definition of its rate.
    pub rate_symbol: &'static str,
    /// Rate of the motion in the scene [1/s].
    pub rate: f64,
    /// Force and moment for a unit of the rate, of its sign [1]; `None` where there is no film.
    pub characteristics: Option<ForceAndMoment>,
    /// Force [N] and moment [N m] at the rate of the scene; `None` where there is no film.
    pub share: Option<ForceAndMoment>,
}

/// Force and moment along and across the line of centres.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct ForceAndMoment {
    /// Weight `cos`: force along the line of centres.
    pub force_along: NumberWithBar,
    /// Weight `sin`: force across it, towards growing angles.
    pub force_across: NumberWithBar,
    /// Weight `z cos`: parts of the force along, times their arms.
    pub moment_along: NumberWithBar,
    /// Weight `z sin`: parts of the force across, times their arms.
    pub moment_across: NumberWithBar,
}

/// A number with its error bar.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct NumberWithBar {
    /// The number.
    pub value: f64,
    /// Half the width of its error bar; `None` where there is none.
    pub error: Option<f64>,
    /// True where symmetry of the film makes it zero, exactly, whatever the mesh.
    pub zero_by_symmetry: bool,
}

impl Characteristics {
    /// The characteristics of a scene without any film yet.
    pub(super) fn of(scene: &Scene) -> Self {
        Self {
            head: ResultHead::of(CHARACTERISTICS_FORMAT, [&scene.title, &scene.text, &scene.sha256]),
            ..Self::default()
        }
    }

    /// Takes note of the first run that has not converged, by the name of its film.
    pub(super) fn note(&mut self, name: &str, result: &RunResult) {
        if self.head.status == Status::Converged && result.head.status != Status::Converged {
            self.head.status = result.head.status;
            self.head.reason = result.head.reason.as_ref().map(|reason| format!("{name}: {reason}"));
        }
    }

    /// How much stronger the sum of the parts is than the film: the ratio of their loads; `None` without both, or
    /// without a load.
    pub fn surplus(&self) -> Option<f64> {
        let (sum, film) = (self.sum?.load(), self.film?.load());
        (film > 0.0).then(|| sum / film)
    }
}

impl JournalFacts {
    pub(super) fn of(scene: &Scene, motion: &JournalMotion) -> Self {
        let b = scene.bearing.length / scene.bearing.diameter;
        let [gamma_x, gamma_y] = motion.gamma;
        let gap = |z: f64| 1.0 - (motion.eccentricity + z * gamma_x).hypot(z * gamma_y);
        Self {
            eccentricity: motion.eccentricity,
            min_film_angle_deg: motion.angle.to_degrees(),
            gamma_x,
            gamma_y,
            slenderness: b,
            least_film: gap(b).min(gap(-b)),
        }
    }
}

impl Units {
    pub(super) fn of(scene: &Scene) -> Self {
        let radius = scene.bearing.radius();
        let force = Oil::of(scene).viscosity * (radius * radius / scene.bearing.clearance).powi(2);
        Self { force, moment: force * radius }
    }
}

impl NumberWithBar {
    /// One that is zero by symmetry.
    const ZERO: Self = Self { value: 0.0, error: Some(0.0), zero_by_symmetry: true };
}

impl ForceAndMoment {
    /// What a film without pressure carries.
    pub(super) const ZERO: Self = Self {
        force_along: NumberWithBar::ZERO,
        force_across: NumberWithBar::ZERO,
        moment_along: NumberWithBar::ZERO,
        moment_across: NumberWithBar::ZERO,
    };

    /// Force and moment, each along and across.
    pub(super) fn new(
        [force_along, force_across]: [NumberWithBar; 2],
        [moment_along, moment_across]: [NumberWithBar; 2],
    ) -> Self {
        Self { force_along, force_across, moment_along, moment_across }
    }

    /// The four numbers, each changed by `number`, which is given its place too.
    fn each(&self, number: impl Fn(usize, NumberWithBar) -> NumberWithBar) -> Self {
        let [a, b, c, d] = self.numbers();
        Self::new([number(0, a), number(1, b)], [number(2, c), number(3, d)])
    }

    /// The four numbers: force along and across, moment along and across.
    pub fn numbers(&self) -> [NumberWithBar; 4] {
        [self.force_along, self.force_across, self.moment_along, self.moment_across]
    }

    /// Magnitude of the force.
    pub fn load(&self) -> f64 {
        self.force_along.value.hypot(self.force_across.value)
    }

    /// The numbers, some of which are zero by symmetry.
    pub(super) fn marked(self, zero: [bool; 4]) -> Self {
        self.each(|k, number| if zero[k] { NumberWithBar::ZERO } else { number })
    }

    /// Forces and moments times these factors.
    pub(super) fn scaled(&self, [force, moment]: [f64; 2]) -> Self {
        let by = [force, force, moment, moment];
        self.each(|k, number| NumberWithBar {
            value: by[k] * number.value,
            error: number.error.map(|error| by[k].abs() * error),
            ..number
        })
    }

    /// The sum of parts, if all are there.
    pub(super) fn sum(parts: impl Iterator<Item = Option<Self>>) -> Option<Self> {
        let parts: Vec<[NumberWithBar; 4]> = parts.map(|part| Some(part?.numbers())).collect::<Option<_>>()?;
        Some(Self::ZERO.each(|k, _| NumberWithBar {
            value: parts.iter().map(|part| part[k].value).sum(),
            error: parts.iter().map(|part| part[k].error).sum(),
            zero_by_symmetry: parts.iter().all(|part| part[k].zero_by_symmetry),
        }))
    }
}
