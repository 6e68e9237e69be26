//! `[liner]`: how the wall of the bearing gives way to the pressure of the film.

use std::path::{Path, PathBuf};

use crate::reader::TableReader;
use crate::wording::bars;
use crate::{Complaints, Scene};

keys! {
    "liner" = Table; "", "the liner is rigid", "",
        "how the wall of the bearing gives way to the pressure of the film, by one of its three keys";
    "liner.winkler" = Quantity(LayerCompliance), Table; "0.02 um/MPa", "no such layer", "> 0",
        "displacement of the surface for each pressure on it: a thin layer bonded to a rigid housing, each place by itself; or what it is made of";
    "liner.winkler.thickness" = Quantity(Length); "0.3 mm", "required", "> 0",
        "thickness t of the layer; its displacement for each pressure is t (1 - 2 nu)(1 + nu)/(E (1 - nu))";
    "liner.winkler.modulus" = Quantity(Pressure); "50 GPa", "required", "> 0",
        "Young's modulus E";
    "liner.winkler.poisson" = Number; "0.35", "required", "0 to 0.499",
        "Poisson's ratio nu";
    "liner.wall" = Table; "", "no such wall", "",
        "a ring of one material in plane strain: each slice across the axis moves by itself";
    "liner.wall.thickness" = Quantity(Length); "10 mm", "required", "> 0",
        "thickness t of the wall";
    "liner.wall.modulus" = Quantity(Pressure); "210 GPa", "required", "> 0",
        "Young's modulus E";
    "liner.wall.poisson" = Number; "0.3", "required", "0 to 0.499",
        "Poisson's ratio nu";
    "liner.wall.outer" = Choice(&["clamped", "free"]); "clamped", "`\"clamped\"`", "",
        "whether the outer surface is held by a rigid housing, or free as that of the eye of a rod";
    "liner.compliance" = Table; "", "no such matrix", "",
        "a matrix of displacements for unit forces, condensed by a structural program";
    "liner.compliance.file" = Text; "../walls/eye.csv", "required", "",
        "path of the table of the matrix, counted from the folder of the scene";
}

/// What holds the outer surface of a ring.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum OuterSurface {
    /// A rigid housing.
    Clamped,
    /// The outer surface is free of stress.
    Free,
}

/// A wall of one material.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct WallMaterial {
    /// Thickness t of the wall [m].
    pub thickness: f64,
    /// Young's modulus E [Pa].
    pub modulus: f64,
    /// Poisson's ratio nu [1].
    pub poisson: f64,
}

/// A layer whose places move by themselves.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Layer {
    /// Displacement for each pressure [m/Pa].
    Given(f64),
    /// Displacement of a thin layer of this material on a rigid housing.
    Of(WallMaterial),
}

/// How the wall gives way.
#[derive(Debug, Clone, PartialEq)]
pub enum Liner {
    /// Each place by itself.
    Winkler(Layer),
    /// Each slice as a ring in plane strain.
    Wall {
        /// What it is made of.
        of: WallMaterial,
        /// What holds its outer surface.
        outer: OuterSurface,
    },
    /// A matrix of compliances.
    Compliance {
        /// File of the matrix.
        file: PathBuf,
    },
}

impl Liner {
    /// The file of its matrix, if it has one.
    pub(crate) fn file(&self) -> Option<&Path> {
        match self {
            Self::Compliance { file } => Some(file),
            Self::Winkler(_) | Self::Wall { .. } => None,
        }
    }
}

/// Reads the table of a scene that stands at `scene`; `None` where it is none.
pub(crate) fn read(mut table: TableReader<'_>, scene: &Path) -> Option<Liner> {
    let keys = ["winkler", "wall", "compliance"];
    let given: Vec<&str> = keys.into_iter().filter(|key| table.has(key)).collect();
    if given.len() != 1 && table.is_readable() {
        let message = match given[..] {
            [] => "says not how the wall gives way".to_owned(),
            _ => format!("has {} keys that say how the wall gives way: {}", given.len(), given.join(", ")),
        };
        table.complain_here(
            message,
            "give one of winkler = \"0.02 um/MPa\", wall = { thickness = \"10 mm\", modulus = \"210 GPa\", poisson = 0.3 } and compliance = { file = \"eye.csv\" }",
        );
    }
    let layer = match table.holds_table("winkler") {
        true => (table.table_if_given("winkler")).map(|mut table| Layer::Of(material(&mut table))),
        false => (table.given("winkler")).map(Layer::Given),
    };
    let wall = table.table_if_given("wall").map(wall);
    let matrix = table.table_if_given("compliance").map(|table| matrix(table, scene));
    layer.map(Liner::Winkler).or(wall).or(matrix)
}

fn wall(mut table: TableReader<'_>) -> Liner {
    Liner::Wall {
        of: material(&mut table),
        outer: table
            .word("outer", &[("clamped", OuterSurface::Clamped), ("free", OuterSurface::Free)])
            .unwrap_or(OuterSurface::Clamped),
    }
}

