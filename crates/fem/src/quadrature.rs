//! Quadrature on the reference triangle `(0,0), (1,0), (0,1)` and on the unit interval.
//!
//! Symmetric rules of degree 4, 6 and 8 (Dunavant 1985, Int. J. Numer. Meth. Engng 21, 1129),
//! their points found again to 20 digits from the moment equations. Verified by
//! `integrates_monomials_exactly`.

/// Points and weights on the reference triangle; the weights sum to its area 1/2.
#[derive(Debug, Clone, PartialEq)]
pub struct Quadrature {
    /// Polynomials up to this degree are integrated exactly.
    pub degree: usize,
    /// Reference coordinates `(xi, eta)`.
    pub points: Vec<[f64; 2]>,
    /// Weights.
    pub weights: Vec<f64>,
}

/// Most points of any rule here.
pub const MOST_POINTS: usize = 16;

impl Quadrature {
    /// The rule for elements of polynomial degree 1, 2 or 3: degree 4, 6 or 8, which leaves
    /// `h^3` over a well resolved element to the discretisation error.
    pub fn for_degree(degree: usize) -> Self {
        match degree {
            0 | 1 => Self::from_orbits(4, None, &DEGREE_4, &[]),
            2 => Self::from_orbits(6, None, &DEGREE_6, &[DEGREE_6_SIX]),
            _ => Self::from_orbits(8, Some(DEGREE_8_CENTRE), &DEGREE_8, &[DEGREE_8_SIX]),
        }
    }

    /// The rule on `4^levels` congruent parts of the reference triangle, one after the other.
    pub fn quartered(&self, levels: usize) -> Self {
        let parts = 4usize.pow(levels as u32);
        let share = 1.0 / parts as f64;
        let weights: Vec<f64> = self.weights.iter().map(|weight| share * weight).collect();
        Self { degree: self.degree, points: in_quarters(&self.points, levels), weights: weights.repeat(parts) }
    }

    /// The rule on the part of the reference triangle with these corners.
    pub fn on_part(mut self, [a, b, c]: [[f64; 2]; 3]) -> Self {
        let (u, v) = ([b[0] - a[0], b[1] - a[1]], [c[0] - a[0], c[1] - a[1]]);
        let part = u[0] * v[1] - u[1] * v[0];
        for point in &mut self.points {
            let [xi, eta] = *point;
            *point = [0, 1].map(|d| a[d] + xi * u[d] + eta * v[d]);
        }
        self.weights.iter_mut().for_each(|weight| *weight *= part);
        self
    }

    /// The points that `keeps` chooses, with their weights.
    pub fn only(mut self, keeps: impl Fn([f64; 2]) -> bool) -> Self {
        let kept = (self.points.iter().zip(&self.weights)).filter(|(point, _)| keeps(**point));
        (self.points, self.weights) = kept.map(|(&point, &weight)| (point, weight)).unzip();
        self
    }

    /// A rule from orbits of the triangle's symmetry: its centre (weight), three points `(a, a)` (weight, a), six
    /// points `(a, b)` (weight, a, b). Weights relative to area one.
    fn from_orbits(degree: usize, centre: Option<f64>, three: &[(f64, f64)], six: &[(f64, f64, f64)]) -> Self {
        let mut rule = Self { degree, points: Vec::new(), weights: Vec::new() };
        let mut add = |weight: f64, points: &[[f64; 2]]| {
            rule.points.extend_from_slice(points);
            rule.weights.extend(points.iter().map(|_| 0.5 * weight));
        };
        if let Some(weight) = centre {
            add(weight, &[[1.0 / 3.0, 1.0 / 3.0]]);
        }
        for &(weight, a) in three {
            let b = 1.0 - 2.0 * a;
            add(weight, &[[a, a], [b, a], [a, b]]);
        }
        for &(weight, a, b) in six {
            let c = 1.0 - a - b;
            add(weight, &[[a, b], [b, a], [b, c], [c, b], [c, a], [a, c]]);
        }
        rule
    }
}

const DEGREE_4: [(f64, f64); 2] =
    [(0.22338158967801147, 0.4459484909159649), (0.10995174365532187, 0.09157621350977074)];
