//! Measured surfaces in files: `angle [deg], z [mm], depth [um]` and one point a line, in any order. The points form a
//! grid: each angle at each axial position.
//!
//! Without the column `angle` the surface is the same all around. Around a full ring the grid is periodic, and its last
//! angle may repeat the first one a turn later.

use std::collections::BTreeMap;
use std::f64::consts::TAU;
use std::path::Path;

use crate::Arc;
use crate::periodic_table::columns::{ColumnPlaces, Others, TableColumn, has_column};
use crate::periodic_table::error::TableFault;
use crate::periodic_table::{TableError, TableRow, read_text};
use crate::unit::Dimension;
use crate::wording::{degrees, millimetres};

/// Places that differ by less than this part of the whole are one.
const SAME: f64 = 1e-7;
/// The step from the last angle to the first one, and the distance of the outermost points from the ends, may be so
/// many times the longest step.
const LONGEST_GAP: f64 = 1.5;
/// Points of which so much of the range of depths is noise are worth a word: see [`SurfacePoints::noise`].
const NEIGHBOURS: f64 = 20.0;

/// A surface by its depths at the points of a grid.
#[derive(Debug, Clone, PartialEq)]
pub struct SurfacePoints {
    /// Growing angles [rad] within one turn; one alone for a surface that is the same all around.
    pub angles: Vec<f64>,
    /// Growing axial positions [m].
    pub zs: Vec<f64>,
    /// Depth [m] at each angle, at each position.
    pub depths: Vec<Vec<f64>>,
}

/// What a measured surface has to cover.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Covered {
    /// Length of the bearing [m], from `-length/2` to `length/2`.
    pub length: f64,
    /// The part of the circumference; `None`: all of it.
    pub arc: Option<Arc>,
}

/// Reads the measured depths of a bore: `angle`, `z` and `depth`, or `z` and `depth`.
///
/// # Errors
/// [`TableError`]: the file cannot be read, its points are no grid, or do not cover the surface.
pub fn read_bore(path: &Path, covered: Covered) -> Result<SurfacePoints, TableError> {
    const COLUMNS: [TableColumn; 3] = [
        TableColumn::optional("angle", Dimension::Angle),
        TableColumn::needed("z", Dimension::Length),
        TableColumn::needed("depth", Dimension::Length),
    ];
    let read = |text: &str| grid(ColumnPlaces::read(text, &COLUMNS)?, covered);
    read(&read_text(path)?).map_err(|fault| fault.in_file(path))
}

/// Reads the measured depths along a journal: `z` and `depth`.
///
/// # Errors
/// As [`read_bore`].
pub fn read_shaft(path: &Path, covered: Covered) -> Result<SurfacePoints, TableError> {
    const COLUMNS: [TableColumn; 2] =
        [TableColumn::needed("z", Dimension::Length), TableColumn::needed("depth", Dimension::Length)];
    let read = |text: &str| {
        let rows = ColumnPlaces::read(text, &COLUMNS)?.into_iter();
        let rows = rows.map(|TableRow { line, values: [z, depth] }| TableRow { line, values: [0.0, z, depth] });
        grid(rows.collect(), covered)
    };
    read(&read_text(path)?).map_err(|fault| fault.in_file(path))
}

/// A journal that wears its bore.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct WearingPosition {
    /// Offset at mid-length [m].
    pub offset: [f64; 2],
    /// Slope of the axis [rad]; zero where the table has none.
    pub tilt: [f64; 2],
}

/// Reads positions of a journal: `e_x`, `e_y` and, if wanted, `g_x`, `g_y`; or the table of an orbit, `e_x/c`, `e_y/c`
/// over this clearance [m] and, if they are there, `tilt_x`, `tilt_y`, beside columns that do not matter.
///
/// # Errors
/// [`TableError`]: the file cannot be read, or has no positions.
pub fn read_positions(path: &Path, clearance: f64) -> Result<Vec<WearingPosition>, TableError> {
    positions(&read_text(path)?, clearance).map_err(|fault| fault.in_file(path))
}

