//! The method of generalised minimal residuals without restarts, in the form that keeps moves U with orthonormal images
//! `C = A U` (Eisenstat, Elman, Schultz, SIAM J. Numer. Anal. 20 (1983) 345; which direction comes next: Jiranek,
//! Rozloznik, Numer. Algorithms 53 (2010) 93). Later systems with the same operator begin with them: what C has of a
//! right-hand side is solved at once.

use oilwedge_fem::Error;

/// Most products with the operator.
const MOST_STEPS: usize = 400;
/// Where a product leaves more than this part of the residual, the next direction is that of its image, not of the
/// residual.
const SLOW: f64 = 0.9;

/// A solution, how many products with the operator it took, and the residual over the right-hand side.
pub(super) struct GmresSolution {
    pub(super) x: Vec<f64>,
    pub(super) steps: usize,
    pub(super) left: f64,
}

impl GmresSolution {
    /// The solution of a system whose answer is a number that is reported.
    ///
    /// # Errors
    /// It was not solved to this accuracy.
    pub(super) fn to(self, accuracy: f64) -> Result<Vec<f64>, Error> {
        match self.left <= accuracy {
            true => Ok(self.x),
            false => Err(Error::Inaccurate { relative: self.left }),
        }
    }
}

/// What products with an operator have shown of it.
#[derive(Debug, Default)]
pub(super) struct KrylovSpace {
    moves: Vec<Vec<f64>>,
    /// Images of the moves, orthonormal.
    images: Vec<Vec<f64>>,
    /// Accuracy of the systems that the products serve; zero before the first one.
    accuracy: f64,
}

/// Solves `A x = b` until the residual is below `accuracy` of b, or no further product helps; `nearly` solves a system
/// much like it.
///
/// # Errors
/// Those of the operator, and of the system much like it.
pub(super) fn gmres<E>(
    operator: impl Fn(&[f64]) -> Result<Vec<f64>, E>,
    nearly: impl Fn(&[f64]) -> Result<Vec<f64>, E>,
    b: &[f64],
    accuracy: f64,
) -> Result<GmresSolution, E> {
    KrylovSpace::default().solve(operator, nearly, b, accuracy)
}

impl KrylovSpace {
    /// Solves a system as [`gmres`] does, with the operator of the systems before.
    ///
    /// # Errors
    /// Those of the operator, and of the system much like it.
    pub(super) fn solve<E>(
        &mut self,
        operator: impl Fn(&[f64]) -> Result<Vec<f64>, E>,
        nearly: impl Fn(&[f64]) -> Result<Vec<f64>, E>,
        b: &[f64],
        accuracy: f64,
    ) -> Result<GmresSolution, E> {
        let size = norm(b);
        if size == 0.0 || !size.is_finite() {
            return Ok(GmresSolution { x: b.to_vec(), steps: 0, left: size });
        }
        // Products are as exact as their systems ask for.
        if accuracy < self.accuracy {
            *self = Self::default();
        }
        self.accuracy = accuracy;
        let mut residual = b.to_vec();
        let mut x = self.taken(&mut residual);
        let (mut left, mut steps) = (norm(&residual), 0);
        let mut direction = scaled(&residual, 1.0 / left);
        while steps < MOST_STEPS && left > accuracy * size {
            steps += 1;
            let mut step = nearly(&direction)?;
            let mut image = operator(&step)?;
            add(&mut step, -1.0, &self.taken(&mut image));
            let length = norm(&image);
            if length == 0.0 || !length.is_finite() {
                break;
            }
            let (step, image) = (scaled(&step, 1.0 / length), scaled(&image, 1.0 / length));
            let part = product(&residual, &image);
            add(&mut x, part, &step);
            add(&mut residual, -part, &image);
            let before = std::mem::replace(&mut left, norm(&residual));
            direction = match left > SLOW * before {
                true => image.clone(),
                false => scaled(&residual, 1.0 / left),
            };
            self.moves.push(step);
            self.images.push(image);
        }
        let left = left / size;
        Ok(GmresSolution { x, steps, left })
    }

    /// Takes what the images known have of a vector out of it, by Gram and Schmidt twice; the move whose image that
    /// was.
    fn taken(&self, from: &mut [f64]) -> Vec<f64> {
        let mut taken = vec![0.0; from.len()];
        for _ in 0..2 {
            for (image, step) in self.images.iter().zip(&self.moves) {
                let part = product(from, image);
                add(from, -part, image);
                add(&mut taken, part, step);
            }
        }
        taken
    }
}

/// Adds `by` times `more`.
fn add(sum: &mut [f64], by: f64, more: &[f64]) {
    sum.iter_mut().zip(more).for_each(|(sum, more)| *sum += by * more);
}

fn scaled(x: &[f64], by: f64) -> Vec<f64> {
    x.iter().map(|x| by * x).collect()
}

