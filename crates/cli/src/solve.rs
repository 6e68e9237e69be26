//! `oilwedge solve`: one scene to numbers and fields.

use crate::complain::{self, Failure};
use crate::crankshaft;
use crate::interrupt::{self, LatestAnswer};
use crate::plot;
use crate::progress::ProgressLine;
use crate::report::PageArguments;
use crate::run_options::RunArguments;
use crate::terminal::{exit_code, output};
use oilwedge_campaign::{Compare, Records, with_derivatives};
use oilwedge_report::frames::{COLLECTION_FILE, write_frames};
use oilwedge_report::orbit_course::OrbitCourse;
use oilwedge_report::orbit_table::orbit_table;
use oilwedge_report::page::{Extras, PAGE_FILE, SceneFile, film_page};
use oilwedge_report::result_json;
use oilwedge_report::results::{ResultCompanions, earlier_orbit, write_results};
use oilwedge_report::tables::{ShownQuantities, Written, run_report};
use oilwedge_report::vtu::{Compression, Precision, VtuForm, to_vtu};
use oilwedge_scene::Scene;
use oilwedge_scene::sweep::Plan;
use oilwedge_study::model::Model;
use oilwedge_study::orbit::{Frame, no_map};
use oilwedge_study::picture::{FieldChoice, FilmPicture, PictureOptions, Surface};
use oilwedge_study::result::Status;
use oilwedge_study::shaft::Variant;
use oilwedge_study::{Run, RunOptions, compile, run_telling};
use std::path::Path;
use std::process::ExitCode;

/// Arguments of `oilwedge solve`.
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Solve {
    #[command(flatten)]
    run: RunArguments,

    /// Draw film.vtu on the unrolled liner (x = R phi, y = z) instead of on the cylinder.
    #[arg(long)]
    unrolled: bool,

    /// Compression of film.vtu; meshio does not read lz4 [default: none up to 100 000 nodes, else lz4].
    #[arg(long, value_enum, value_name = "FORM")]
    vtu: Option<Vtu>,

    /// Write the numbers of film.vtu with 32 bits, but for the pressure and the places of nodes.
    #[arg(long)]
    float32: bool,

    /// Fields of film.vtu: all, or all but flow and shear stresses.
    #[arg(long, value_enum, value_name = "FIELDS", default_value = "usual")]
    fields: Fields,

    /// Draw so many films of the cycle of an orbit, at even crank angles: film.pvd, an animation for ParaView.
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=3600))]
    frames: Option<u32>,

    /// Show all quantities, not the main ones only, and the balance of heat.
    #[arg(long)]
    all: bool,

    /// Draw pictures of the film into the folder plot of the results.
    #[arg(long)]
    plot: bool,

    /// With [heat]: draw friction and heat carried off at temperatures around the one found (heat.svg, heat.png), as
    /// --plot and --report do.
    #[arg(long)]
    curve: bool,

    #[command(flatten)]
    page: PageArguments,

    /// Solve again without each effect, and show what it changes and what it costs.
    #[arg(long)]
    cost: bool,

    /// Show what ISO 7902 (DIN 31652) gives for the same bearing.
    #[arg(long)]
    standard: bool,

    /// Solve again as a short and as a long bearing, and show the error of these theories.
    #[arg(long)]
    theories: bool,

    /// Begin the orbit anew; without it one that was not closed, or was ended by Ctrl-C, is continued from the results
    /// in the folder.
    #[arg(long)]
    fresh: bool,

    /// Seek the counterweights of a crankshaft that make the least film of all bearings greatest, on the webs that have
    /// one, and show both.
    #[arg(long)]
    counterweights: bool,

    /// Solve a crankshaft cut at its bearings too, and show both.
    #[arg(long)]
    cut: bool,

    /// Show how each quantity changes with each number of the scene; of a cycle with those that have tolerances, two
    /// cycles each.
    #[arg(long)]
    sensitivity: bool,

    /// Follow the orbit by maps of the film too, that of a short film and its own, and show their differences and
    /// times.
    #[arg(long)]
    mobility: bool,
}

