//! Matrices of displacements in files: what a structural program has condensed.
//!
//! ```text
//! # a comment
//! phi [deg] = 0, 15, 30, ... 345
//! z [mm] = -10, 0, 10
//! displacement [nm/N] =
//! 12.1, 3.2, ...
//! ```
//! The angles are equally spaced over the whole circumference, the axial positions grow from end to end of the liner.
//! Row i, column j of the matrix is the displacement outwards at point i for a unit force outwards at point j; points
//! are numbered along the axis first, then from angle to angle.

use std::path::Path;

pub use crate::periodic_table::TableError;
use crate::periodic_table::error::TableFault;
use crate::periodic_table::read_text;
use crate::unit::{self, Dimension};
use crate::wording::millimetres;

/// Fewest angles, and axial positions.
const LEAST: [usize; 2] = [8, 3];
/// Most points.
const MOST_POINTS: usize = 1200;
/// Angles are equally spaced but for this part of a step.
const EQUAL: f64 = 1e-4;
/// The matrix is symmetric but for this part of its greatest entry.
const SYMMETRIC: f64 = 1e-3;
/// Least work of a load, over the greatest entry of the matrix.
const INDEFINITE: f64 = 1e-6;

/// Displacements of points for unit forces.
#[derive(Debug, Clone, PartialEq)]
pub struct ComplianceTable {
    /// The first angle [rad] of equally spaced ones.
    pub first_angle: f64,
    /// How many angles there are.
    pub angles: usize,
    /// Axial positions [m], growing.
    pub axial: Vec<f64>,
    /// The matrix by rows [m/N], symmetric to the last bit.
    pub displacements: Vec<f64>,
}

/// Reads the matrix of a liner of this length [m].
///
/// # Errors
/// [`TableError`]: the file cannot be read, or is no matrix of a wall.
pub fn read_compliance(path: &Path, length: f64) -> Result<ComplianceTable, TableError> {
    table(&read_text(path)?, length).map_err(|fault| fault.in_file(path))
}

fn table(text: &str, length: f64) -> Result<ComplianceTable, TableFault> {
    let text = text.trim_start_matches('\u{feff}');
    let lines = (1..).zip(text.lines().map(str::trim));
    let mut lines = lines.filter(|(_, line)| !line.is_empty() && !line.starts_with('#'));
    let mut header = |name: &str, dimension: Dimension, example: &str| -> Result<(usize, Vec<f64>, f64), TableFault> {
        let help = format!("write {example}");
        let Some((line, text)) = lines.next() else {
            return Err(TableFault::of_all(format!("ends before the line of {name}"), help));
        };
        let size = unit_of(text, name, dimension).map_err(|message| TableFault::at(line, message, help))?;
        let rest = text.split_once('=').map_or("", |(_, rest)| rest.trim());
        let values = if rest.is_empty() { Vec::new() } else { numbers(line, rest, size)? };
        Ok((line, values, size))
    };
    let (line_of_angles, angles, _) = header("phi", Dimension::Angle, "phi [deg] = 0, 15, 30 and so on to 345")?;
    let (line_of_axial, axial, _) = header("z", Dimension::Length, "z [mm] = -10, 0, 10")?;
    let (_, _, size) = header("displacement", Dimension::PointCompliance, "displacement [nm/N] =")?;
    check_angles(line_of_angles, &angles)?;
    check_axial(line_of_axial, &axial, length)?;
    let points = angles.len() * axial.len();
    if points > MOST_POINTS {
        let message = format!("has {points} points, more than {MOST_POINTS}");
        return Err(TableFault::of_all(message, "condense the wall to fewer points"));
    }
    let mut displacements = Vec::with_capacity(points * points);
    let mut rows = 0;
    for (line, text) in lines {
        let row = numbers(line, text, size)?;
        if row.len() != points {
            let message = format!("there are {} numbers, and the matrix has {points} columns", row.len());
            return Err(TableFault::at(line, message, "write a number for each point in each row"));
        }
        displacements.extend(row);
        rows += 1;
    }
    if rows != points {
        let message = format!("the matrix has {rows} rows and {points} columns");
        return Err(TableFault::of_all(message, "write a row for each point"));
    }
    check_symmetry(&mut displacements, points)?;
    check_definiteness(&displacements, points)?;
    Ok(ComplianceTable { first_angle: angles[0], angles: angles.len(), axial, displacements })
}