fn positions(text: &str, clearance: f64) -> Result<Vec<WearingPosition>, TableFault> {
    const GIVEN: [TableColumn; 4] = [
        TableColumn::needed("e_x", Dimension::Length),
        TableColumn::needed("e_y", Dimension::Length),
        TableColumn::optional("g_x", Dimension::Angle),
        TableColumn::optional("g_y", Dimension::Angle),
    ];
    const OF_ORBIT: [TableColumn; 4] = [
        TableColumn::needed("e_x/c", Dimension::Ratio),
        TableColumn::needed("e_y/c", Dimension::Ratio),
        TableColumn::optional("tilt_x", Dimension::Angle),
        TableColumn::optional("tilt_y", Dimension::Angle),
    ];
    let (rows, unit) = match has_column(text, "e_x/c") {
        true => (ColumnPlaces::read_beside(text, &OF_ORBIT, Others::Ignored)?, clearance),
        false => (ColumnPlaces::read(text, &GIVEN)?, 1.0),
    };
    if rows.is_empty() {
        return Err(TableFault::of_all("has no positions", "write a row for each position below the header"));
    }
    let position = |row: &TableRow<4>| {
        let [x, y, g_x, g_y] = row.values;
        WearingPosition { offset: [x, y].map(|part| unit * part), tilt: [g_x, g_y] }
    };
    Ok(rows.iter().map(position).collect())
}

/// The points as a grid.
fn grid(mut rows: Vec<TableRow<3>>, covered: Covered) -> Result<SurfacePoints, TableFault> {
    let zs = distinct(rows.iter().map(|row| row.values[1]), SAME * covered.length);
    let mut angles = distinct(rows.iter().map(|row| row.values[0]), SAME);
    // A last angle that repeats the first a turn later.
    if covered.arc.is_none() && angles.len() > 1 && (angles[angles.len() - 1] - angles[0] - TAU).abs() < SAME {
        let last = angles[angles.len() - 1];
        let is_last = |row: &TableRow<3>| (row.values[0] - last).abs() < SAME;
        closed(&rows, angles[0], last, SAME * covered.length)?;
        rows.retain(|row| !is_last(row));
        angles.pop();
    }
    let place = |list: &[f64], value: f64, same: f64| list.partition_point(|&at| at < value - same);
    let mut found: BTreeMap<(usize, usize), &TableRow<3>> = BTreeMap::new();
    for row in &rows {
        let [angle, z, _] = row.values;
        let at = (place(&angles, angle, SAME), place(&zs, z, SAME * covered.length));
        if let Some(first) = found.insert(at, row) {
            let message = format!(
                "the point at {}, z = {} stands in line {} already",
                degrees(angle),
                millimetres(z),
                first.line
            );
            return Err(TableFault::at(row.line, message, "give each point once"));
        }
    }
    let missing = angles.len() * zs.len() - found.len();
    let first_missing = (0..angles.len()).flat_map(|i| (0..zs.len()).map(move |j| (i, j)));
    if let Some((i, j)) = first_missing.into_iter().find(|at| !found.contains_key(at)) {
        return Err(TableFault::of_all(
            format!(
                "its points are no grid: of {} angles at {} axial positions {missing} have no depth, the first at {}, z = {}",
                angles.len(),
                zs.len(),
                degrees(angles[i]),
                millimetres(zs[j])
            ),
            "give a depth for each angle at each axial position, interpolated where the measurement has gaps",
        ));
    }
    check_axis(&zs, covered)?;
    check_turn(&angles, covered)?;
    let depth = |i: usize, j: usize| found[&(i, j)].values[2];
    Ok(SurfacePoints {
        depths: (0..angles.len()).map(|i| (0..zs.len()).map(|j| depth(i, j)).collect()).collect(),
        angles,
        zs,
    })
}

/// The growing values of a list, those that differ by less than `same` as one.
fn distinct(values: impl Iterator<Item = f64>, same: f64) -> Vec<f64> {
    let mut all: Vec<f64> = values.collect();
    all.sort_by(f64::total_cmp);
    all.dedup_by(|next, before| *next - *before < same);
    all
}

