//! # Elastic ring under pressure at its bore
//!
//! **Equation.** A pressure `p_n cos(n phi)` at the bore r = a moves it outwards by `u_r = C_n p_n cos(n phi)`. With
//! `2 G (u_r + i u_t) exp(i phi) = kappa f(z) - z conj(f'(z)) - conj(g(z))`, `kappa = 3 - 4 nu`,
//! `f = A z^(n+1) + B z^(1-n)`, `g = C z^(n-1) + D z^(-n-1)`, two conditions at each surface give the four constants.
//! For n = 1 `f = A z^2 + B ln z`, `g = -kappa B ln z + D z^-2`, beside a translation; for n = 0 Lame's
//! `u_r = A r + B/r`.
//!
//! | symbol | unit | code |
//! |---|---|---|
//! | a, t | m | `radius`, `thickness` |
//! | E, nu, G = E/(2 (1 + nu)) | Pa, -, Pa | `modulus`, `poisson`, `shear_modulus` |
//! | C_n | m/Pa | [`ElasticRing::compliance`] |
//! | k = t (1 - 2 nu)(1 + nu)/(E (1 - nu)) | m/Pa | [`ElasticRing::thin_layer`] |
//!
//! **Source.** Muskhelishvili, Some Basic Problems of the Mathematical Theory of Elasticity (1953), sections 41 and 56.
//! **Range.** Plane strain, small strains, 0 <= nu < 1/2. The first harmonic of a free ring is a rigid motion, which is
//! part of the offset of the journal: C_1 = 0 there.
//! **Verified by** `a_ring_is_that_of_the_equations_in_r`, `thin_and_thick_rings_have_their_limits`, and
//! `tests/tests/liner`.

/// What holds the outer surface of a ring.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum RingSupport {
    /// The outer surface does not move.
    Clamped,
    /// The outer surface is free of stress.
    Free,
}

/// A ring of one material in plane strain.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ElasticRing {
    /// Radius a of the bore [m].
    pub radius: f64,
    /// Thickness t of the wall [m].
    pub thickness: f64,
    /// Young's modulus E [Pa].
    pub modulus: f64,
    /// Poisson's ratio nu [1].
    pub poisson: f64,
    /// What holds its outer surface.
    pub outer: RingSupport,
}

/// The constants of four functions: a condition is a row, and so is a displacement.
type ConditionRow = [f64; 4];

/// Solution at one radius: the parts of displacement and stress that turn with `exp(i n phi)` and with `exp(-i n phi)`.
struct RingSolution {
    displacement: [ConditionRow; 2],
    stress: [ConditionRow; 2],
}

impl ElasticRing {
    /// `C_n` [m/Pa]: outward displacement of the bore for each pascal of a pressure `cos(n phi)`.
    pub fn compliance(&self, n: usize) -> f64 {
        match (n, self.outer) {
            (0, _) => self.lame(),
            (1, RingSupport::Free) => 0.0,
            _ => self.harmonic(n),
        }
    }

    /// Displacement for each pascal [m/Pa] of a layer that is thin beside all waves of the pressure, bonded to a rigid
    /// housing.
    pub fn thin_layer(&self) -> f64 {
        let Self { thickness, modulus, poisson, .. } = *self;
        thickness * (1.0 - 2.0 * poisson) * (1.0 + poisson) / (modulus * (1.0 - poisson))
    }

    fn shear_modulus(&self) -> f64 {
        0.5 * self.modulus / (1.0 + self.poisson)
    }

    /// Outer radius over that of the bore.
    fn ratio(&self) -> f64 {
        1.0 + self.thickness / self.radius
    }

    /// `u = A r + B/r`, r in radii of the bore: stress -1 at the bore.
    fn lame(&self) -> f64 {
        let twice = 2.0 * self.shear_modulus();
        let square = self.ratio() * self.ratio();
        let stiffening = 1.0 / (1.0 - 2.0 * self.poisson);
        // A = a_per_b B.
        let a_per_b = match self.outer {
            RingSupport::Clamped => -1.0 / square,
            RingSupport::Free => 1.0 / (square * stiffening),
        };
        let b = 1.0 / (twice * (1.0 - stiffening * a_per_b));
        self.radius * b * (1.0 + a_per_b)
    }