/// Size in SI of the unit in the brackets of a line of this name.
fn unit_of(text: &str, name: &str, dimension: Dimension) -> Result<f64, String> {
    let before = text.split_once('=').map_or(text, |(before, _)| before);
    let parts = before.split_once('[');
    let parts = parts.and_then(|(found, rest)| Some((found.trim(), rest.trim().strip_suffix(']')?.trim())));
    match parts {
        Some((found, unit)) if found == name && text.contains('=') => {
            unit::unit_size(unit, dimension).map_err(|error| format!("the unit of {name}: {error}"))
        }
        _ => Err(format!("the line of {name} with its unit in brackets is missing here")),
    }
}

/// Numbers with commas between them, in SI.
fn numbers(line: usize, text: &str, size: f64) -> Result<Vec<f64>, TableFault> {
    let number = |cell: &str| {
        let value = cell.trim().parse::<f64>().ok().map(|value| value * size);
        value.filter(|value| value.is_finite()).ok_or_else(|| {
            let message = format!("\"{}\" is not a finite number", cell.trim());
            TableFault::at(line, message, "write numbers like 12.5 or 1.25e1, with commas between them")
        })
    };
    text.trim_end_matches(',').split(',').map(number).collect()
}

fn check_angles(line: usize, angles: &[f64]) -> Result<(), TableFault> {
    let help = "give angles from one to the next by the same step, once around: 0, 15, 30 and so on to 345";
    if angles.len() < LEAST[0] {
        let message = format!("there are {} angles, fewer than {}", angles.len(), LEAST[0]);
        return Err(TableFault::at(line, message, help));
    }
    let step = std::f64::consts::TAU / angles.len() as f64;
    let off = |(k, angle): (usize, &f64)| (angle - angles[0] - step * k as f64).abs() > EQUAL * step;
    match angles.iter().enumerate().any(off) {
        true => Err(TableFault::at(line, "the angles are not equally spaced over one turn", help)),
        false => Ok(()),
    }
}

fn check_axial(line: usize, axial: &[f64], length: f64) -> Result<(), TableFault> {
    if axial.len() < LEAST[1] {
        let message = format!("there are {} axial positions, fewer than {}", axial.len(), LEAST[1]);
        return Err(TableFault::at(line, message, "give at least one at the middle and one near each end"));
    }
    if axial.windows(2).any(|pair| pair[1] <= pair[0]) {
        return Err(TableFault::at(line, "the axial positions do not grow", "sort the points along the axis"));
    }
    let beyond = axial.iter().find(|z| z.abs() > 0.5 * length * (1.0 + EQUAL));
    match beyond {
        Some(z) => {
            let (z, half) = (millimetres(*z), millimetres(0.5 * length));
            let message = format!("the axial position {z} lies beyond the ends of the liner, -{half} and {half}");
            Err(TableFault::at(line, message, "z = 0 is the middle of the liner; correct z, or bearing.length"))
        }
        None => Ok(()),
    }
}

/// Makes the matrix symmetric to the last bit, if it nearly is.
fn check_symmetry(matrix: &mut [f64], points: usize) -> Result<(), TableFault> {
    let greatest = matrix.iter().fold(0.0f64, |most, entry| most.max(entry.abs()));
    for i in 0..points {
        for j in 0..i {
            let [one, other] = [matrix[i * points + j], matrix[j * points + i]];
            if (one - other).abs() > SYMMETRIC * greatest {
                let message = format!(
                    "the matrix is not symmetric: row {}, column {} has {one:.4e} m/N, and row {}, column {} has {other:.4e} m/N",
                    i + 1,
                    j + 1,
                    j + 1,
                    i + 1
                );
                return Err(TableFault::of_all(
                    message,
                    "write displacements for unit forces at the points themselves",
                ));
            }
            let mean = 0.5 * (one + other);
            (matrix[i * points + j], matrix[j * points + i]) = (mean, mean);
        }
    }
    Ok(())
}

