//! `[[bore]]`: what the bore is beside a circle. The depths of all tables add up.

use std::path::{Path, PathBuf};

use crate::reader::TableReader;
use crate::{Complaints, Scene, TheoryKey};

keys! {
    "bore" = Tables; "", "the bore is a circle", "each with one of `crown`, `oval`, `worn`, `envelope` and `file`",
        "shapes of the bore, any number: how much deeper than its circle it is; their depths add up";
    "bore.crown" = Quantity(Length); "5 um", "no crown", "any",
        "depth at both ends of a bore that widens from its middle as (z/b)^2, b half of the length (hyperbolic bore); negative where it narrows";
    "bore.oval" = Table; "", "no ovality", "",
        "the second harmonic of the bore, depth cos 2(phi - angle)";
    "bore.oval.depth" = Quantity(Length); "5 um", "required", "any",
        "how much wider the radius is at `angle` and opposite to it, and narrower across";
    "bore.oval.angle" = Quantity(Angle); "90 deg", "required", "",
        "angle at which the bore is widest";
    "bore.worn" = Table; "", "no wear", "",
        "a pit of parabolic section all along the bore";
    "bore.worn.depth" = Quantity(Length); "10 um", "required", ">= 0",
        "greatest depth of the pit";
    "bore.worn.angle" = Quantity(Angle); "250 deg", "required", "",
        "angle of its middle";
    "bore.worn.half_width" = Quantity(Angle); "40 deg", "required", "> 0, < 180 deg",
        "angle from its middle to each of its edges";
    "bore.envelope" = Table; "", "no run-in bore", "",
        "wear by a journal in several positions, until none of them leaves less than a given film: the bore follows the envelope of its lines";
    "bore.envelope.file" = Text; "bores/positions.csv", "required", "a table with units in its header: `e_x [um], e_y [um]` and, if wanted, `g_x [mrad], g_y [mrad]`; or an `orbit.csv` as it was written",
        "path of a table of the positions, offset of the journal at mid-length and slope of its axis, counted from the folder of the scene. Offsets of an `orbit.csv` are over the clearance of this scene";
    "bore.envelope.film" = Quantity(Length); "2 um", "required", ">= 0",
        "film that is left in every position";
    "bore.file" = Text; "bores/measured.csv", "no measured shape", "a table with units in its header: `angle [deg], z [mm], depth [um]`, and the depth at each point of a grid",
        "path of a table of measured depths, counted from the folder of the scene. Without `angle` the bore is the same all around";
}

/// One shape of a bore.
#[derive(Debug, Clone, PartialEq)]
pub enum Bore {
    /// Depth at the ends [m] of a bore that widens as the square of the distance from its middle.
    Crown(f64),
    /// The second harmonic.
    Oval {
        /// Depth [m] where it is widest.
        depth: f64,
        /// Angle of that [rad].
        angle: f64,
    },
    /// A pit of parabolic section.
    Worn {
        /// Greatest depth [m].
        depth: f64,
        /// Angle of its middle [rad].
        angle: f64,
        /// Angle from its middle to an edge [rad].
        half_width: f64,
    },
    /// Wear by a journal in the positions of a table.
    Envelope {
        /// File of the positions.
        path: PathBuf,
        /// Film that is left [m].
        film: f64,
    },
    /// Depths of a table in this file.
    Measured(PathBuf),
}

impl Bore {
    /// The file that it needs, and the key of that.
    pub(crate) fn file(&self) -> Option<(&'static str, &Path)> {
        match self {
            Self::Envelope { path, .. } => Some(("envelope.file", path)),
            Self::Measured(path) => Some(("file", path)),
            Self::Crown(_) | Self::Oval { .. } | Self::Worn { .. } => None,
        }
    }
}

const SHAPES: [&str; 5] = ["crown", "oval", "worn", "envelope", "file"];

