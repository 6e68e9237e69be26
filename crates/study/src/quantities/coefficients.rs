//! Stiffness and damping as rows see them: at the first frequency asked for.

use crate::scope::Scope;
use oilwedge_bearing::Coefficients;

use super::view::View;

/// How their errors are estimated, in words.
pub(super) const RULE: &str = "the difference of two films, quadratic and cubic or fine and coarse, and where the edge of a cavity may run in its triangles";

/// Coefficients at the first frequency asked for; none where they are not asked for, or could not be computed.
pub(super) fn first<'a>(film: &'a View) -> Option<&'a Coefficients> {
    Some(&film.measured.dynamics()?.at.first()?.coefficients)
}

/// Whether a scene asks for them.
pub(super) fn is_asked(scope: &Scope) -> bool {
    scope.dynamics.is_some()
}

/// Whether a scene asks for those of a journal that may tilt.
pub(super) fn has_tilt(scope: &Scope) -> bool {
    is_asked(scope) && scope.can_tilt
}