/// The depths at the last angle are those of the first one, a turn before.
fn closed(rows: &[TableRow<3>], first: f64, last: f64, same: f64) -> Result<(), TableFault> {
    let depths = rows.iter().map(|row| row.values[2]);
    let (low, high) = depths.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), d| (l.min(d), h.max(d)));
    for row in rows.iter().filter(|row| (row.values[0] - last).abs() < SAME) {
        let is_twin = |other: &&TableRow<3>| {
            (other.values[0] - first).abs() < SAME && (other.values[1] - row.values[1]).abs() < same
        };
        let twin = rows.iter().find(is_twin);
        if let Some(twin) = twin.filter(|twin| (twin.values[2] - row.values[2]).abs() > 1e-3 * (high - low)) {
            let message = format!("the point stands a turn after that of line {}, but has another depth", twin.line);
            return Err(TableFault::at(row.line, message, "correct one of them, or leave the rows of this angle out"));
        }
    }
    Ok(())
}

/// The grid reaches both ends.
fn check_axis(zs: &[f64], covered: Covered) -> Result<(), TableFault> {
    let [Some(&first), Some(&last)] = [zs.first(), zs.last()] else {
        return Err(TableFault::of_all("has no points", "write a row for each point below the header"));
    };
    if zs.len() < 2 {
        return Err(TableFault::of_all(
            format!("has points at one axial position only, z = {}", millimetres(first)),
            "give points at two axial positions or more, from end to end of the bearing",
        ));
    }
    let longest = zs.array_windows().map(|[a, b]| b - a).fold(0.0, f64::max);
    let half = 0.5 * covered.length;
    let off = (first + half).max(half - last);
    match off > LONGEST_GAP * longest {
        false => Ok(()),
        true => Err(TableFault::of_all(
            format!(
                "its points reach from z = {} to {}, and the bearing from {} to {}",
                millimetres(first),
                millimetres(last),
                millimetres(-half),
                millimetres(half)
            ),
            "give points up to both ends, z = 0 at mid-length; is the unit of z right?",
        )),
    }
}

/// The grid goes around the liner.
fn check_turn(angles: &[f64], covered: Covered) -> Result<(), TableFault> {
    if angles.len() < 2 {
        return Ok(());
    }
    let (first, last) = (angles[0], angles[angles.len() - 1]);
    let longest = angles.array_windows().map(|[a, b]| b - a).fold(0.0, f64::max);
    let (wanted, gap, help) = match covered.arc {
        None => {
            ("all around".to_owned(), first + TAU - last, "add the missing angles: a full ring needs them all around")
        }
        Some(Arc { from, to }) => (
            format!("from {} to {}", degrees(from), degrees(to)),
            (first - from).max(to - last),
            "count the angles as bearing.arc does, and add those that are missing",
        ),
    };
    if last - first > TAU {
        let message = format!("its angles reach over {}, more than a turn", degrees(last - first));
        return Err(TableFault::of_all(message, "give each angle once"));
    }
    match gap > LONGEST_GAP * longest {
        false => Ok(()),
        true => Err(TableFault::of_all(
            format!("its angles reach from {} to {}, and the liner {wanted}", degrees(first), degrees(last)),
            help,
        )),
    }
}

impl SurfacePoints {
    /// Noise of the measurement [m], estimated: the root mean square of the third differences from point to point
    /// around, over the root of 20, by which they magnify independent errors. Shapes that the grid resolves have next
    /// to none.
    pub fn noise(&self) -> f64 {
        let around = self.angles.len();
        if around < 4 {
            return 0.0;
        }
        let mut sum = 0.0;
        for i in 0..around - 3 {
            for j in 0..self.zs.len() {
                let [a, b, c, d] = [0, 1, 2, 3].map(|k| self.depths[i + k][j]);
                sum += (d - a - 3.0 * (c - b)).powi(2);
            }
        }
        (sum / (NEIGHBOURS * ((around - 3) * self.zs.len()) as f64)).sqrt()
    }
}

#[cfg(test)]
mod tests;