/// How film.vtu is compressed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
enum Vtu {
    /// No file of fields.
    None,
    /// Compressed by LZ4: fast.
    Lz4,
    /// Compressed by zlib: the smallest files.
    Zlib,
}

/// Which fields film.vtu has.
#[derive(Debug, Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
enum Fields {
    /// All but flow and shear stresses.
    Usual,
    /// All.
    All,
}

impl From<Vtu> for Compression {
    fn from(vtu: Vtu) -> Self {
        match vtu {
            Vtu::None => Self::None,
            Vtu::Lz4 => Self::Lz4,
            Vtu::Zlib => Self::Zlib,
        }
    }
}

const EXAMPLES: &str = "\
Examples:
  oilwedge solve bearing.toml
  oilwedge solve bearing.toml --all
  oilwedge solve bearing.toml --out results/today --unrolled --vtu zlib
  oilwedge solve bearing.toml --fields all --float32
  oilwedge solve bearing.toml --json | jq .quantities.load.value
  oilwedge solve bearing.toml --open
  oilwedge solve bearing.toml --cost
  oilwedge solve bearing.toml --standard
  oilwedge solve bearing.toml --theories
  oilwedge solve bearing.toml --sensitivity
  oilwedge solve big_end.toml --mobility
  oilwedge solve big_end.toml --frames 72
  oilwedge solve engine.toml --cut --report
  oilwedge solve bearing.toml --bars none
  oilwedge solve bearing.toml --max-seconds 600 --max-unknowns 5000000

Exit status: 0 done; 1 no solution, not converged, or a tolerance that a limit or Ctrl-C left unmet (the reason is in the result);
2 bad scene, mesh or arguments; 130 ended by Ctrl-C without results: by its second, or where there is no tolerance and no load.";

