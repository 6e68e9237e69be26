//! A load given by a table.

use super::{ForceAxes, NoSpline, PeriodicSpline, Turning};

/// A row of a table of loads.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LoadPoint {
    /// Crank angle [rad].
    pub angle: f64,
    /// Force on the journal [N].
    pub force: [f64; 2],
    /// Moment on the journal [N m].
    pub moment: [f64; 2],
}

/// The curve through the points in the frame of the shell; limited so that no part of force or moment overshoots
/// ([`PeriodicSpline::within_points`]).
pub(super) fn spline(
    points: &[LoadPoint],
    period: f64,
    frame: ForceAxes,
    turning: &Turning,
) -> Result<PeriodicSpline<4>, NoSpline> {
    let in_shell = |point: &LoadPoint| {
        let [x, y] = turning.to_shell(point.force, frame, point.angle);
        let [m_x, m_y] = turning.to_shell(point.moment, frame, point.angle);
        [x, y, m_x, m_y]
    };
    let angles = points.iter().map(|point| point.angle).collect();
    let spline = PeriodicSpline::new(angles, points.iter().map(in_shell).collect(), period)?;
    Ok(spline.within_points())
}
