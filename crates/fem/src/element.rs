//! Element matrices: contraction of a law's flux and source with the shape functions.
//!
//! A straight P2 triangle of a conducting law takes a closed form: with the moments
//! `M_ij = Int k l_i l_j`, `m_i = sum_j M_ij`, `m = sum_i m_i` and `g_ij = grad l_i . D grad l_j`,
//! D the diagonal of the law's directions, for one axis after the other where each has a conductance of its own,
//! ```text
//! vertex i, vertex j:     g_ij (16 M_ij - 4 m_i - 4 m_j + m)
//! vertex i, edge xy:      4 [g_ix (4 M_iy - m_y) + g_iy (4 M_ix - m_x)]
//! edge xy, edge uw:       16 [g_yw M_xu + g_yu M_xw + g_xw M_yu + g_xu M_yw]
//! ```
//! equal to the general element with the same quadrature (test in `assembly`).

use oilwedge_mesh::Mesh;

use crate::conservation_law::{Conduction, ConservationLaw, Response, State};
use crate::lagrange::{self, MOST_SHAPES};
use crate::mapping::{MappedPoint, Mapping};
use crate::quadrature::MOST_POINTS;
use crate::{Dual, Quadrature};

/// Tangent and residual of one element, in local order.
#[derive(Debug, Clone, Default)]
pub struct Element {
    /// `dR_i / du_j`.
    pub tangent: [[f64; MOST_SHAPES]; MOST_SHAPES],
    /// `R_i`.
    pub residual: [f64; MOST_SHAPES],
}

/// Shape functions tabulated at the points of a rule.
#[derive(Debug)]
pub struct ElementKernel {
    degree: usize,
    shapes: usize,
    points: Vec<[f64; 2]>,
    weights: Vec<f64>,
    values: Vec<[f64; MOST_SHAPES]>,
    gradients: Vec<[[f64; 2]; MOST_SHAPES]>,
    /// Weights times barycentric coordinates `l_i`, and times `l_i l_j` in the order of [`PAIRS`].
    moments: Vec<([f64; 3], [f64; 6])>,
    /// Products of reference gradients for cubic elements, empty for others.
    products: Vec<GradientProducts>,
}

/// Pairs of barycentric coordinates.
const PAIRS: [(usize, usize); 6] = [(0, 0), (1, 1), (2, 2), (0, 1), (1, 2), (2, 0)];
/// Pairs of shape functions `i <= j` of a cubic element.
const CUBIC_PAIRS: usize = MOST_SHAPES * (MOST_SHAPES + 1) / 2;
/// Products of the derivatives of each pair at one point: by xi, mixed ones in both orders, and those by eta.
type GradientProducts = [[f64; CUBIC_PAIRS]; 3];

/// Geometry at the quadrature points of one element.
struct ElementGeometry {
    positions: [[f64; 2]; MOST_POINTS],
    places: [MappedPoint; MOST_POINTS],
    /// Weight times Jacobian determinant [m2].
    areas: [f64; MOST_POINTS],
}

impl ElementKernel {
    /// The kernel of elements of this degree, with the rule that suits it.
    pub fn new(degree: usize) -> Self {
        let rule = Quadrature::for_degree(degree);
        let shapes = lagrange::shapes(degree);
        let mut kernel = Self {
            degree,
            shapes,
            points: rule.points,
            weights: rule.weights,
            values: Vec::new(),
            gradients: Vec::new(),
            moments: Vec::new(),
            products: Vec::new(),
        };
        for (&point, weight) in kernel.points.iter().zip(&kernel.weights) {
            let l = lagrange::barycentric(point);
            kernel.moments.push((l.map(|l| weight * l), PAIRS.map(|(i, j)| weight * l[i] * l[j])));
            let (mut values, mut gradients) = ([0.0; MOST_SHAPES], [[0.0; 2]; MOST_SHAPES]);
            lagrange::values(degree, point, &mut values[..shapes]);
            lagrange::gradients(degree, point, &mut gradients[..shapes]);
            kernel.values.push(values);
            kernel.gradients.push(gradients);
            if degree == 3 {
                kernel.products.push(gradient_products(&gradients));
            }
        }
        kernel
    }

    fn geometry(&self, mapping: &Mapping) -> ElementGeometry {
        let nowhere =
            MappedPoint { position: [0.0; 2], determinant: 0.0, inverse_transposed: nalgebra::Matrix2::zeros() };
        let mut geometry = ElementGeometry {
            positions: [[0.0; 2]; MOST_POINTS],
            places: [nowhere; MOST_POINTS],
            areas: [0.0; MOST_POINTS],
        };
        for (q, &point) in self.points.iter().enumerate() {
            let place = mapping.at(point);
            geometry.positions[q] = place.position;
            geometry.areas[q] = self.weights[q] * place.determinant;
            geometry.places[q] = place;
        }
        geometry
    }