impl Solve {
    /// Solves the scene, writes the results, and prints them.
    ///
    /// # Errors
    /// [`Failure`]: the scene or its mesh cannot be used, or the results cannot be written.
    pub(crate) fn run(&self) -> Result<ExitCode, Failure> {
        let path = &self.run.scene;
        let scene = match oilwedge_study::read(path) {
            Err(error) if crankshaft::is_crankshaft(&error) => return self.crankshaft(),
            other => other?,
        };
        // An orbit that is ended still counts its cycles that are complete.
        let interrupt = match &scene.orbit {
            Some(_) => interrupt::listen()?,
            None => interrupt::listen_in_time(interrupt::NOTHING)?,
        };
        interrupt::end_with(self.end());
        let options = RunOptions {
            picture: PictureOptions {
                surface: if self.unrolled { Surface::Developed } else { Surface::Cylinder },
                fields: match self.fields {
                    Fields::Usual => FieldChoice::Usual,
                    Fields::All => FieldChoice::All,
                },
            },
            frames: self.frames.unwrap_or(0),
            curve: self.curve || self.plot || self.page.is_wanted(),
            earlier: earlier_orbit(&self.run.folder(), &scene).filter(|_| !self.fresh),
            ..self.run.options(&scene, interrupt)?
        };
        let working = ProgressLine::of(Self::task(&scene));
        let observed = RunOptions { observer: Some(working.observer()), ..options };
        let model = compile(&scene).map_err(Failure::of(path))?;
        self.check_compared(&scene, &model)?;
        let keep = |result| interrupt::keep(LatestAnswer { result, orbit: None });
        let run = run_telling(&model, &observed, Some(&keep)).map_err(Failure::of(path))?;
        if options.earlier.is_some() && run.result.orbit.is_none() && interrupt.is_asked() {
            return Err(Failure::Interrupted(format!(
                "ended before the next cycle was complete; the results in {} stay those of the cycles before",
                self.run.folder().display()
            )));
        }
        let inputs = scene.differentiated(self.sensitivity);
        if !inputs.is_empty() {
            working.turns_to("how numbers change with those of the scene");
        }
        let (result, reasons) = with_derivatives(&scene, &run, inputs, &options);
        complain::warn(&reasons);
        // Its factors are large.
        drop(run.solved);
        let run = Run { result, solved: None, ..run };
        let mut records = Records::default();
        for kind in self.compared() {
            working.turns_to(kind.task());
            kind.solve((&scene, &model), &options, &run, &mut records)?;
        }
        drop(working);
        let json = result_json(&run.result, &records)?;
        let orbit = run.orbit.as_ref().map(orbit_table).transpose()?;
        interrupt::keep(LatestAnswer { result: run.result.clone(), orbit: orbit.clone() });
        let course = run.orbit.as_ref().map(OrbitCourse::of_path);
        let figures = match self.plot {
            true => plot::figures_of_run(&run.result, run.picture.as_ref(), course.as_ref(), &plot::usual())?,
            false => Vec::new(),
        };
        let page = self.page.made(|| {
            let files = SceneFile::all(&scene.text, path);
            let extras = Extras { records: Some(&records), course: course.as_ref(), files: &files };
            film_page(&run.result, run.picture.as_ref(), extras)
        })?;
        let picture = run.picture.map(|picture| to_vtu(&picture, self.form(&picture)));
        let picture = picture.transpose()?;
        let folder = self.run.folder();
        let _writing = interrupt::writing();
        let files = write_results(
            &folder,
            &run.result,
            &records,
            ResultCompanions { picture: picture.as_deref(), orbit: orbit.as_deref() },
        )?;
        let animated = self.animate(&folder, run.frames)?;
        let drawn = animated + &plot::written(&folder, &figures)? + &self.page.written(&folder, PAGE_FILE, page)?;
        complain::warn_of_sweep(scene.sweep.as_ref().map(Plan::cases));
        complain::warn(&run.result.tail.warnings);
        let written = Written { folder: &folder, files: &files, pictures: &drawn };
        output(
            self.run.json,
            || Ok(json),
            || run_report(&run.result, self.shown(), &records, Some(written)),
            Some(&folder),
        )?;
        Ok(exit_code(run.result.head.status))
    }

    /// What is compared with the film.
    fn compared(&self) -> impl Iterator<Item = Compare> {
        let asked = [self.cost, self.standard, self.theories, self.mobility];
        Compare::ALL.into_iter().zip(asked).filter_map(|(kind, is_asked)| is_asked.then_some(kind))
    }

