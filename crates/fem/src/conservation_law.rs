//! The contract between physics and finite elements: flux and source at a point.

use crate::Dual;

/// A stationary conservation law for one scalar field `u`:
///
/// `div F(x, u, grad u) + s(x, u, grad u) = 0`.
///
/// Tested with a shape function `phi_i` and integrated by parts it becomes the residual
/// `R_i = Int (s phi_i - F . grad phi_i) dA`. Where `u` is given, `R_i` is the reaction: what
/// enters through the boundary near node `i`. The `R_i` of all nodes sum to the integral of `s`.
pub trait ConservationLaw: Sync {
    /// What kind of tangent the law has; the assembler asks for [`ConservationLaw::conduction`] or
    /// for [`ConservationLaw::response`] accordingly.
    fn tangent(&self) -> TangentKind;

    /// Conductance, rest flux and source of a law of kind [`TangentKind::Conduction`] at `positions` [m] in triangle
    /// `cell`.
    fn conduction(&self, cell: usize, positions: &[[f64; 2]], out: &mut [Conduction]);

    /// Parts of the conductance that count along x and along z [1]; not one where a law of kind
    /// [`TangentKind::Conduction`] drops a direction.
    fn directions(&self) -> [f64; 2] {
        [1.0; 2]
    }

    /// Whether a law of kind [`TangentKind::Conduction`] has the same conductance along x and along z, before
    /// [`ConservationLaw::directions`] weighs them: its elements take half of the work.
    fn is_isotropic(&self) -> bool {
        true
    }

    /// Flux and source at `positions` [m] in triangle `cell`, where `u` and its gradient are as in
    /// `states`: seeds 0, 1, 2 of the duals are `u`, `du/dx`, `du/dz`.
    fn response(&self, cell: usize, positions: &[[f64; 2]], states: &[State], out: &mut [Response]);
}

/// Kind of the tangent `dR/du`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum TangentKind {
    /// `F = rest - k grad u` and a source that does not depend on `u`: linear and symmetric positive definite.
    Conduction,
    /// Nonlinear with a symmetric tangent.
    Symmetric,
}

/// `F_d = flux_d - conductance_d * du/dx_d`, with a source that does not depend on `u`.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Conduction {
    /// Conductance `k` along x and along z.
    pub conductance: [f64; 2],
    /// Flux at `grad u = 0`.
    pub flux: [f64; 2],
    /// Source `s`.
    pub source: f64,
}

/// The field at a point.
#[derive(Debug, Clone, Copy, Default)]
pub struct State {
    /// Value `u`.
    pub value: Dual,
    /// Gradient `(du/dx, du/dz)` [per m].
    pub gradient: [Dual; 2],
}

/// What a law answers at a point.
#[derive(Debug, Clone, Copy, Default)]
pub struct Response {
    /// Flux `F`.
    pub flux: [Dual; 2],
    /// Source `s`.
    pub source: Dual,
}