    fn harmonic(&self, n: usize) -> f64 {
        let (bore, outside) = (self.at(n, 1.0), self.at(n, self.ratio()));
        let held = match self.outer {
            RingSupport::Clamped => outside.displacement,
            RingSupport::Free => outside.stress,
        };
        let constants = solved([bore.stress[0], bore.stress[1], held[0], held[1]], [-0.5, -0.5, 0.0, 0.0]);
        let parts = bore.displacement.iter().flat_map(|row| row.iter().zip(constants));
        let sum: f64 = parts.map(|(factor, constant)| factor * constant).sum();
        sum * self.radius / (2.0 * self.shear_modulus())
    }

    /// Solution at the radius r over that of the bore; what grows outwards is over its value at the outer surface, so
    /// that nothing overflows.
    fn at(&self, n: usize, r: f64) -> RingSolution {
        let kappa = 3.0 - 4.0 * self.poisson;
        let grown = (r / self.ratio()).powi(n as i32);
        let decayed = r.powi(-(n as i32));
        if n == 1 {
            let square = r * r / (self.ratio() * self.ratio());
            let slope = 2.0 * r / (self.ratio() * self.ratio());
            return RingSolution {
                displacement: [
                    [kappa * square, -1.0, -r.powi(-2), 0.0],
                    [-2.0 * square, 2.0 * kappa * r.ln(), 0.0, 1.0],
                ],
                stress: [[0.0, (1.0 + kappa) / r, 0.0, 0.0], [slope, 2.0 / r, 2.0 * r.powi(-3), 0.0]],
            };
        }
        let n = n as f64;
        RingSolution {
            displacement: [
                [kappa * grown * r, (n - 1.0) * decayed * r, 0.0, -decayed / r],
                [-(n + 1.0) * grown * r, kappa * decayed * r, -grown / r, 0.0],
            ],
            stress: [
                [(1.0 - n * n) * grown, (1.0 - n) * decayed, (1.0 - n) * grown / (r * r), 0.0],
                [(n + 1.0) * grown, (1.0 - n * n) * decayed, 0.0, (n + 1.0) * decayed / (r * r)],
            ],
        }
    }
}

/// Four equations with scaled columns, by elimination with row pivots.
fn solved(mut a: [ConditionRow; 4], mut b: ConditionRow) -> ConditionRow {
    let greatest = |column: usize| a.iter().fold(0.0f64, |most, row| most.max(row[column].abs()));
    let scale = [0, 1, 2, 3].map(greatest);
    for row in &mut a {
        row.iter_mut().zip(scale).for_each(|(entry, scale)| *entry /= scale);
    }
    for k in 0..4 {
        let better = |best: usize, row: usize| if a[row][k].abs() > a[best][k].abs() { row } else { best };
        let pivot = (k..4).fold(k, better);
        a.swap(k, pivot);
        b.swap(k, pivot);
        let (upper, above) = (a[k], b[k]);
        for row in k + 1..4 {
            let factor = a[row][k] / upper[k];
            a[row].iter_mut().zip(upper).for_each(|(entry, upper)| *entry -= factor * upper);
            b[row] -= factor * above;
        }
    }
    let mut x = [0.0; 4];
    for k in (0..4).rev() {
        let known: f64 = (k + 1..4).map(|j| a[k][j] * x[j]).sum();
        x[k] = (b[k] - known) / a[k][k];
    }
    [0, 1, 2, 3].map(|k| x[k] / scale[k])
}

#[cfg(test)]
mod tests {
    use super::*;

    const STEEL: ElasticRing =
        ElasticRing { radius: 0.05, thickness: 0.05, modulus: 2.1e11, poisson: 0.3, outer: RingSupport::Clamped };

    /// Hooke's law and equilibrium of `(u_r cos, u_t sin, s_r cos, s_rt sin)` along r: derivatives.
    fn along_r(ring: &ElasticRing, n: f64, r: f64, [u, v, s, t]: ConditionRow) -> ConditionRow {
        let g = ring.shear_modulus();
        let lame = 2.0 * g * ring.poisson / (1.0 - 2.0 * ring.poisson);
        let hoop = (u + n * v) / r;
        let stretch = (s - lame * hoop) / (lame + 2.0 * g);
        let around = lame * stretch + (lame + 2.0 * g) * hoop;
        [stretch, t / g + (v + n * u) / r, -(s - around + n * t) / r, -(2.0 * t - n * around) / r]
    }