    /// What writes and prints the numbers of a run, without its pictures, that an interrupt ends before it ends by
    /// itself; the exit status.
    fn end(&self) -> impl Fn(LatestAnswer) -> u8 + Send + Sync + 'static {
        let (folder, shown, json) = (self.run.folder(), self.shown(), self.run.json);
        move |LatestAnswer { result, orbit }| {
            let none = Records::default();
            let written = || -> Result<(), Failure> {
                let text = result_json(&result, &none)?;
                let beside = ResultCompanions { picture: None, orbit: orbit.as_deref() };
                let files = write_results(&folder, &result, &none, beside)?;
                complain::warn(&result.tail.warnings);
                let written = Written { folder: &folder, files: &files, pictures: "" };
                output(json, || Ok(text), || run_report(&result, shown, &none, Some(written)), Some(&folder))
            };
            match written() {
                Ok(()) => u8::from(result.head.status != Status::Converged),
                Err(failure) => {
                    let status = failure.status();
                    failure.report();
                    status
                }
            }
        }
    }

    /// Solves the scene of a crankshaft.
    ///
    /// # Errors
    /// [`Failure`]: an argument has no meaning for it, a scene cannot be used, or the results cannot be written.
    fn crankshaft(&self) -> Result<ExitCode, Failure> {
        let of_one = [
            (self.unrolled, "--unrolled"),
            (self.vtu.is_some(), "--vtu"),
            (self.float32, "--float32"),
            (self.fields == Fields::All, "--fields"),
            (self.frames.is_some(), "--frames"),
            (self.all, "--all"),
            (self.plot, "--plot"),
            (self.fresh, "--fresh"),
            (self.sensitivity, "--sensitivity"),
        ];
        let of_one = of_one.into_iter().filter(|(is_given, _)| *is_given).map(|(_, argument)| argument.to_owned());
        let compared = self.compared().map(|kind| format!("--{}", kind.name()));
        if let Some(argument) = of_one.chain(compared).next() {
            return Err(Failure::Message(format!(
                "{argument}: has no meaning for the scene {} of a crankshaft; leave it out, or solve the scene of one of its bearings",
                self.run.scene.display()
            )));
        }
        let beside = [(self.cut, Variant::Cut), (self.counterweights, Variant::Counterweights)];
        let beside: Vec<Variant> =
            beside.into_iter().filter_map(|(is_given, variant)| is_given.then_some(variant)).collect();
        crankshaft::solve(&self.run, &beside, self.page)
    }

    /// Writes the frames of the cycle, if there are any, and says so in a line.
    fn animate(&self, folder: &Path, frames: Vec<Frame>) -> Result<String, Failure> {
        let Some(first) = frames.first() else {
            return Ok(String::new());
        };
        let (form, count) = (self.form(&first.picture), frames.len());
        write_frames(folder, frames, form)?;
        Ok(format!("animation {}: {count} frames\n", folder.join(COLLECTION_FILE).display()))
    }

    /// How film.vtu is written.
    fn form(&self, picture: &FilmPicture) -> VtuForm {
        let usual = VtuForm::usual(picture);
        VtuForm {
            compression: self.vtu.map_or(usual.compression, Compression::from),
            precision: if self.float32 { Precision::Single } else { usual.precision },
        }
    }

    /// Refuses what cannot stand beside the film of this scene.
    fn check_compared(&self, scene: &Scene, model: &Model) -> Result<(), Failure> {
        let of_shaft = [(self.counterweights, "--counterweights"), (self.cut, "--cut")];
        if let Some((_, argument)) = of_shaft.iter().find(|(is_given, _)| *is_given) {
            return Err(Failure::Message(format!(
                "{argument}: the scene {} is that of one bearing; leave it out, or give the scene of a crankshaft",
                self.run.scene.display()
            )));
        }
        if self.sensitivity && scene.differentiated(true).is_empty() {
            return Err(Failure::Message(format!(
                "--sensitivity: a cycle is differentiated by numbers with tolerances only, and the scene {} has none; give some, as clearance = \"30 um +- 3 um\"",
                self.run.scene.display()
            )));
        }
        if self.frames.is_some() && model.scope.orbit.is_none() {
            return Err(Failure::Message(format!(
                "--frames: the scene {} has no [orbit], so there is no cycle to draw; leave out --frames",
                self.run.scene.display()
            )));
        }
        match no_map(model).filter(|_| self.mobility) {
            Some(reason) => Err(Failure::Message(format!(
                "--mobility: no map stands for the film of {}, since {reason}; leave out --mobility",
                self.run.scene.display()
            ))),
            None => Ok(()),
        }
    }

    fn shown(&self) -> ShownQuantities {
        match self.all {
            true => ShownQuantities::All,
            false => ShownQuantities::Headlines,
        }
    }

    /// The longest task of a run of the scene.
    fn task(scene: &Scene) -> &'static str {
        match (scene.tolerance.is_some(), scene.journal.load().is_some()) {
            _ if scene.orbit.is_some() => {
                "following the journal over the cycle; Ctrl-C ends with the cycles that are complete"
            }
            (true, _) => "refining until the tolerance is met; Ctrl-C ends with the best result so far",
            (false, true) => "searching the position under the load; Ctrl-C ends with the best so far",
            (false, false) => "the film",
        }
    }
}