fn product(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// Euclidean norm.
pub(super) fn norm(x: &[f64]) -> f64 {
    product(x, x).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::convert::Infallible;

    /// An unsymmetric matrix of order 40.
    fn times(x: &[f64]) -> Vec<f64> {
        let n = x.len();
        let before = |i: usize| if i > 0 { 0.7 * x[i - 1] } else { 0.0 };
        let behind = |i: usize| if i + 3 < n { -0.4 * x[i + 3] } else { 0.0 };
        (0..n).map(|i| (2.0 + i as f64) * x[i] + before(i) + behind(i)).collect()
    }

    fn as_it_is<E>(r: &[f64]) -> Result<Vec<f64>, E> {
        Ok(r.to_vec())
    }

    #[test]
    fn systems_are_solved_as_exactly_as_asked() {
        let b: Vec<f64> = (0..40).map(|i| (1.3 * f64::from(i)).cos()).collect();
        let mut before = 0;
        for accuracy in [1e-2, 1e-6, 1e-12] {
            let Ok(GmresSolution { x, steps, left }) = gmres(|x| Ok::<_, Infallible>(times(x)), as_it_is, &b, accuracy);
            let residual: Vec<f64> = times(&x).iter().zip(&b).map(|(a, b)| a - b).collect();
            assert!(norm(&residual) < 1.5 * accuracy * norm(&b), "{accuracy:e}");
            assert!((norm(&residual) / norm(&b) - left).abs() < 0.1 * accuracy, "{left:e}");
            assert!(steps > before && steps <= 40, "{steps}");
            before = steps;
        }
    }

    #[test]
    fn a_system_much_like_it_saves_products() {
        let b: Vec<f64> = (0..40).map(|i| (1.3 * f64::from(i)).cos()).collect();
        let of_diagonal = |r: &[f64]| Ok(r.iter().enumerate().map(|(i, r)| r / (2.0 + i as f64)).collect());
        let Ok(plain) = gmres(|x| Ok::<_, Infallible>(times(x)), as_it_is, &b, 1e-10);
        let Ok(GmresSolution { x, steps, .. }) = gmres(|x| Ok::<_, Infallible>(times(x)), of_diagonal, &b, 1e-10);
        let residual: Vec<f64> = times(&x).iter().zip(&b).map(|(a, b)| a - b).collect();
        assert!(norm(&residual) < 1.5e-10 * norm(&b));
        assert!(2 * steps < plain.steps, "{steps} {}", plain.steps);
    }

    #[test]
    fn what_one_system_has_shown_saves_products_of_the_next() {
        let right = |k: f64| (0..40).map(|i| (1.3 * f64::from(i) + k).cos()).collect::<Vec<f64>>();
        let mut known = KrylovSpace::default();
        let mut steps = Vec::new();
        for k in [0.0, 0.5, 1.0, 1.5] {
            let Ok(solved) = known.solve(|x| Ok::<_, Infallible>(times(x)), as_it_is, &right(k), 1e-8);
            let residual: Vec<f64> = times(&solved.x).iter().zip(&right(k)).map(|(a, b)| a - b).collect();
            assert!(norm(&residual) < 1.5e-8 * norm(&right(k)), "{k}");
            steps.push(solved.steps);
        }
        assert!(2 * steps[1] < steps[0] && steps[2] < 3, "{steps:?}");
        // Products of rough systems are no good for an exact one.
        let Ok(exact) = known.solve(|x| Ok::<_, Infallible>(times(x)), as_it_is, &right(0.0), 1e-10);
        assert!(exact.steps >= steps[0], "{} {steps:?}", exact.steps);
    }

    #[test]
    fn nothing_gives_nothing_and_errors_pass() {
        let Ok(nothing) = gmres(|x| Ok::<_, Infallible>(times(x)), as_it_is, &[0.0; 5], 1e-6);
        assert_eq!((nothing.x, nothing.steps), (vec![0.0; 5], 0));
        assert!(gmres(|_| Err("no"), as_it_is, &[1.0; 5], 1e-6).is_err());
    }

    /// A singular operator, and a right-hand side that is no number.
    #[test]
    fn what_is_not_solved_is_no_answer() {
        let Ok(vanishing) = gmres(|_| Ok::<_, Infallible>(vec![0.0; 5]), as_it_is, &[1.0; 5], 1e-6);
        assert!(matches!(vanishing.to(1e-6), Err(Error::Inaccurate { relative: 1.0 })));
        let Ok(undefined) = gmres(|x| Ok::<_, Infallible>(x.to_vec()), as_it_is, &[f64::NAN; 5], 1e-6);
        assert!(undefined.to(1e-6).is_err());
        let Ok(solved) = gmres(|x| Ok::<_, Infallible>(x.to_vec()), as_it_is, &[2.0; 5], 1e-6);
        let x = solved.to(1e-6).expect("a solution");
        assert!(x.iter().all(|x| (x - 2.0).abs() < 1e-12), "{x:?}");
    }
}
