//! The load over a cycle that a scene describes: its tables are read, and numbers become a [`DutyCycle`].

use oilwedge_bearing::duty_cycle::{
    Crank, GasPressure, Harmonic, Linkage, LoadPoint, NoSpline, PressureCurve, Throw, Turning,
};
pub use oilwedge_bearing::duty_cycle::{Duty, DutyCycle, ForceAxes, PeriodicSpline, RowsSummary, Summary};
use oilwedge_scene::periodic_table::{TableError, read_loads, read_pressures};
use oilwedge_scene::wording::degrees;
use oilwedge_scene::{CrankBearing, CrankDrive, Gas, LoadCycle, LoadFrame, LoadSource, Scene};

use crate::compile_error::CompileError;

/// Why a scene has no load over a cycle, though it is well written.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum NoDuty {
    /// A table cannot be used.
    #[error(transparent)]
    Table(#[from] TableError),
    /// No curve leads through the points of a table.
    #[error("no periodic curve leads through the rows of the table: {0}")]
    Spline(#[from] NoSpline),
    /// Numbers are too large.
    #[error("the load is not a finite number at the crank angle {}; correct the forces, masses or pressures", degrees(*angle))]
    NotFinite {
        /// Crank angle [rad].
        angle: f64,
    },
}

/// Number of angles of a period at which it is checked that a load is finite.
const CHECKED: u32 = 1440;
/// Crank angle [rad] of a cycle of a load that does not change: two turns.
const CYCLE: f64 = 2.0 * std::f64::consts::TAU;

/// The load over a cycle of a scene; `None`: its load does not change, or it has none.
///
/// # Errors
/// [`NoDuty`]: a table cannot be read or is no table of one period, or the load is not finite.
pub fn duty_cycle(scene: &Scene) -> Result<Option<DutyCycle>, NoDuty> {
    let Some(load) = &scene.load_cycle else { return Ok(None) };
    let cycle = of_load(load, scene.crank.as_ref(), scene.journal.speed)?.acting_at(scene.load_at.unwrap_or(0.0));
    let cycle = match load.frequency {
        Some(frequency) => cycle.at_frequency(frequency),
        None => cycle,
    };
    let angles = (0..CHECKED).map(|k| load.period * f64::from(k) / f64::from(CHECKED));
    let is_finite = |angle: f64| {
        let Duty { force, moment, speed } = cycle.at(angle);
        force.into_iter().chain(moment).chain([speed]).all(f64::is_finite)
    };
    match angles.into_iter().find(|&angle| !is_finite(angle)) {
        Some(angle) => Err(NoDuty::NotFinite { angle }),
        None => Ok(Some(cycle)),
    }
}

/// The load over a cycle of a scene with an orbit, be it constant.
///
/// # Errors
/// The load cannot be computed, or has a moment though the tilt is given.
pub(crate) fn load_of_orbit(scene: &Scene) -> Result<DutyCycle, CompileError> {
    let Some(cycle) = duty_cycle(scene).map_err(|reason| CompileError::Duty(reason.to_string()))? else {
        let duty = Duty {
            force: scene.journal.load().unwrap_or_default(),
            moment: scene.load_moment.unwrap_or_default(),
            speed: scene.journal.speed,
        };
        let constant = DutyCycle::constant(duty, CYCLE, scene.journal.speed.abs());
        return Ok(constant.acting_at(scene.load_at.unwrap_or(0.0)));
    };
    let has_moment = |k: u32| cycle.at(cycle.period() * f64::from(k) / f64::from(CHECKED)).moment != [0.0; 2];
    match scene.tilting() {
        None if (0..CHECKED).any(has_moment) => Err(CompileError::UnusedMoment),
        _ => Ok(cycle),
    }
}

fn of_load(load: &LoadCycle, crank: Option<&oilwedge_scene::CrankTable>, speed: f64) -> Result<DutyCycle, NoDuty> {
    let period = load.period;
    let rod = crank.map(|crank| Linkage { radius: crank.radius, rod_length: crank.rod_length });
    let turning = Turning { speed, rod };
    Ok(match &load.source {
        LoadSource::File { path, frame } => {
            let rows = read_loads(path, period)?.into_iter();
            let point = rows.map(|row| LoadPoint { angle: row.angle, force: row.force, moment: row.moment });
            DutyCycle::of_table(&point.collect::<Vec<_>>(), period, axes(*frame), turning)?
        }
        LoadSource::Harmonics { orders, frame } => {
            let of_force = |[x, y]: [f64; 2]| [x, y, 0.0, 0.0];
            let harmonic = orders.iter().map(|harmonic| Harmonic {
                order: harmonic.order,
                cos: of_force(harmonic.cos),
                sin: of_force(harmonic.sin),
            });
            DutyCycle::of_harmonics(harmonic.collect(), period, axes(*frame), turning)
        }
        LoadSource::Crank(bearing) => {
            // A computed load without a crank is refused with the scene.
            let given = crank.ok_or(NoDuty::NotFinite { angle: 0.0 })?;
            let drive = crank_of(given, period)?;
            match bearing {
                CrankBearing::BigEnd => DutyCycle::of_big_end(drive, speed),
                CrankBearing::Main => DutyCycle::of_main(drive, throws(given.drive.as_ref()), speed),
            }
        }
    })
}

/// The crank drive of a scene whose gas pressure has this period [rad].
///
/// # Errors
/// [`NoDuty`]: the table of the gas pressure cannot be used; or there is no drive.
pub(crate) fn crank_of(given: &oilwedge_scene::CrankTable, period: f64) -> Result<Crank, NoDuty> {
    let linkage = Linkage { radius: given.radius, rod_length: given.rod_length };
    let drive = given.drive.as_ref().ok_or(NoDuty::NotFinite { angle: 0.0 })?;
    crank(drive, linkage, period)
}

fn throws(drive: Option<&CrankDrive>) -> Vec<Throw> {
    let throw =
        |throw: &oilwedge_scene::ThrowTable| Throw { angle: throw.angle, share: throw.share, web_mass: throw.web_mass };
    drive.into_iter().flat_map(|drive| &drive.throws).map(throw).collect()
}

fn crank(drive: &CrankDrive, linkage: Linkage, period: f64) -> Result<Crank, NoDuty> {
    let gas = match &drive.gas {
        Gas::Peak { peak, angle, sharpness } => {
            GasPressure::Curve(PressureCurve { peak: *peak, angle: *angle, sharpness: *sharpness, period })
        }
        Gas::File(path) => {
            let (angles, pressures) =
                (read_pressures(path, period)?.into_iter()).map(|[angle, pressure]| (angle, [pressure])).unzip();
            GasPressure::Table(PeriodicSpline::new(angles, pressures, period)?.within_points(), period)
        }
    };
    Ok(Crank {
        linkage,
        reciprocating_mass: drive.reciprocating_mass,
        rotating_mass: drive.rotating_mass,
        bore: drive.bore,
        gas,
    })
}

fn axes(frame: LoadFrame) -> ForceAxes {
    match frame {
        LoadFrame::Shell => ForceAxes::Shell,
        LoadFrame::Cylinder => ForceAxes::Cylinder,
        LoadFrame::Pin => ForceAxes::Pin,
    }
}
