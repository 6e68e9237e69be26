//! Numbers of a cycle: extremes and means over an orbit.

use oilwedge_reynolds::error_bar::Bar;

use super::cycle_view::{At, CycleView, ValueWithBar};
use super::row::{Headline, Measure::OverCycle, Row};
use super::rule::ErrorRule;
use super::{COOLING_FLOW, FRICTION_POWER, FRICTION_SHEAR_POWER, MOTION_POWER, PRESSURE_MAX, SIDE_FLOW};

rows! {
    /// `min h` over the liner and the cycle, between the steps of the orbit too
    CYCLE_FILM_THICKNESS_MIN = "cycle_film_thickness_min", "h_min", Metre, "least film thickness over the cycle":
        OverCycle(|cycle| { let (thinnest, time) = cycle.thinnest(); Some((thinnest.thickness, cycle.bar_of_thinnest(time))) }),
        ErrorRule::OverCycle(ORBIT), headline(Headline::Always(1));

    /// Crank angle at which the film is thinnest
    CYCLE_FILM_THICKNESS_MIN_CRANK_ANGLE = "cycle_film_thickness_min_crank_angle", "theta_h", Degree, "crank angle at which the film is thinnest":
        OverCycle(|cycle| Some(cycle.thinnest_crank_angle())),
        ErrorRule::OverCycle(PLACE), headline(Headline::Always(2));

    /// Angle of the thinnest film around the bearing
    CYCLE_FILM_THICKNESS_MIN_ANGLE = "cycle_film_thickness_min_angle", "phi_h", Degree, "where around the bearing the film is thinnest over the cycle":
        OverCycle(|cycle| Some(cycle.thinnest_angle())),
        ErrorRule::OverCycle(PLACE), headline(Headline::Always(3));

    /// `p_max` over the film and the cycle
    CYCLE_PRESSURE_MAX = "cycle_pressure_max", "p_max", Pascal, "greatest pressure over the cycle, gauge":
        OverCycle(|cycle| greatest(cycle, &PRESSURE_MAX)),
        ErrorRule::OverCycle(ORBIT), headline(Headline::Always(4));

    /// Crank angle of the greatest pressure
    CYCLE_PRESSURE_MAX_CRANK_ANGLE = "cycle_pressure_max_crank_angle", "theta_p", Degree, "crank angle at which the pressure is greatest":
        OverCycle(|cycle| cycle.greatest_crank_angle(&PRESSURE_MAX)),
        ErrorRule::OverCycle(PLACE), headline(Headline::Always(5));

    /// Greatest load over the cycle
    CYCLE_LOAD_MAX = "cycle_load_max", "W_max", Newton, "greatest load over the cycle":
        OverCycle(|cycle| Some((cycle.peak_load, Some(Bar::default())))),
        ErrorRule::Exact, headline(Headline::Always(6));

    /// Mean over the cycle of `P + P_e`: what turns the journal (nothing where it stands still) and what the load does
    /// on its centre, all of which the film turns into heat where no pressure is fed
    CYCLE_POWER_LOSS = "cycle_power_loss", "P_m", Watt, "mean power that the film turns into heat":
        OverCycle(|cycle| {
            let moving = mean(cycle, &MOTION_POWER)?;
            let turning = mean(cycle, &FRICTION_POWER).unwrap_or((0.0, Some(Bar::default())));
            Some((turning.0 + moving.0, turning.1.zip(moving.1).map(|(a, b)| a + b)))
        }),
        ErrorRule::OverCycle(MEAN), headline(Headline::Always(7));

    /// Mean over the cycle of `P = T omega`
    CYCLE_FRICTION_POWER = "cycle_friction_power", "P", Watt, "mean power that turns the journal":
        OverCycle(|cycle| mean(cycle, &FRICTION_POWER)),
        ErrorRule::OverCycle(MEAN), headline(Headline::Always(8));

    /// Greatest `P = T omega` of the cycle
    CYCLE_FRICTION_POWER_MAX = "cycle_friction_power_max", "P_max", Watt, "greatest power that turns the journal":
        OverCycle(|cycle| greatest(cycle, &FRICTION_POWER)),
        ErrorRule::OverCycle(ORBIT);

    /// Mean over the cycle of `P_s = Int mu U^2/h dA`
    CYCLE_FRICTION_SHEAR_POWER = "cycle_friction_shear_power", "P_s", Watt, "mean power against shear":
        OverCycle(|cycle| mean(cycle, &FRICTION_SHEAR_POWER)),
        ErrorRule::OverCycle(MEAN);

    /// Mean over the cycle of the oil that leaves at both ends
    CYCLE_SIDE_FLOW = "cycle_side_flow", "Q_s", CubicMetrePerSecond, "mean oil that leaves at both ends":
        OverCycle(|cycle| mean(cycle, &SIDE_FLOW)),
        ErrorRule::OverCycle(MEAN), headline(Headline::Always(9));

    /// `t_m`: one temperature for all films of the cycle, at which the mean flow carries off the mean of `P + P_e`;
    /// none without `[heat]`
    CYCLE_TEMPERATURE = "cycle_temperature", "t_m", Celsius, "temperature of the films, one for the cycle":
        OverCycle(|_| None),
        ErrorRule::OverCycle(BALANCED), only(|scope| scope.thermal.is_some()) headline(Headline::Always(10));

    /// `t_out = t_0 + 2 (1 + m)/(1 + 2 m) (t_m - t_0)`, m that of the mean flows; none without `[heat]`
    CYCLE_TEMPERATURE_OUTLET = "cycle_temperature_outlet", "t_out", Celsius, "of the oil that leaves the films":
        OverCycle(|_| None),
        ErrorRule::OverCycle(BALANCED), only(|scope| scope.thermal.is_some()) headline(Headline::Always(11));

    /// Mean over the cycle of the oil that leaves the film; none without `[heat]`
    CYCLE_COOLING_FLOW = "cycle_cooling_flow", "Q_out", CubicMetrePerSecond, "mean oil that leaves the film and cools it":
        OverCycle(|cycle| mean(cycle, &COOLING_FLOW)),
        ErrorRule::OverCycle(MEAN), only(|scope| scope.thermal.is_some());
}

pub(super) const ORBIT: &str = "that of the film there; the mesh's and the steps' errors of the orbit, carried along it by the film's stiffness and damping";
const MEAN: &str = "mean of the bars of the films, and of what the errors of the orbit make of them";
const BALANCED: &str = "those of mean power and flow, over the slope of their balance";
const PLACE: &str = "where the film or the pressure is within twice its bar of the extreme";

pub(super) fn greatest(cycle: &CycleView, row: &Row) -> Option<ValueWithBar> {
    let At { time, value } = cycle.greatest(row)?;
    Some((value, cycle.bar_at(row, time)))
}

fn mean(cycle: &CycleView, row: &Row) -> Option<ValueWithBar> {
    Some((cycle.mean(row)?, cycle.bar_of_mean(row)))
}
