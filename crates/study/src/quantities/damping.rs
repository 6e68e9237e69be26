//! Damping of the film: forces and moments by the rates of offsets and slopes of the journal.

use oilwedge_reynolds::error_bar::Bar;

use super::coefficients::{RULE, first, has_tilt, is_asked};
use super::row::{Measure::One, Table};
use super::rule::ErrorRule;
use super::view::View;
use crate::estimate::Estimate;

rows! {
    /// `C_xx = dW_x/de_x'`: how the film answers to a journal that moves a little, `-C (e', g')` on the journal;
    /// likewise, and with `jfo` with what the cavity takes up
    DAMPING_XX = "damping_xx", "C_xx", NewtonSecondPerMetre, "change of W_x with e_x'":
        One(|film| entry(film, 0, 0)), ErrorRule::Of(RULE, |estimate, _| bar(estimate, 0, 0)),
        in_table(Table::Dynamics) only(is_asked);

    /// `dW_x/de_y'`, likewise
    DAMPING_XY = "damping_xy", "C_xy", NewtonSecondPerMetre, "change of W_x with e_y'":
        One(|film| entry(film, 0, 1)), ErrorRule::Of(RULE, |estimate, _| bar(estimate, 0, 1)),
        in_table(Table::Dynamics) only(is_asked);

    /// `dW_x/dg_x'`, likewise
    DAMPING_X_GX = "damping_x_gx", "C_xgx", NewtonSecondPerRadian, "change of W_x with g_x'":
        One(|film| entry(film, 0, 2)), ErrorRule::Of(RULE, |estimate, _| bar(estimate, 0, 2)),
        in_table(Table::Dynamics) only(has_tilt);

    /// `dW_x/dg_y'`, likewise
    DAMPING_X_GY = "damping_x_gy", "C_xgy", NewtonSecondPerRadian, "change of W_x with g_y'":
        One(|film| entry(film, 0, 3)), ErrorRule::Of(RULE, |estimate, _| bar(estimate, 0, 3)),
        in_table(Table::Dynamics) only(has_tilt);

    /// `dW_y/de_x'`, likewise
    DAMPING_YX = "damping_yx", "C_yx", NewtonSecondPerMetre, "change of W_y with e_x'":
        One(|film| entry(film, 1, 0)), ErrorRule::Of(RULE, |estimate, _| bar(estimate, 1, 0)),
        in_table(Table::Dynamics) only(is_asked);

    /// `dW_y/de_y'`, likewise
    DAMPING_YY = "damping_yy", "C_yy", NewtonSecondPerMetre, "change of W_y with e_y'":
        One(|film| entry(film, 1, 1)), ErrorRule::Of(RULE, |estimate, _| bar(estimate, 1, 1)),
        in_table(Table::Dynamics) only(is_asked);

    /// `dW_y/dg_x'`, likewise
    DAMPING_Y_GX = "damping_y_gx", "C_ygx", NewtonSecondPerRadian, "change of W_y with g_x'":
        One(|film| entry(film, 1, 2)), ErrorRule::Of(RULE, |estimate, _| bar(estimate, 1, 2)),
        in_table(Table::Dynamics) only(has_tilt);

    /// `dW_y/dg_y'`, likewise
    DAMPING_Y_GY = "damping_y_gy", "C_ygy", NewtonSecondPerRadian, "change of W_y with g_y'":
        One(|film| entry(film, 1, 3)), ErrorRule::Of(RULE, |estimate, _| bar(estimate, 1, 3)),
        in_table(Table::Dynamics) only(has_tilt);

    /// `dm_x/de_x'`, likewise; N/rad is N m/m
    DAMPING_MX_X = "damping_mx_x", "C_mxx", NewtonSecondPerRadian, "change of m_x with e_x'":
        One(|film| entry(film, 2, 0)), ErrorRule::Of(RULE, |estimate, _| bar(estimate, 2, 0)),
        in_table(Table::Dynamics) only(has_tilt);

    /// `dm_x/de_y'`, likewise
    DAMPING_MX_Y = "damping_mx_y", "C_mxy", NewtonSecondPerRadian, "change of m_x with e_y'":
        One(|film| entry(film, 2, 1)), ErrorRule::Of(RULE, |estimate, _| bar(estimate, 2, 1)),
        in_table(Table::Dynamics) only(has_tilt);

    /// `dm_x/dg_x'`, likewise
    DAMPING_MX_GX = "damping_mx_gx", "C_mxgx", NewtonMetreSecondPerRadian, "change of m_x with g_x'":
        One(|film| entry(film, 2, 2)), ErrorRule::Of(RULE, |estimate, _| bar(estimate, 2, 2)),
        in_table(Table::Dynamics) only(has_tilt);

    /// `dm_x/dg_y'`, likewise
    DAMPING_MX_GY = "damping_mx_gy", "C_mxgy", NewtonMetreSecondPerRadian, "change of m_x with g_y'":
        One(|film| entry(film, 2, 3)), ErrorRule::Of(RULE, |estimate, _| bar(estimate, 2, 3)),
        in_table(Table::Dynamics) only(has_tilt);

    /// `dm_y/de_x'`, likewise
    DAMPING_MY_X = "damping_my_x", "C_myx", NewtonSecondPerRadian, "change of m_y with e_x'":
        One(|film| entry(film, 3, 0)), ErrorRule::Of(RULE, |estimate, _| bar(estimate, 3, 0)),
        in_table(Table::Dynamics) only(has_tilt);

    /// `dm_y/de_y'`, likewise
    DAMPING_MY_Y = "damping_my_y", "C_myy", NewtonSecondPerRadian, "change of m_y with e_y'":
        One(|film| entry(film, 3, 1)), ErrorRule::Of(RULE, |estimate, _| bar(estimate, 3, 1)),
        in_table(Table::Dynamics) only(has_tilt);

    /// `dm_y/dg_x'`, likewise
    DAMPING_MY_GX = "damping_my_gx", "C_mygx", NewtonMetreSecondPerRadian, "change of m_y with g_x'":
        One(|film| entry(film, 3, 2)), ErrorRule::Of(RULE, |estimate, _| bar(estimate, 3, 2)),
        in_table(Table::Dynamics) only(has_tilt);

    /// `dm_y/dg_y'`, likewise
    DAMPING_MY_GY = "damping_my_gy", "C_mygy", NewtonMetreSecondPerRadian, "change of m_y with g_y'":
        One(|film| entry(film, 3, 3)), ErrorRule::Of(RULE, |estimate, _| bar(estimate, 3, 3)),
        in_table(Table::Dynamics) only(has_tilt);
}

fn entry(film: &View, row: usize, column: usize) -> Option<f64> {
    let of = first(film)?;
    (row.max(column) < of.order).then(|| of.damping[row][column])
}

fn bar(estimate: &dyn Estimate, row: usize, column: usize) -> Option<Bar> {
    let errors = estimate.coefficients()?;
    Some(Bar::of(errors.bar(|part| Some(part.damping[row][column]))?))
}
