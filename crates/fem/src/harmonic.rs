//! Systems of harmonic motions, `(A + i D) x = b` with an unsymmetric real tangent A and a real diagonal D, by real
//! factors of twice the size.
//!
//! With `x = u + i v` and `b = f + i g` it is `A u - D v = f`, `A v + D u = g`. Both parts of a dof are eliminated one
//! after the other, so that the fronts are those of the real factor with each dof doubled.

use std::sync::Arc;

use crate::{Constraints, Error, Linearisation, Matrix, Pattern, UnsymmetricAnalysis};

/// The analysed pattern of the doubled system; one for all frequencies.
#[derive(Debug)]
pub struct HarmonicAnalysis {
    pattern: Arc<Pattern>,
    doubled: Arc<UnsymmetricAnalysis>,
}

/// A factorised system of harmonic motions.
#[derive(Debug)]
pub struct HarmonicSystem {
    linearisation: Linearisation,
}

impl HarmonicAnalysis {
    /// The analysis of tangents with the pattern of `analysis`.
    ///
    /// # Errors
    /// [`Error::TooLarge`] if the factor's indices do not fit in memory.
    pub fn new(analysis: &UnsymmetricAnalysis) -> Result<Self, Error> {
        let pattern = Arc::new(doubled(analysis.pattern()));
        let order = analysis.order().iter().flat_map(|&dof| [2 * dof, 2 * dof + 1]).collect();
        Ok(Self { doubled: Arc::new(UnsymmetricAnalysis::new(pattern.clone(), order)?), pattern })
    }

    /// Factorises `tangent + i diagonal`, the rows of given dofs left out.
    ///
    /// # Errors
    /// [`Error::NotFinite`], or [`Error::TooLarge`] if the factor does not fit.
    pub fn factorise(&self, tangent: &Matrix, diagonal: &[f64], fixed: &[bool]) -> Result<HarmonicSystem, Error> {
        let values = (0..diagonal.len()).flat_map(|i| {
            let entries = tangent.pattern.row(i).map(move |k| (tangent.pattern.columns[k], k));
            let row = move |part: usize| {
                entries.clone().flat_map(move |(column, k)| {
                    let own = Some(tangent.values[k]);
                    let across = (column as usize == i).then(|| [-diagonal[i], diagonal[i]][part]);
                    match part {
                        0 => [own, across],
                        _ => [across, own],
                    }
                })
            };
            row(0).chain(row(1))
        });
        let matrix = Matrix { pattern: self.pattern.clone(), values: values.flatten().collect() };
        let mut constraints = Constraints::none(2 * diagonal.len());
        constraints.fixed = fixed.iter().flat_map(|&fixed| [fixed, fixed]).collect();
        let factor = self.doubled.factorise(&matrix, &constraints.fixed, None)?;
        Ok(HarmonicSystem { linearisation: Linearisation::unsymmetric(matrix, factor, constraints) })
    }
}

impl HarmonicSystem {
    /// The real and the imaginary part of the solution for those of the right-hand side; zero at given dofs.
    ///
    /// # Errors
    /// As [`Linearisation::solve`].
    pub fn solve(&self, [real, imaginary]: [&[f64]; 2]) -> Result<[Vec<f64>; 2], Error> {
        let b: Vec<f64> = real.iter().zip(imaginary).flat_map(|(&re, &im)| [re, im]).collect();
        let x = self.linearisation.solve(&b)?;
        let part = |part: usize| x.iter().skip(part).step_by(2).copied().collect();
        Ok([part(0), part(1)])
    }
}

/// The pattern with each dof doubled: its parts couple with each other, and with the same parts of its neighbours.
fn doubled(pattern: &Pattern) -> Pattern {
    let (mut row_start, mut columns) = (vec![0], Vec::with_capacity(2 * pattern.columns.len()));
    for i in 0..pattern.dimension() {
        for part in [0, 1] {
            for &column in &pattern.columns[pattern.row(i)] {
                let is_own = column as usize == i;
                columns.extend(
                    [0, 1].into_iter().filter(|&other| other == part || is_own).map(|other| 2 * column + other),
                );
            }
            row_start.push(columns.len() as u32);
        }
    }
    Pattern { row_start, columns }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Upwind transport with diffusion on a line of `n` points.
    fn line(n: u32) -> Matrix {
        let (mut row_start, mut columns, mut values) = (vec![0], Vec::new(), Vec::new());
        for i in 0..n {
            for j in i.saturating_sub(1)..(i + 2).min(n) {
                columns.push(j);
                values.push(match i.cmp(&j) {
                    std::cmp::Ordering::Equal => 5.0 + f64::from(i % 3),
                    std::cmp::Ordering::Greater => -4.0,
                    std::cmp::Ordering::Less => -0.5,
                });
            }
            row_start.push(columns.len() as u32);
        }
        let pattern = Arc::new(Pattern { row_start, columns });
        Matrix { pattern, values }
    }

    #[test]
    fn both_parts_solve_their_equations() {
        let matrix = line(23);
        let n = matrix.pattern.dimension();
        let analysis = UnsymmetricAnalysis::new(matrix.pattern.clone(), (0..n as u32).collect()).unwrap();
        let diagonal: Vec<f64> = (0..n).map(|i| if i % 4 == 1 { 0.0 } else { 1.0 + i as f64 }).collect();
        let mut fixed = vec![false; n];
        fixed[7] = true;
        let [f, g]: [Vec<f64>; 2] = [0.3, 1.7].map(|by| (0..n).map(|i| (by * i as f64).sin()).collect());
        let harmonic = HarmonicAnalysis::new(&analysis).unwrap();
        let system = harmonic.factorise(&matrix, &diagonal, &fixed).unwrap();
        let [u, v] = system.solve([&f, &g]).unwrap();
        assert_eq!((u[7], v[7]), (0.0, 0.0));
        let (a_u, a_v) = (matrix.multiply(&u), matrix.multiply(&v));
        for i in (0..n).filter(|&i| i != 7) {
            assert!((a_u[i] - diagonal[i] * v[i] - f[i]).abs() < 1e-13, "{i}");
            assert!((a_v[i] + diagonal[i] * u[i] - g[i]).abs() < 1e-13, "{i}");
        }
    }

    #[test]
    fn without_a_diagonal_the_parts_are_two_real_systems() {
        let matrix = line(9);
        let n = matrix.pattern.dimension();
        let analysis = Arc::new(UnsymmetricAnalysis::new(matrix.pattern.clone(), (0..n as u32).collect()).unwrap());
        let b: Vec<f64> = (0..n).map(|i| (i as f64).cos()).collect();
        let harmonic = HarmonicAnalysis::new(&analysis).unwrap();
        let system = harmonic.factorise(&matrix, &vec![0.0; n], &vec![false; n]).unwrap();
        let [u, v] = system.solve([&b, &b]).unwrap();
        let factor = analysis.factorise(&matrix, &vec![false; n], None).unwrap();
        let real = Linearisation::unsymmetric(matrix, factor, Constraints::none(n)).solve(&b).unwrap();
        assert!((0..n).all(|i| (u[i] - real[i]).abs() < 1e-14 && (v[i] - real[i]).abs() < 1e-14));
    }
}