/// Reads one table; a file counts from the folder of the `scene`.
pub(crate) fn read(mut table: TableReader<'_>, scene: &Path) -> Bore {
    let crown = table.given("crown");
    let oval = table
        .table_if_given("oval")
        .map(|mut oval| Bore::Oval { depth: oval.required("depth"), angle: oval.required("angle") });
    let worn = table.table_if_given("worn").map(worn);
    let in_folder = |file: String| scene.parent().unwrap_or(Path::new("")).join(file);
    let envelope = table.table_if_given("envelope").map(|mut envelope| Bore::Envelope {
        path: in_folder(envelope.text("file")),
        film: (envelope.number("film"))
            .within("is negative", "give the film that is left in every position")
            .required(),
    });
    let file = table.text_if_given("file");
    let given: Vec<&str> = SHAPES.into_iter().filter(|key| table.has(key)).collect();
    let measured = file.map(|file| Bore::Measured(in_folder(file)));
    if given.is_empty() && table.is_readable() {
        table.complain_here(
            "has no shape",
            "give one of crown = \"5 um\", oval = { .. }, worn = { .. }, envelope = { .. } and file = \"bore.csv\", or remove the table: the bore is a circle",
        );
    }
    for key in given.iter().skip(1) {
        let message = format!("stands beside {}", given[0]);
        table.complain(key, message, "give each shape a [[bore]] of its own: their depths add up");
    }
    let crown = crown.map(Bore::Crown);
    crown.or(oval).or(worn).or(envelope).or(measured).unwrap_or(Bore::Crown(f64::NAN))
}

fn worn(mut table: TableReader<'_>) -> Bore {
    let depth = table.number("depth").within("is negative", "give how deep the pit is, counted from the circle");
    let depth = depth.required();
    let half_width = table.number("half_width").within(
        "is no half of a pit",
        "give the angle from the middle of the pit to one of its edges, more than 0 and less than 180 deg",
    );
    Bore::Worn { depth, half_width: half_width.required(), angle: table.required("angle") }
}

impl Scene {
    /// True if bore and shaft are circles.
    pub fn is_circular(&self) -> bool {
        self.bores.is_empty() && self.shaft.is_none()
    }

    /// True if the film may change along the axis by the shapes of bore and shaft.
    pub fn has_shape_along_the_axis(&self) -> bool {
        let is_along = |bore: &Bore| matches!(bore, Bore::Crown(_) | Bore::Envelope { .. } | Bore::Measured(_));
        self.shaft.is_some() || self.bores.iter().any(is_along)
    }
}

/// A long bearing knows no axial position.
pub(crate) fn check(scene: &Scene, complaints: &mut Complaints) {
    complaints.refuse_if(
        scene.bearing.theory == TheoryKey::Long && scene.has_shape_along_the_axis(),
        "bearing.theory",
        "is \"long\", but the shape of bore or shaft changes along the axis: a long film is the same all along it",
        "remove theory, or remove bore.crown, bore.file and [shaft]",
    );
}

#[cfg(test)]
mod tests {
    use std::f64::consts::PI;

    use super::*;
    use crate::scene::tests::{STUDY, read, told};

    fn bores(keys: &str) -> Vec<Bore> {
        read(&format!("{STUDY}\n[[bore]]\n{keys}\n")).expect("a scene").bores
    }

    #[test]
    fn the_shapes_are_read() {
        assert_eq!(bores("crown = \"-3 um\""), [Bore::Crown(-3e-6)]);
        let oval = Bore::Oval { depth: 5.0 * 1e-6, angle: 0.5 * PI };
        assert_eq!(bores("oval = { depth = \"5 um\", angle = \"90 deg\" }"), [oval]);
        let keys =
            "worn = { depth = \"10 um\", angle = \"0 deg\", half_width = \"45 deg\" }\n[[bore]]\nfile = \"a/b.csv\"";
        let worn = Bore::Worn { depth: 10.0 * 1e-6, angle: 0.0, half_width: 0.25 * PI };
        let found = bores(keys);
        assert_eq!(found[0], worn);
        assert!(matches!(&found[1], Bore::Measured(path) if path.ends_with("a/b.csv")));
        assert!(!read(&format!("{STUDY}\n[shaft]\ncrown = \"0 um\"\n")).expect("a scene").is_circular());
    }

    #[test]
    fn what_is_no_shape_is_refused() {
        for (keys, wanted) in [
            ("", "bore[0]: has no shape"),
            ("crown = \"1 um\"\noval = { depth = \"5 um\", angle = \"90 deg\" }", "bore[0].oval: stands beside crown"),
            (
                "worn = { depth = \"-1 um\", angle = \"0 deg\", half_width = \"45 deg\" }",
                "bore[0].worn.depth: is negative",
            ),
            (
                "worn = { depth = \"1 um\", angle = \"0 deg\", half_width = \"180 deg\" }",
                "bore[0].worn.half_width: is no half of a pit",
            ),
            ("crown = 5", "bore[0].crown: a bare number"),
            ("barrel = \"5 um\"", "bore[0].barrel: this key is not known"),
        ] {
            let error = read(&format!("{STUDY}\n[[bore]]\n{keys}\n")).expect_err(keys).to_string();
            assert!(error.contains(wanted), "{error}");
        }
        let long = told("clearance =", "theory = \"long\", clearance =");
        assert!(!long.is_empty());
    }
}
