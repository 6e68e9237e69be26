//! `oilwedge mesh`: the mesh of a scene's liner as a gmsh file.

use crate::complain::Failure;
use crate::terminal::print;
use oilwedge_report::write_mesh;
use oilwedge_scene::Scene;
use oilwedge_study::compile::compile;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

/// Arguments of `oilwedge mesh`.
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct MeshCommand {
    /// The scene: a TOML file that describes one bearing.
    #[arg(value_name = "SCENE")]
    scene: PathBuf,

    /// The file to write: gmsh 4.1, text, 6-node triangles, named groups; lengths in metres, unrolled.
    #[arg(short, long, value_name = "FILE.msh")]
    output: PathBuf,
}

const EXAMPLES: &str = "\
Examples:
  oilwedge mesh bearing.toml -o liner.msh
  oilwedge mesh bearing.toml -o liner.msh && gmsh liner.msh

Exit status: 0 written; 2 the scene or its liner cannot be meshed, or the file cannot be written.";

impl MeshCommand {
    /// Meshes the liner and writes it.
    ///
    /// # Errors
    /// [`Failure`]: the scene cannot be used, its liner cannot be meshed, or the file cannot be written.
    pub(crate) fn run(&self) -> Result<ExitCode, Failure> {
        let scene = oilwedge_study::read(&self.scene)?;
        self.check_output(&scene)?;
        self.check_form()?;
        let mesh = compile(&scene).and_then(|model| model.first_mesh()).map_err(Failure::of(&self.scene))?.mesh;
        write_mesh(&mesh, &self.output)?;
        let (cells, nodes) = (mesh.triangles().len(), mesh.quadratic_nodes());
        let text = format!("{}: {cells} triangles, {nodes} nodes\n", self.output.display());
        print(&text, Some(&self.output))?;
        Ok(ExitCode::SUCCESS)
    }

    /// Refuses a name that gmsh and `[mesh] file` do not know the form by. What is no plain file (`/dev/stdout`) has
    /// none.
    fn check_form(&self) -> Result<(), Failure> {
        let is_msh = (self.output.extension()).is_some_and(|ending| ending.eq_ignore_ascii_case("msh"));
        let is_plain = self.output.is_file() || !self.output.exists();
        match is_msh || !is_plain {
            true => Ok(()),
            false => Err(Failure::Message(format!(
                "--output {}: a gmsh file (.msh) is the only form that is written; give a name that ends in .msh (gmsh writes others of it, and `oilwedge solve --out` writes film.vtu)",
                self.output.display()
            ))),
        }
    }

    /// The mesh must not replace the scene or the mesh file from which it is made.
    fn check_output(&self, scene: &Scene) -> Result<(), Failure> {
        let output = self.output.canonicalize().ok();
        let is_input = |path: &Path| output.is_some() && path.canonicalize().ok() == output;
        let input = [Some(self.scene.as_path()), scene.mesh.path()].into_iter().flatten();
        match input.into_iter().find(|path| is_input(path)) {
            None => Ok(()),
            Some(path) => Err(Failure::Message(format!(
                "--output {} would replace {}, from which the mesh is made; give another name",
                self.output.display(),
                path.display()
            ))),
        }
    }
}
