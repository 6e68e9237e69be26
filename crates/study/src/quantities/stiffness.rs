//! Stiffness of the film: forces and moments by offsets and slopes of the journal.

use oilwedge_reynolds::error_bar::Bar;

use super::coefficients::{RULE, first, has_tilt, is_asked};
use super::row::{Measure::One, Table};
use super::rule::ErrorRule;
use super::view::View;
use crate::estimate::Estimate;

rows! {
    /// `K_xx = dW_x/de_x`: how the film answers to a journal that stands off its place a little, in bearing axes; the
    /// film pushes it back with `-K (e, g)`. At the temperature of the film, its cavity held; with `jfo` at the first
    /// frequency of `dynamics.whirl`, by default in the limit of slow motions
    STIFFNESS_XX = "stiffness_xx", "K_xx", NewtonPerMetre, "change of W_x with e_x":
        One(|film| entry(film, 0, 0)), ErrorRule::Of(RULE, |estimate, _| bar(estimate, 0, 0)),
        in_table(Table::Dynamics) only(is_asked);

    /// `dW_x/de_y`, likewise
    STIFFNESS_XY = "stiffness_xy", "K_xy", NewtonPerMetre, "change of W_x with e_y":
        One(|film| entry(film, 0, 1)), ErrorRule::Of(RULE, |estimate, _| bar(estimate, 0, 1)),
        in_table(Table::Dynamics) only(is_asked);

    /// `dW_x/dg_x`, likewise
    STIFFNESS_X_GX = "stiffness_x_gx", "K_xgx", NewtonPerRadian, "change of W_x with g_x":
        One(|film| entry(film, 0, 2)), ErrorRule::Of(RULE, |estimate, _| bar(estimate, 0, 2)),
        in_table(Table::Dynamics) only(has_tilt);

    /// `dW_x/dg_y`, likewise
    STIFFNESS_X_GY = "stiffness_x_gy", "K_xgy", NewtonPerRadian, "change of W_x with g_y":
        One(|film| entry(film, 0, 3)), ErrorRule::Of(RULE, |estimate, _| bar(estimate, 0, 3)),
        in_table(Table::Dynamics) only(has_tilt);

    /// `dW_y/de_x`, likewise
    STIFFNESS_YX = "stiffness_yx", "K_yx", NewtonPerMetre, "change of W_y with e_x":
        One(|film| entry(film, 1, 0)), ErrorRule::Of(RULE, |estimate, _| bar(estimate, 1, 0)),
        in_table(Table::Dynamics) only(is_asked);

    /// `dW_y/de_y`, likewise
    STIFFNESS_YY = "stiffness_yy", "K_yy", NewtonPerMetre, "change of W_y with e_y":
        One(|film| entry(film, 1, 1)), ErrorRule::Of(RULE, |estimate, _| bar(estimate, 1, 1)),
        in_table(Table::Dynamics) only(is_asked);

    /// `dW_y/dg_x`, likewise
    STIFFNESS_Y_GX = "stiffness_y_gx", "K_ygx", NewtonPerRadian, "change of W_y with g_x":
        One(|film| entry(film, 1, 2)), ErrorRule::Of(RULE, |estimate, _| bar(estimate, 1, 2)),
        in_table(Table::Dynamics) only(has_tilt);

    /// `dW_y/dg_y`, likewise
    STIFFNESS_Y_GY = "stiffness_y_gy", "K_ygy", NewtonPerRadian, "change of W_y with g_y":
        One(|film| entry(film, 1, 3)), ErrorRule::Of(RULE, |estimate, _| bar(estimate, 1, 3)),
        in_table(Table::Dynamics) only(has_tilt);

    /// `dm_x/de_x`, likewise; N/rad is N m/m
    STIFFNESS_MX_X = "stiffness_mx_x", "K_mxx", NewtonPerRadian, "change of m_x with e_x":
        One(|film| entry(film, 2, 0)), ErrorRule::Of(RULE, |estimate, _| bar(estimate, 2, 0)),
        in_table(Table::Dynamics) only(has_tilt);

    /// `dm_x/de_y`, likewise
    STIFFNESS_MX_Y = "stiffness_mx_y", "K_mxy", NewtonPerRadian, "change of m_x with e_y":
        One(|film| entry(film, 2, 1)), ErrorRule::Of(RULE, |estimate, _| bar(estimate, 2, 1)),
        in_table(Table::Dynamics) only(has_tilt);

    /// `dm_x/dg_x`, likewise
    STIFFNESS_MX_GX = "stiffness_mx_gx", "K_mxgx", NewtonMetrePerRadian, "change of m_x with g_x":
        One(|film| entry(film, 2, 2)), ErrorRule::Of(RULE, |estimate, _| bar(estimate, 2, 2)),
        in_table(Table::Dynamics) only(has_tilt);

    /// `dm_x/dg_y`, likewise
    STIFFNESS_MX_GY = "stiffness_mx_gy", "K_mxgy", NewtonMetrePerRadian, "change of m_x with g_y":
        One(|film| entry(film, 2, 3)), ErrorRule::Of(RULE, |estimate, _| bar(estimate, 2, 3)),
        in_table(Table::Dynamics) only(has_tilt);

    /// `dm_y/de_x`, likewise
    STIFFNESS_MY_X = "stiffness_my_x", "K_myx", NewtonPerRadian, "change of m_y with e_x":
        One(|film| entry(film, 3, 0)), ErrorRule::Of(RULE, |estimate, _| bar(estimate, 3, 0)),
        in_table(Table::Dynamics) only(has_tilt);

    /// `dm_y/de_y`, likewise
    STIFFNESS_MY_Y = "stiffness_my_y", "K_myy", NewtonPerRadian, "change of m_y with e_y":
        One(|film| entry(film, 3, 1)), ErrorRule::Of(RULE, |estimate, _| bar(estimate, 3, 1)),
        in_table(Table::Dynamics) only(has_tilt);

    /// `dm_y/dg_x`, likewise
    STIFFNESS_MY_GX = "stiffness_my_gx", "K_mygx", NewtonMetrePerRadian, "change of m_y with g_x":
        One(|film| entry(film, 3, 2)), ErrorRule::Of(RULE, |estimate, _| bar(estimate, 3, 2)),
        in_table(Table::Dynamics) only(has_tilt);

    /// `dm_y/dg_y`, likewise
    STIFFNESS_MY_GY = "stiffness_my_gy", "K_mygy", NewtonMetrePerRadian, "change of m_y with g_y":
        One(|film| entry(film, 3, 3)), ErrorRule::Of(RULE, |estimate, _| bar(estimate, 3, 3)),
        in_table(Table::Dynamics) only(has_tilt);
}

fn entry(film: &View, row: usize, column: usize) -> Option<f64> {
    let of = first(film)?;
    (row.max(column) < of.order).then(|| of.stiffness[row][column])
}

fn bar(estimate: &dyn Estimate, row: usize, column: usize) -> Option<Bar> {
    let errors = estimate.coefficients()?;
    Some(Bar::of(errors.bar(|part| Some(part.stiffness[row][column]))?))
}
