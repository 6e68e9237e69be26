//! Kinds of warnings: one row each, with the short code by which tables name it.

use std::borrow::Borrow;
use std::fmt;
use std::ops::Deref;

use serde::{Deserialize, Serialize, Serializer};

/// One kind of warning.
#[derive(Debug, PartialEq, Eq)]
pub struct Kind {
    /// Name in tables: one word without a semicolon.
    pub code: &'static str,
    /// What it says, in a sentence.
    pub sentence: &'static str,
}

impl Kind {
    /// A warning of this kind in words.
    pub fn says(&'static self, text: impl Into<String>) -> Warning {
        Warning { kind: self, text: text.into() }
    }
}

/// A doubt about a result: its kind, and a sentence with the numbers of this film. Results hold the sentence.
#[derive(Debug, Clone, PartialEq, Eq, Deserialize)]
#[serde(from = "String")]
pub struct Warning {
    /// Kind of the warning.
    pub kind: &'static Kind,
    /// The sentence.
    pub text: String,
}

impl Warning {
    /// This warning as one about a part of the whole, which its sentence begins with.
    #[must_use]
    pub fn of(self, part: &str) -> Self {
        Self { text: format!("{part}: {}", self.text), ..self }
    }
}

impl Deref for Warning {
    type Target = str;

    fn deref(&self) -> &str {
        &self.text
    }
}

impl AsRef<str> for Warning {
    fn as_ref(&self) -> &str {
        &self.text
    }
}

impl Borrow<str> for Warning {
    fn borrow(&self) -> &str {
        &self.text
    }
}

impl fmt::Display for Warning {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        out.write_str(&self.text)
    }
}

impl Serialize for Warning {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(&self.text)
    }
}

impl From<String> for Warning {
    fn from(sentence: String) -> Self {
        READ.says(sentence)
    }
}

/// The kind of a warning that was read from a file of results, which has its sentence alone.
static READ: Kind = Kind { code: "", sentence: "" };

/// Kinds as statics, and the list of all of them.
macro_rules! kinds {
    ($($id:ident = $code:literal, $sentence:literal;)+) => {
        $(#[doc = $sentence] pub static $id: Kind = Kind { code: $code, sentence: $sentence };)+

        /// All kinds of warnings.
        pub static KINDS: &[&Kind] = &[$(&$id),+];
    };
}

kinds! {
    UNRESOLVED = "unresolved", "the mesh is too coarse where the film is thin";
    NO_BAR = "no_bar", "the mesh does not resolve the film well enough for some error bars";
    WIDE_BAR = "wide_bar", "an error bar is wider than wanted, and a finer mesh would take long";
    CROSSWISE = "crosswise", "the triangles spread oil across the flow, so there are no error bars";
    REMESHED = "remeshed", "the film was meshed in rows along the flow, not by the triangles of the file";
    FLIPPED = "flipped", "edges of the mesh were flipped to make it Delaunay";
    FALLBACK = "fallback", "a step of the solver that failed was replaced by a less accurate one";
    NO_COEFFICIENTS = "no_coefficients", "stiffness and damping could not be computed";
    TENSION = "tension", "the pressure falls below that of the ends, and there is no model of cavitation";
    UNBALANCED = "unbalanced", "the model of cavitation or of viscosity does not conserve oil";
    CREATED = "created", "much of the oil that carries the heat off is created by the cavity";
    HALF_SPEED = "half_speed", "most of the load turns at half the speed of the journal, where the film collapses";
    FROM_START = "from_start", "no oil is supplied to a part of the film: what it holds along the orbit follows from the start";
    UNEVEN = "uneven", "the viscosity of the oil changes much between inlet and outlet, so that one temperature does not describe the film";
    WARMED = "warmed", "friction would heat the oil, but the scene has no `[heat]`";
    VISCOSITY_LAW = "viscosity_law", "pressure or temperature lie beyond the range of a law of viscosity";
    THEORY = "theory", "short or long bearing theory does not suit the length of the bearing";
    SHEARED = "sheared", "a multigrade oil is sheared so fast that it loses viscosity";
    DIVERGENT = "divergent", "a flow at a corner between two given pressures has no finite value";
    TURBULENT = "turbulent", "the Reynolds number lies above the limit of the laminar film";
    LAMINAR = "laminar", "the Reynolds number lies below that at which a film becomes turbulent";
    INERTIA = "inertia", "the inertia of the oil counts";
    CURVED = "curved", "the clearance is large against the radius";
    NARROW = "narrow", "the clearance is small against the radius";
    MOLECULAR = "molecular", "the film is some molecules thin";
    TOUCHING = "touching", "the least film is below three times the roughness";
    VALLEYS = "valleys", "the flow through the valleys of rough surfaces is not that which is computed";
    ASPERITIES = "asperities", "the pressure of contact is near the hardness: asperities yield";
    NO_LAYER = "no_layer", "a Winkler layer is no model of the wall that it is made of";
    SLICES = "slices", "the elastic wall is too thick for slices that move by themselves";
    SOFT = "soft", "the elastic liner deflects by more than the clearance";
    ELASTIC = "elastic", "the surfaces would deflect by more than the least film";
    DEEP = "deep", "a shape of bore or shaft is as deep as the clearance";
    STEEP = "steep", "a shape of bore or shaft is steeper than Reynolds' equation allows";
    COARSE_POINTS = "coarse_points", "the points of a measured surface are further apart than the film changes";
    NOISY_POINTS = "noisy_points", "the noise of a measured surface shows in the film";
    YIELDING = "yielding", "steel yields at the greatest pressure";
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_kind_has_a_code_of_its_own() {
        for (place, kind) in KINDS.iter().enumerate() {
            let is_word = |letter: char| letter.is_ascii_lowercase() || letter == '_';
            assert!(kind.code.chars().all(is_word) && !kind.sentence.is_empty(), "{kind:?}");
            assert!(KINDS[..place].iter().all(|other| other.code != kind.code), "{kind:?}");
        }
    }
}
