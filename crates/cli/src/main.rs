//! `oilwedge`: the oil film of journal bearings at the command line. One file a verb.
//!
//! Exit status: 0 done; 1 the problem has no solution or was not converged, or stdout failed after the results were
//! written; 2 bad scene, mesh or arguments, and then nothing was written; 130 interrupted. Results for people and
//! `--json` go to stdout, everything else to stderr.

mod characteristics;
mod characteristics_report;
mod check;
mod check_report;
mod complain;
mod converge;
mod crankshaft;
mod design;
mod diff;
mod explain;
mod interrupt;
mod levels_table;
mod load;
mod mesh;
mod new;
mod oil;
mod plot;
mod progress;
mod readable;
mod report;
mod run_options;
mod schema;
mod shell;
mod solve;
mod sweep;
mod terminal;
mod verify;

use clap::{CommandFactory, Parser, Subcommand};
use complain::Failure;
use std::process::ExitCode;

/// The oil film of journal bearings: load, attitude angle, pressures and flows from one scene.
#[derive(Debug, Parser)]
#[command(version, after_help = EXAMPLES, max_term_width = 110)]
struct Arguments {
    #[command(subcommand)]
    verb: Verb,

    /// Number of threads; by default one for each core. Results do not depend on it.
    #[arg(long, global = true, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=1024))]
    threads: Option<u16>,
}

const EXAMPLES: &str = "\
Examples:
  oilwedge solve scenes/01_plain_ring.toml         solve, print the numbers, write out/01_plain_ring/
  oilwedge solve bearing.toml --json > load.json   the numbers as JSON for a script
  oilwedge solve bearing.toml --cost               also: what each effect changes, and its run time
  oilwedge solve bearing.toml --theories           also: short and long bearing theory
  oilwedge solve engine.toml                       a crankshaft on the films of all its bearings
  oilwedge check bearing.toml                      what would be computed, and the quality of the mesh
  oilwedge check liner.msh                         a gmsh 4.1 mesh alone
  oilwedge mesh bearing.toml -o liner.msh          mesh its liner, to a gmsh file
  oilwedge converge bearing.toml                   the cost of accuracy, in unknowns and seconds
  oilwedge sweep bearing.toml                      solve all cases of its [sweep], to a table
  oilwedge design bearing.toml                     the numbers of its [design] that serve best
  oilwedge load big_end.toml                       the load over a cycle, and its polar diagrams
  oilwedge characteristics bearing.toml            force and moment for each motion by itself
  oilwedge report out/bearing --open               one page about results, in the browser
  oilwedge oil SAE 10W-40 --at \"80 C\"              viscosity and density of an oil
  oilwedge new bearing.toml --kind groove          a scene with comments to begin with
  oilwedge explain side_flow                       what a name means
  oilwedge diff before.toml after.toml             what changed, against the error bars
  oilwedge verify                                  check this program against known answers

Exit status: 0 done; 1 no solution or not converged, or results written but stdout failed; 2 bad scene, mesh or arguments (nothing was written);
130 ended by Ctrl-C.";

#[derive(Debug, Subcommand)]
enum Verb {
    /// Solve a scene: the numbers to the terminal and result.json, the fields to film.vtu.
    Solve(solve::Solve),
    /// Read a scene and its mesh, or a mesh alone, and show what it holds or what is wrong with it.
    Check(check::CheckCommand),
    /// Mesh the liner that a scene describes and write it for gmsh.
    Mesh(mesh::MeshCommand),
    /// Solve a scene on ever finer meshes by three strategies, and show what accuracy costs.
    Converge(converge::Converge),
    /// Solve a scene for all values of its [sweep], to a table with one row a case.
    Sweep(sweep::SweepCommand),
    /// Find the numbers of a scene that make a quantity least or greatest, by its [design] and [criteria].
    Design(design::DesignCommand),
    /// Print and draw the load of a scene over a cycle.
    Load(load::LoadCommand),
    /// Solve the film of each motion of the journal by itself: its sixteen characteristics, and their sum beside the
    /// film.
    Characteristics(characteristics::CharacteristicsOf),
    /// Draw the film of a scene, or the results in a folder, as SVG and PNG.
    Plot(plot::Plot),
    /// Write one HTML page about the results in a folder.
    Report(report::Report),
    /// Show viscosity and density of an oil by temperature, or which oils a scene may name.
    Oil(oil::OilCommand),
    /// Write a scene with comments to begin with, and its schema.
    New(new::New),
    /// Explain a quantity, effect, key of a scene, field or warning by its name.
    Explain(explain::Explain),
    /// Compare two scenes or results: changed keys, and whether changed quantities exceed their error bars.
    Diff(diff::Diff),
    /// Print the JSON schema of scenes, for editors.
    Schema(schema::Schema),
    /// Print the completion script of a shell.
    Completions(shell::Completions),
    /// Write the manual pages.
    Man(shell::Man),
    /// Check this program against cases with known answers, or against all hard cases.
    Verify(verify::Verify),
}

fn main() -> ExitCode {
    let arguments = Arguments::parse();
    let outcome = use_threads(arguments.threads).and_then(|()| match &arguments.verb {
        Verb::Solve(solve) => solve.run(),
        Verb::Check(check) => check.run(),
        Verb::Mesh(mesh) => mesh.run(),
        Verb::Converge(converge) => converge.run(),
        Verb::Sweep(sweep) => sweep.run(),
        Verb::Design(design) => design.run(),
        Verb::Load(load) => load.run(),
        Verb::Characteristics(characteristics) => characteristics.run(),
        Verb::Plot(plot) => plot.run(),
        Verb::Report(report) => report.run(),
        Verb::Oil(oil) => oil.run(),
        Verb::New(new) => new.run(),
        Verb::Explain(explain) => explain.run(),
        Verb::Diff(diff) => diff.run(),
        Verb::Schema(schema) => schema.run(),
        Verb::Completions(completions) => completions.run(Arguments::command()),
        Verb::Man(man) => man.run(Arguments::command()),
        Verb::Verify(verify) => verify.run(),
    });
    outcome.unwrap_or_else(|failure| {
        let status = failure.status();
        failure.report();
        ExitCode::from(status)
    })
}

/// The main thread is one of the pool's, so that no work is handed over where there is nothing to share.
fn use_threads(threads: Option<u16>) -> Result<(), Failure> {
    let threads = threads.map_or(0, usize::from);
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).use_current_thread().build_global();
    pool.map_err(|error| {
        Failure::Message(format!("cannot start {threads} threads: {error}; give fewer with --threads"))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_arguments_are_consistent() {
        Arguments::command().debug_assert();
    }

    #[test]
    fn threads_may_stand_behind_the_verb() {
        let arguments = Arguments::try_parse_from(["oilwedge", "solve", "a.toml", "--threads", "2", "--json"]);
        assert!(arguments.is_ok_and(|arguments| arguments.threads == Some(2)));
        assert!(Arguments::try_parse_from(["oilwedge", "solve", "a.toml", "--threads", "0"]).is_err());
        assert!(Arguments::try_parse_from(["oilwedge", "solve"]).is_err());
    }
}