/// Forces do no negative work: Cholesky's factor exists, but for rounding of the table.
fn check_definiteness(matrix: &[f64], points: usize) -> Result<(), TableFault> {
    let greatest = (0..points).fold(0.0f64, |most, k| most.max(matrix[k * points + k]));
    let mut factor = matrix.to_vec();
    for i in 0..points {
        for j in 0..=i {
            let (upper, lower) = (&factor[j * points..j * points + j], &factor[i * points..i * points + j]);
            let known: f64 = upper.iter().zip(lower).map(|(a, b)| a * b).sum();
            let left = factor[i * points + j] - known;
            if i != j {
                factor[i * points + j] = left / factor[j * points + j];
                continue;
            }
            let left = left + INDEFINITE * greatest;
            if left <= 0.0 || left.is_nan() {
                let message =
                    format!("the matrix is not positive definite: forces on points 1 to {} would gain work", i + 1);
                return Err(TableFault::of_all(
                    message,
                    "write displacements outwards for forces outwards; the sign of one of them may be wrong",
                ));
            }
            factor[i * points + i] = left.sqrt();
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A wall of 8 times 3 points.
    fn text(matrix: impl Fn(usize, usize) -> f64) -> String {
        let row = |i: usize| {
            let cells: Vec<String> = (0..24).map(|j| format!("{:.6e}", matrix(i, j))).collect();
            cells.join(", ")
        };
        let rows: Vec<String> = (0..24).map(row).collect();
        format!(
            "# a wall\nphi [deg] = 0, 45, 90, 135, 180, 225, 270, 315\nz [mm] = -8, 0, 8\ndisplacement [nm/N] =\n{}\n",
            rows.join("\n")
        )
    }

    fn good(i: usize, j: usize) -> f64 {
        if i == j { 2.0 } else { 0.5 / (1.0 + i.abs_diff(j) as f64) }
    }

    #[test]
    fn a_matrix_is_read_in_si() {
        let table = table(&text(good), 0.02).expect("a wall");
        assert_eq!((table.angles, table.first_angle), (8, 0.0));
        assert_eq!(table.axial, vec![-8.0 * 1e-3, 0.0, 8.0 * 1e-3]);
        assert!((table.displacements[25] / 2e-9 - 1.0).abs() < 1e-12 && table.displacements.len() == 576);
    }

    #[test]
    fn what_is_no_wall_is_refused() {
        let refused = |text: &str, wanted: &str| {
            let fault = table(text, 0.02).expect_err(wanted).in_file(Path::new("eye.csv"));
            assert!(fault.to_string().contains(wanted), "{fault}");
        };
        let wall = text(good);
        refused("", "ends before the line of phi");
        refused(&wall.replace("[deg]", ""), "line 2: the line of phi with its unit in brackets is missing here");
        refused(&wall.replace("[deg]", "[mm]"), "the unit of phi: \"mm\" is a unit of length");
        refused(&wall.replace("135", "140"), "the angles are not equally spaced over one turn");
        refused(&wall.replace("phi [deg] = 0, 45, 90, 135, 180, 225, 270, 315", "phi [deg] = 0, 180"), "2 angles");
        refused(&wall.replace("-8, 0, 8", "-8, 8"), "2 axial positions");
        refused(&wall.replace("-8, 0, 8", "8, 0, -8"), "do not grow");
        refused(&wall.replace("-8, 0, 8", "-18, 0, 8"), "lies beyond the ends of the liner");
        refused(&wall.replacen("2.000000e0", "NaN", 1), "line 5: \"NaN\" is not a finite number");
        refused(&wall.replacen("2.000000e0, ", "", 1), "line 5: there are 23 numbers, and the matrix has 24 columns");
        let cut: Vec<&str> = wall.lines().take(20).collect();
        refused(&cut.join("\n"), "the matrix has 16 rows and 24 columns");
        let skew = |i: usize, j: usize| if (i, j) == (3, 1) { 1.0 } else { good(i, j) };
        refused(&text(skew), "row 4, column 2");
        let pulled = |i: usize, j: usize| if i == j && i == 6 { -2.0 } else { good(i, j) };
        refused(&text(pulled), "not positive definite: forces on points 1 to 7");
    }
}