    /// Element of a law of kind [`crate::Tangent::Conduction`], at the nodal values `u`.
    pub fn conduction(
        &self,
        law: &dyn ConservationLaw,
        mesh: &Mesh,
        t: usize,
        u: &[f64; MOST_SHAPES],
        out: &mut Element,
    ) {
        let n = self.points.len();
        let mapping = Mapping::of(mesh, t);
        let mut points = [Conduction::default(); MOST_POINTS];
        match (&mapping, self.degree) {
            (Mapping::Straight(corners), 2) => {
                let (positions, determinant) = self.straight_positions(corners);
                law.conduction(t, &positions[..n], &mut points[..n]);
                self.straight_quadratic(corners, determinant, &points[..n], out);
                by_axes(law, out, |along, axis, out| {
                    self.quadratic_tangent((along, axis), corners, determinant, &points[..n], out);
                });
            }
            (Mapping::Straight(corners), 3) => {
                let (positions, determinant) = self.straight_positions(corners);
                law.conduction(t, &positions[..n], &mut points[..n]);
                self.straight_cubic(corners, determinant, &points[..n], out);
                by_axes(law, out, |along, axis, out| {
                    self.cubic_tangent((along, axis), corners, determinant, &points[..n], out);
                });
            }
            _ => {
                let geometry = self.geometry(&mapping);
                law.conduction(t, &geometry.positions[..n], &mut points[..n]);
                self.general_conduction(law.directions(), &geometry, &points[..n], out);
            }
        }
        // A film that starts from nothing has few values: those that are given.
        if u.iter().any(|&u| u != 0.0) {
            for i in 0..self.shapes {
                for j in 0..self.shapes {
                    out.residual[i] += out.tangent[i][j] * u[j];
                }
            }
        }
    }

    fn straight_positions(&self, [a, b, c]: &[[f64; 2]; 3]) -> ([[f64; 2]; MOST_POINTS], f64) {
        let (ab, ac) = ([b[0] - a[0], b[1] - a[1]], [c[0] - a[0], c[1] - a[1]]);
        let mut positions = [[0.0; 2]; MOST_POINTS];
        for (position, &[xi, eta]) in positions.iter_mut().zip(&self.points) {
            *position = [a[0] + xi * ab[0] + eta * ac[0], a[1] + xi * ab[1] + eta * ac[1]];
        }
        (positions, ab[0] * ac[1] - ab[1] * ac[0])
    }

    fn general_conduction(
        &self,
        along: [f64; 2],
        geometry: &ElementGeometry,
        points: &[Conduction],
        out: &mut Element,
    ) {
        *out = Element::default();
        let n = self.shapes;
        for (q, point) in points.iter().enumerate() {
            let area = geometry.areas[q];
            let gradients = self.surface_gradients(geometry, q);
            for i in 0..n {
                let g = gradients[i];
                out.residual[i] +=
                    area * (point.source * self.values[q][i] - point.flux[0] * g[0] - point.flux[1] * g[1]);
                let weighted = [0, 1].map(|d| area * point.conductance[d] * along[d] * g[d]);
                for j in 0..n {
                    out.tangent[i][j] += weighted[0] * gradients[j][0] + weighted[1] * gradients[j][1];
                }
            }
        }
    }

    /// Flux and source of a straight quadratic triangle, in the closed form of the file's head.
    fn straight_quadratic(&self, corners: &[[f64; 2]; 3], determinant: f64, points: &[Conduction], out: &mut Element) {
        out.residual = [0.0; MOST_SHAPES];
        let slope = barycentric_slopes(corners, determinant);
        let mut rest = [[0.0; 2]; 3];
        for (q, (point, (l, _))) in points.iter().zip(&self.moments).enumerate() {
            for i in 0..3 {
                rest[i][0] += point.flux[0] * l[i];
                rest[i][1] += point.flux[1] * l[i];
            }
            if point.source != 0.0 {
                let area = self.weights[q] * determinant;
                for i in 0..6 {
                    out.residual[i] += area * point.source * self.values[q][i];
                }
            }
        }
        let rest = rest.map(|flux| flux.map(|flux| determinant * flux));
        let rest_total = [0, 1].map(|d| rest[0][d] + rest[1][d] + rest[2][d]);
        let along = |i: usize, v: [f64; 2]| slope[i][0] * v[0] + slope[i][1] * v[1];
        for i in 0..3 {
            let at_vertex = [0, 1].map(|d| 4.0 * rest[i][d] - rest_total[d]);
            out.residual[i] -= along(i, at_vertex);
            let y = (i + 1) % 3;
            out.residual[3 + i] -= 4.0 * (along(y, rest[i]) + along(i, rest[y]));
        }
    }

