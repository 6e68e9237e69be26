//! How wrong the numbers of a scene may be: the mesh is refined until their error bars are small enough.

use super::Theory;

/// Bar of the load, or of the eccentricity under a load, where a scene gives neither a mesh nor a tolerance [1].
const DEFAULT: f64 = 0.005;
/// That of short bearings, whose films take milliseconds [1].
const SHORT: f64 = 0.001;

/// Which error bars must become how small.
#[derive(Debug, Clone, PartialEq)]
pub struct Tolerance {
    /// One for each quantity, in the order of the contract; never empty.
    pub targets: Vec<Target>,
    /// Whether the scene gives it; one that it does not give counts only where bars are wanted.
    pub is_given: bool,
}

/// How small one error bar must become.
#[derive(Debug, Clone, PartialEq)]
pub struct Target {
    /// Name of a quantity of the result, as `load` or `feed_flow.feed_hole`.
    pub quantity: String,
    /// Half width of its bar relative to its value; to 1 rad for angles.
    pub relative: f64,
}

impl Tolerance {
    /// What a percentage by itself means: that of the load or, where that is given, of the eccentricity.
    pub fn of_main_quantity(relative: f64, under_load: bool, is_given: bool) -> Self {
        let quantity = if under_load { "eccentricity" } else { "load" }.to_owned();
        Self {
            targets: vec![Target { quantity, relative }],
            is_given,
        }
    }

    /// That of a scene with neither a mesh file nor a size nor a tolerance.
    pub fn where_nothing_is_given(under_load: bool) -> Self {
        Self::of_main_quantity(DEFAULT, under_load, false)
    }

    /// The same for a bearing of this theory, if it is not given.
    pub fn suited(mut self, theory: Theory) -> Self {
        let usual = if theory == Theory::Short { SHORT } else { DEFAULT };
        for target in self.targets.iter_mut().filter(|_| !self.is_given) {
            target.relative = usual;
        }
        self
    }
}