const DEGREE_6: [(f64, f64); 2] =
    [(0.11678627572637937, 0.24928674517091043), (0.05084490637020682, 0.06308901449150223)];
const DEGREE_6_SIX: (f64, f64, f64) = (0.08285107561837357, 0.3103524510337844, 0.053145049844816945);
const DEGREE_8_CENTRE: f64 = 0.14431560767778717;
const DEGREE_8: [(f64, f64); 3] = [
    (0.09509163426728462, 0.4592925882927232),
    (0.10321737053471824, 0.1705693077517602),
    (0.03245849762319808, 0.05054722831703098),
];
const DEGREE_8_SIX: (f64, f64, f64) = (0.027230314174434993, 0.008394777409957605, 0.2631128296346381);

/// Points of the reference triangle in each of its `4^levels` congruent parts, one part after the other: those of part
/// `k` of a level lie in the parts from `4 k` on of the next.
pub(crate) fn in_quarters(points: &[[f64; 2]], levels: usize) -> Vec<[f64; 2]> {
    let quarters: [fn([f64; 2]) -> [f64; 2]; 4] =
        [|[a, b]| [a, b], |[a, b]| [a + 0.5, b], |[a, b]| [a, b + 0.5], |[a, b]| [0.5 - a, 0.5 - b]];
    (0..levels).fold(points.to_vec(), |points, _| {
        let halved: Vec<[f64; 2]> = points.iter().map(|point| point.map(|x| 0.5 * x)).collect();
        (quarters.iter()).flat_map(|quarter| halved.iter().copied().map(quarter)).collect()
    })
}

/// Integral of a function over `[0, 1]`.
pub fn integrate_interval(f: impl Fn(f64) -> f64) -> f64 {
    gauss_interval().into_iter().map(|(s, weight)| weight * f(s)).sum()
}

/// Gauss-Legendre rule with four points on `[0, 1]` (degree 7): points and weights.
pub(crate) fn gauss_interval() -> [(f64, f64); 4] {
    let root = (6.0f64 / 5.0).sqrt();
    let [near, far] = [-root, root].map(|sign| ((3.0 + 2.0 * sign) / 7.0).sqrt() / 2.0);
    let weight = |sign: f64| (18.0 + sign * 30.0f64.sqrt()) / 72.0;
    [(0.5 - far, weight(-1.0)), (0.5 - near, weight(1.0)), (0.5 + near, weight(1.0)), (0.5 + far, weight(-1.0))]
}

#[cfg(test)]
mod tests {
    use super::*;

    fn factorial(n: usize) -> f64 {
        (1..=n).map(|k| k as f64).product()
    }

    #[test]
    fn integrates_monomials_exactly() {
        for element_degree in 1..=3 {
            let rule = Quadrature::for_degree(element_degree);
            assert!(rule.points.len() <= MOST_POINTS);
            for i in 0..=rule.degree {
                for j in 0..=rule.degree - i {
                    let exact = factorial(i) * factorial(j) / factorial(i + j + 2);
                    let sum: f64 = (rule.points.iter().zip(&rule.weights))
                        .map(|(p, w)| w * p[0].powi(i as i32) * p[1].powi(j as i32))
                        .sum();
                    assert!((sum - exact).abs() < 1e-16, "degree {} x^{i} y^{j}", rule.degree);
                }
            }
        }
    }

    #[test]
    fn quartered_rule_keeps_its_degree() {
        let fine = Quadrature::for_degree(2).quartered(2);
        let sum: f64 = fine.points.iter().zip(&fine.weights).map(|(p, w)| w * p[0] * p[0] * p[1]).sum();
        assert!((sum - 2.0 / 120.0).abs() < 1e-16);
    }

    #[test]
    fn interval_rule_has_degree_seven() {
        for k in 0..=7 {
            let sum: f64 = gauss_interval().iter().map(|(x, w)| w * x.powi(k)).sum();
            assert!((sum - 1.0 / f64::from(k + 1)).abs() < 1e-15);
        }
    }
}