    /// Tangent of the closed form of the file's head.
    fn quadratic_tangent(
        &self,
        (directions, axis): ([f64; 2], usize),
        corners: &[[f64; 2]; 3],
        determinant: f64,
        points: &[Conduction],
        out: &mut Element,
    ) {
        let slope = barycentric_slopes(corners, determinant);
        let mut g = [[0.0; 3]; 3];
        for i in 0..3 {
            for j in 0..3 {
                g[i][j] = directions[0] * slope[i][0] * slope[j][0] + directions[1] * slope[i][1] * slope[j][1];
            }
        }
        let mut pairs = [0.0; 6];
        for (point, (_, l_l)) in points.iter().zip(&self.moments) {
            for k in 0..6 {
                pairs[k] += point.conductance[axis] * l_l[k];
            }
        }
        let mut moment = [[0.0; 3]; 3];
        for ((i, j), pair) in PAIRS.into_iter().zip(pairs) {
            moment[i][j] = determinant * pair;
            moment[j][i] = moment[i][j];
        }
        let m: [f64; 3] = std::array::from_fn(|i| moment[i].iter().sum());
        let total: f64 = m.iter().sum();
        for i in 0..3 {
            for j in 0..3 {
                out.tangent[i][j] = g[i][j] * (16.0 * moment[i][j] - 4.0 * m[i] - 4.0 * m[j] + total);
                let (x, y) = (j, (j + 1) % 3);
                let mixed = 4.0 * (g[i][x] * (4.0 * moment[i][y] - m[y]) + g[i][y] * (4.0 * moment[i][x] - m[x]));
                out.tangent[i][3 + j] = mixed;
                out.tangent[3 + j][i] = mixed;
                let (u, w) = (i, (i + 1) % 3);
                out.tangent[3 + i][3 + j] = 16.0
                    * (g[y][w] * moment[x][u]
                        + g[y][u] * moment[x][w]
                        + g[x][w] * moment[y][u]
                        + g[x][u] * moment[y][w]);
            }
        }
    }

    /// Flux and source of a straight cubic triangle.
    fn straight_cubic(&self, corners: &[[f64; 2]; 3], determinant: f64, points: &[Conduction], out: &mut Element) {
        out.residual = [0.0; MOST_SHAPES];
        let [xi, eta] = reference_slopes(corners, determinant);
        for (q, point) in points.iter().enumerate() {
            let area = self.weights[q] * determinant;
            let along = [xi, eta].map(|to| area * (point.flux[0] * to[0] + point.flux[1] * to[1]));
            let source = area * point.source;
            for (i, residual) in out.residual.iter_mut().enumerate() {
                let g = self.gradients[q][i];
                *residual += source * self.values[q][i] - along[0] * g[0] - along[1] * g[1];
            }
        }
    }

    /// Tangent of a straight cubic triangle: its metric does not vary, so the conductance weighs products of gradients.
    fn cubic_tangent(
        &self,
        (directions, axis): ([f64; 2], usize),
        corners: &[[f64; 2]; 3],
        determinant: f64,
        points: &[Conduction],
        out: &mut Element,
    ) {
        let mut weighed = [[0.0; CUBIC_PAIRS]; 3];
        for (q, point) in points.iter().enumerate() {
            let area = self.weights[q] * determinant;
            let conductance = area * point.conductance[axis];
            for (sum, products) in weighed.iter_mut().zip(&self.products[q]) {
                for (sum, product) in sum.iter_mut().zip(products) {
                    *sum += conductance * product;
                }
            }
        }
        let [xi, eta] = reference_slopes(corners, determinant);
        let dot = |a: [f64; 2], b: [f64; 2]| directions[0] * a[0] * b[0] + directions[1] * a[1] * b[1];
        let metric = [dot(xi, xi), dot(xi, eta), dot(eta, eta)];
        let mut pair = 0;
        for i in 0..MOST_SHAPES {
            for j in i..MOST_SHAPES {
                let entry = metric[0] * weighed[0][pair] + metric[1] * weighed[1][pair] + metric[2] * weighed[2][pair];
                out.tangent[i][j] = entry;
                out.tangent[j][i] = entry;
                pair += 1;
            }
        }
    }