/// Thickness, modulus and Poisson's ratio.
fn material(table: &mut TableReader<'_>) -> WallMaterial {
    WallMaterial {
        thickness: table.required("thickness"),
        modulus: table.required("modulus"),
        poisson: (table.number("poisson"))
            .within(
                "lies outside of 0 to 0.499",
                "give Poisson's ratio; a wall that is nearly incompressible takes 0.499",
            )
            .required(),
    }
}

fn matrix(mut table: TableReader<'_>, scene: &Path) -> Liner {
    let file = table.text("file");
    Liner::Compliance { file: scene.parent().unwrap_or(Path::new("")).join(file) }
}

/// Refuses a wall that the load would press through: far too soft, mostly by its unit.
pub(crate) fn check(scene: &Scene, complaints: &mut Complaints) {
    if ["liner", "bearing", "load.force"].iter().any(|table| complaints.concern(table)) {
        return;
    }
    let (key, material) = match &scene.liner {
        Some(Liner::Winkler(Layer::Of(material))) => ("liner.winkler.modulus", material),
        Some(Liner::Wall { of, .. }) => ("liner.wall.modulus", of),
        _ => return,
    };
    let Some([x, y]) = scene.journal.load() else { return };
    let pressure = x.hypot(y) / (scene.bearing.diameter * scene.bearing.length);
    complaints.refuse_if(
        pressure >= confined(material),
        key,
        format!(
            "is too soft: the mean pressure of the load, {}, presses the wall in by its whole thickness",
            bars(pressure)
        ),
        "give the modulus of the wall's material, such as \"210 GPa\" of steel or \"2 GPa\" of a polymer; is its unit right?",
    );
}

/// Modulus [Pa] of a layer that cannot move sideways: `E (1 - nu)/((1 + nu) (1 - 2 nu))`.
fn confined(material: &WallMaterial) -> f64 {
    let (modulus, poisson) = (material.modulus, material.poisson);
    modulus * (1.0 - poisson) / ((1.0 + poisson) * (1.0 - 2.0 * poisson))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::tests::{STUDY, read};

    fn asked(keys: &str) -> Result<Liner, String> {
        let scene = read(&format!("{STUDY}\n[liner]\n{keys}\n")).map_err(|error| error.to_string())?;
        Ok(scene.liner.expect("the table is there"))
    }

    #[test]
    fn walls_are_read() {
        let Ok(Liner::Winkler(Layer::Given(per_pressure))) = asked("winkler = \"0.02 um/MPa\"") else {
            panic!("a layer");
        };
        assert!((per_pressure / 2e-14 - 1.0).abs() < 1e-14);
        let ring = "wall = { thickness = \"10 mm\", modulus = \"210 GPa\", poisson = 0.3";
        for (more, outer) in [(" }", OuterSurface::Clamped), (", outer = \"free\" }", OuterSurface::Free)] {
            let of = WallMaterial { thickness: 10.0 * 1e-3, modulus: 210.0 * 1e9, poisson: 0.3 };
            assert_eq!(asked(&format!("{ring}{more}")), Ok(Liner::Wall { of, outer }));
        }
        let metal = WallMaterial { thickness: 0.3 * 1e-3, modulus: 50.0 * 1e9, poisson: 0.35 };
        assert_eq!(
            asked("winkler = { thickness = \"0.3 mm\", modulus = \"50 GPa\", poisson = 0.35 }"),
            Ok(Liner::Winkler(Layer::Of(metal)))
        );
        let Ok(Liner::Compliance { file }) = asked("compliance = { file = \"eye.csv\" }") else {
            panic!("a matrix");
        };
        assert!(file.ends_with("eye.csv"));
        assert_eq!(read(STUDY).expect("a scene").liner, None);
    }

    #[test]
    fn what_is_no_wall_is_refused() {
        let refused = |keys: &str, wanted: &str| {
            let error = asked(keys).expect_err(wanted);
            assert!(error.contains(wanted), "{error}");
        };
        refused("", "liner: says not how the wall gives way");
        refused(
            "winkler = \"1 um/MPa\"\ncompliance = { file = \"a.csv\" }",
            "liner: has 2 keys that say how the wall gives way: winkler, compliance",
        );
        refused("winkler = \"0 um/MPa\"", "liner.winkler: is not positive");
        refused("winkler = 0.02", "liner.winkler: a bare number has no unit");
        refused("winkler = \"1 um\"", "is a unit of length, but a deflection by pressure is wanted");
        let ring = |keys: &str| format!("wall = {{ thickness = \"1 mm\", modulus = \"3 GPa\", {keys} }}");
        refused(&ring("poisson = 0.5"), "liner.wall.poisson: lies outside of 0 to 0.499");
        refused(&ring("poisson = -0.1"), "liner.wall.poisson: lies outside of 0 to 0.499");
        refused(&ring("poisson = 0.3, outer = \"fixed\""), "\"fixed\" is not known");
        refused("wall = {}", "liner.wall.thickness: is missing");
        refused("compliance = {}", "liner.compliance.file: is missing");
        refused("stiffness = 3", "liner.stiffness: this key is not known");
    }
}
