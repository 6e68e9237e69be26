//! `[mesh]`: where the mesh comes from; its key `tolerance` is in `tolerance.rs`.

use std::path::{Path, PathBuf};

use crate::reader::TableReader;
use crate::tolerance::{self, Tolerance};
use crate::unit::{self, Dimension};

keys! {
    "mesh" = Table; "", "the liner described is meshed, as the film needs", "",
        "where the mesh of the liner comes from, and how accurate the results must be";
    "mesh.file" = Text; "../meshes/liner.msh", "the liner described is meshed", "a gmsh 4.1 file",
        "path of a mesh file, counted from the folder of the scene";
    "mesh.size" = Quantity(Length); "3 mm", "as the film needs", "> 0",
        "longest edges of a mesh made here, shorter where the film is thin and at rims; with `file` its geometry is meshed anew";
    "mesh.tolerance" = Quantity(Ratio), Table; "0.1 %", "without `file` and `size` 0.5 % of the main quantity (0.1 % with `theory = \"short\"`), and where that is cheap 2 % of greatest pressure, least film, side flow and friction torque; with one of them the mesh is used as it is", "1e-8 % to 50 %",
        "how small error bars must become by refinement of that mesh: one ratio for the main quantity, or a table of them by quantity";
    "mesh.tolerance.QUANTITY" = Quantity(Ratio); "0.1 %", "the quantity has no tolerance", "1e-8 % to 50 %",
        "how small the error bar of this quantity must become relative to its value; that of an angle relative to 1 rad";
    "mesh.layout" = Choice(&["rows", "file"]); "rows", "`\"rows\"`", "with `file`, without `size`, for `model = \"jfo\"`",
        "`\"rows\"`: triangles of the file that do not follow the flow are laid anew in rows along it, with the geometry and edge lengths of the file; `\"file\"`: they stay. Then a film whose oil they spread has no error bar";
    "mesh.unit" = Text; "mm", "`\"m\"`", "name of a length unit",
        "unit of the file's coordinates";
}

/// Origin of the mesh.
#[derive(Debug, Clone, PartialEq)]
pub enum MeshSource {
    /// A gmsh file.
    File {
        /// The file; a relative path of the scene counts from the folder of the scene.
        path: PathBuf,
        /// Length of one unit of the file's coordinates [m].
        unit: f64,
        /// Longest edges wanted [m] where its geometry is meshed anew; `None`: the mesh is used as it is.
        size: Option<f64>,
        /// Layout of the triangles of a mass-conserving film.
        layout: Layout,
    },
    /// The liner that the scene describes is meshed.
    Drawing {
        /// Longest edges wanted [m]; `None`: as the film needs.
        size: Option<f64>,
    },
}

/// Where the triangles of a mesh file lie if the film conserves oil, which is carried along the flow.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Layout {
    /// Rows along the flow: generated anew where those of the file are not.
    #[default]
    Rows,
    /// The layout in the file.
    File,
}

impl MeshSource {
    /// Whether its size follows the thickness of the film, and so the position of the journal.
    pub fn is_graded(&self) -> bool {
        match self {
            Self::File { size, .. } => size.is_some(),
            Self::Drawing { .. } => true,
        }
    }

    /// Longest edges wanted [m], if they are.
    pub fn size(&self) -> Option<f64> {
        match self {
            Self::File { size, .. } | Self::Drawing { size } => *size,
        }
    }

    /// The mesh file, if there is one.
    pub fn path(&self) -> Option<&Path> {
        match self {
            Self::File { path, .. } => Some(path),
            Self::Drawing { .. } => None,
        }
    }
}

/// Reads the table of a scene that stands at `scene`. Without a file the liner is meshed, as the film needs where no
/// size is given; a file with a size is meshed anew.
pub(crate) fn read(table: Option<TableReader<'_>>, scene: &Path) -> (MeshSource, Option<Tolerance>) {
    let Some(mut table) = table else {
        return (MeshSource::Drawing { size: None }, Some(Tolerance::Usual));
    };
    let has_file = table.has("file");
    let file = table.text_if_given("file");
    let size = table.given("size");
    let name = table.text_if_given("unit");
    table.refuse_if(
        name.is_some() && !has_file,
        "unit",
        "has a meaning for a mesh file only",
        "remove unit, or give the file",
    );
    let unit = name.map_or(1.0, |name| {
        unit::unit_size(&name, Dimension::Length).unwrap_or_else(|error| {
            table.complain("unit", error.to_string(), error.help("mm"));
            f64::NAN
        })
    });
    let layout = table.word("layout", &[("rows", Layout::Rows), ("file", Layout::File)]);
    table.refuse_if(
        layout.is_some() && (!has_file || size.is_some()),
        "layout",
        "has a meaning for a mesh file that is used as it is",
        "remove layout, or give the file without size",
    );
    let is_bare = !has_file && !table.has("size") && !table.has("tolerance");
    let tolerance = tolerance::read(&mut table).or(is_bare.then_some(Tolerance::Usual));
    let source = match has_file {
        false => MeshSource::Drawing { size },
        true => MeshSource::File {
            path: scene.parent().unwrap_or(Path::new("")).join(file.unwrap_or_default()),
            unit,
            size,
            layout: layout.unwrap_or_default(),
        },
    };
    (source, tolerance)
}

/// Why there is no plain file `path`, as the end of a sentence.
pub(crate) fn no_file(path: &Path) -> Option<String> {
    let path_text = path.display();
    match std::fs::metadata(path) {
        Ok(metadata) if metadata.is_file() => None,
        Ok(metadata) if metadata.is_dir() => Some(format!("{path_text} is a folder, not a file")),
        Ok(_) => Some(format!("{path_text} is not a plain file")),
        Err(error) if error.kind() == std::io::ErrorKind::NotFound => Some(format!("there is no file {path_text}")),
        Err(error) => Some(format!("cannot read {path_text}: {error}")),
    }
}