    /// Element of any law, at the nodal values `u`, by quadrature and dual numbers.
    pub fn response(
        &self,
        law: &dyn ConservationLaw,
        mesh: &Mesh,
        t: usize,
        u: &[f64; MOST_SHAPES],
        out: &mut Element,
    ) {
        *out = Element::default();
        let (n, count) = (self.shapes, self.points.len());
        let geometry = self.geometry(&Mapping::of(mesh, t));
        let mut states = [State::default(); MOST_POINTS];
        let mut responses = [Response::default(); MOST_POINTS];
        for q in 0..count {
            let mut value = 0.0;
            let mut reference = [0.0; 2];
            for i in 0..n {
                value += u[i] * self.values[q][i];
                reference[0] += u[i] * self.gradients[q][i][0];
                reference[1] += u[i] * self.gradients[q][i][1];
            }
            let gradient = geometry.places[q].gradient(reference);
            states[q] = State {
                value: Dual::seed(value, 0),
                gradient: [Dual::seed(gradient[0], 1), Dual::seed(gradient[1], 2)],
            };
        }
        law.response(t, &geometry.positions[..count], &states[..count], &mut responses[..count]);
        for (q, response) in responses[..count].iter().enumerate() {
            let area = geometry.areas[q];
            let gradients = self.surface_gradients(&geometry, q);
            let values = &self.values[q];
            for i in 0..n {
                // The integrand s phi_i - F . grad phi_i with its derivatives by u and grad u.
                let g = gradients[i];
                let tested = response.source * values[i] - response.flux[0] * g[0] - response.flux[1] * g[1];
                out.residual[i] += area * tested.v;
                for j in 0..n {
                    let by_gradient = tested.d[1] * gradients[j][0] + tested.d[2] * gradients[j][1];
                    out.tangent[i][j] += area * (tested.d[0] * values[j] + by_gradient);
                }
            }
        }
    }

    fn surface_gradients(&self, geometry: &ElementGeometry, q: usize) -> [[f64; 2]; MOST_SHAPES] {
        let mut gradients = [[0.0; 2]; MOST_SHAPES];
        for i in 0..self.shapes {
            gradients[i] = geometry.places[q].gradient(self.gradients[q][i]);
        }
        gradients
    }
}

/// Makes the tangent of a straight triangle by `part`, of parts along both axes and the axis whose conductance counts.
fn by_axes(law: &dyn ConservationLaw, out: &mut Element, part: impl Fn([f64; 2], usize, &mut Element)) {
    let [x, z] = law.directions();
    if law.is_isotropic() {
        return part([x, z], 0, out);
    }
    part([x, 0.0], 0, out);
    let mut along_z = Element::default();
    part([0.0, z], 1, &mut along_z);
    for (row, more) in out.tangent.iter_mut().zip(along_z.tangent) {
        for (entry, more) in row.iter_mut().zip(more) {
            *entry += more;
        }
    }
}

/// Gradients [1/m] of the barycentric coordinates: the opposite edge turned by 90 degrees.
fn barycentric_slopes([a, b, c]: &[[f64; 2]; 3], determinant: f64) -> [[f64; 2]; 3] {
    let gradient = |from: &[f64; 2], to: &[f64; 2]| [(from[1] - to[1]) / determinant, (to[0] - from[0]) / determinant];
    [gradient(b, c), gradient(c, a), gradient(a, b)]
}

/// Gradients [1/m] of xi and eta: the rows of the inverse Jacobian.
fn reference_slopes([a, b, c]: &[[f64; 2]; 3], determinant: f64) -> [[f64; 2]; 2] {
    let (ab, ac) = ([b[0] - a[0], b[1] - a[1]], [c[0] - a[0], c[1] - a[1]]);
    [[ac[1] / determinant, -ac[0] / determinant], [-ab[1] / determinant, ab[0] / determinant]]
}

fn gradient_products(gradients: &[[f64; 2]; MOST_SHAPES]) -> GradientProducts {
    let mut products = [[0.0; CUBIC_PAIRS]; 3];
    let mut pair = 0;
    for (i, a) in gradients.iter().enumerate() {
        for b in &gradients[i..] {
            products[0][pair] = a[0] * b[0];
            products[1][pair] = a[0] * b[1] + a[1] * b[0];
            products[2][pair] = a[1] * b[1];
            pair += 1;
        }
    }
    products
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::lagrange::BARYCENTRIC_GRADIENTS;

    #[test]
    fn barycentric_gradients_of_the_reference_triangle() {
        // The closed form's slopes on the reference triangle are the tabulated ones.
        let corners = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]];
        let place = Mapping::Straight(corners).at([0.2, 0.2]);
        for gradient in BARYCENTRIC_GRADIENTS {
            assert_eq!(place.gradient(gradient), gradient);
        }
    }
}