    /// The state at the outer surface, by the classical method of Runge and Kutta.
    fn shot(ring: &ElasticRing, n: f64, mut state: ConditionRow) -> ConditionRow {
        const STEPS: usize = 4000;
        let step = ring.thickness / STEPS as f64;
        let plus = |a: ConditionRow, by: f64, b: ConditionRow| [0, 1, 2, 3].map(|k| a[k] + by * b[k]);
        for k in 0..STEPS {
            let r = ring.radius + step * k as f64;
            let first = along_r(ring, n, r, state);
            let second = along_r(ring, n, r + 0.5 * step, plus(state, 0.5 * step, first));
            let third = along_r(ring, n, r + 0.5 * step, plus(state, 0.5 * step, second));
            let fourth = along_r(ring, n, r + step, plus(state, step, third));
            state =
                [0, 1, 2, 3].map(|i| state[i] + step / 6.0 * (first[i] + 2.0 * second[i] + 2.0 * third[i] + fourth[i]));
        }
        state
    }

    /// A second method: the ordinary differential equations in r, shot from the bore.
    #[test]
    fn a_ring_is_that_of_the_equations_in_r() {
        let aluminium =
            ElasticRing { radius: 0.03, thickness: 0.02, modulus: 7e10, poisson: 0.33, outer: RingSupport::Free };
        let soft = ElasticRing { thickness: 0.003, modulus: 5e6, poisson: 0.49, ..STEEL };
        let thin = ElasticRing { thickness: 0.001, outer: RingSupport::Free, ..STEEL };
        for ring in [STEEL, aluminium, soft, thin] {
            let first = if ring.outer == RingSupport::Free { 2 } else { 1 };
            for n in first..=16 {
                let by = [[1e-9, 0.0, 0.0, 0.0], [0.0, 1e-9, 0.0, 0.0], [0.0, 0.0, -1.0, 0.0]];
                let [by_u, by_v, by_p] = by.map(|start| shot(&ring, n as f64, start));
                let held = if ring.outer == RingSupport::Clamped { [0, 1] } else { [2, 3] };
                let [i, j] = held;
                let determinant = by_u[i] * by_v[j] - by_v[i] * by_u[j];
                let u = -1e-9 * (by_p[i] * by_v[j] - by_v[i] * by_p[j]) / determinant;
                let ratio = ring.compliance(n) / u;
                assert!((ratio - 1.0).abs() < 1e-7, "{ring:?} {n}: {ratio}");
            }
        }
    }

    #[test]
    fn thin_and_thick_rings_have_their_limits() {
        let thin = ElasticRing { thickness: 5e-6, ..STEEL };
        for n in [0, 1, 2, 8, 32, 180] {
            assert!((thin.compliance(n) / thin.thin_layer() - 1.0).abs() < 2e-4, "{n}");
        }
        // Waves that are short beside the wall: a half plane.
        let half_plane = |n: f64| 2.0 * (1.0 - 0.09) * 0.05 / (2.1e11 * n);
        for n in [400usize, 3000] {
            assert!((STEEL.compliance(n) / half_plane(n as f64) - 1.0).abs() < 2e-3, "{n}");
        }
        // A thin free ring is a curved beam: p a^4/(D (n^2 - 1)^2).
        let ring = ElasticRing { thickness: 1e-4, outer: RingSupport::Free, ..STEEL };
        let bending = 2.1e11 * 1e-12 / (12.0 * (1.0 - 0.09));
        for n in [2usize, 3, 5] {
            let beam = 0.05f64.powi(4) / (bending * ((n * n - 1) as f64).powi(2));
            assert!((ring.compliance(n) / beam - 1.0).abs() < 1e-2, "{n}");
        }
        // Lame's ring without an outer surface: p a (1 + nu)/E.
        let thick = ElasticRing { thickness: 50.0, ..STEEL };
        assert!((thick.compliance(0) / (0.05 * 1.3 / 2.1e11) - 1.0).abs() < 1e-5);
        assert_eq!(ring.compliance(1), 0.0);
    }
}
