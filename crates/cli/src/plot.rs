//! `oilwedge plot`: pictures of a film, a sweep or a convergence study, from a scene or from a folder of results; and
//! `--plot` of other verbs.

use crate::complain::{self, Failure};
use crate::interrupt;
use crate::progress::ProgressLine;
use crate::run_options::folder;
use crate::terminal::{exit_code, print};
use oilwedge_campaign::Records;
use oilwedge_drawing::{Figure, PAGE_WIDTH};
use oilwedge_report::convergence::REPORT_FILE as STUDY_FILE;
use oilwedge_report::orbit_course::OrbitCourse;
use oilwedge_report::orbit_table::orbit_table;
use oilwedge_report::plot::{
    self, CONVERGENCE, DrawnFilm, PLOT_FOLDER, PictureFiles, PlotOptions, Unknown, WIDTHS, film_figures, orbit_figures,
    orbits_beside, picture_files, write_pictures,
};
use oilwedge_report::results::{ORBIT_FILE, PICTURE_FILE, RESULT_FILE, ResultCompanions, write_results};
use oilwedge_report::sweep::{REPORT_FILE, SweepResult};
use oilwedge_report::tables::printable;
use oilwedge_report::vtu::{VtuForm, to_vtu};
use oilwedge_report::vtu_read::from_vtu;
use oilwedge_scene::unit::{self, Dimension};
use oilwedge_study::RunOptions;
use oilwedge_study::picture::FilmPicture;
use oilwedge_study::result::RunResult;
use serde::de::DeserializeOwned;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

/// Arguments of `oilwedge plot`.
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Plot {
    /// A scene, which is solved first, or a folder with the results of solve, sweep or converge.
    #[arg(value_name = "SCENE|DIR")]
    of: PathBuf,

    /// A second folder of solve with an orbit: draw both orbits side by side.
    #[arg(value_name = "DIR")]
    beside: Option<PathBuf>,

    /// What to draw: fields of film.vtu, mesh, section, profiles, heat, tolerances; of a sweep its quantities [default:
    /// all that say something].
    #[arg(long = "field", value_name = "NAME", value_delimiter = ',')]
    fields: Vec<String>,

    /// Width of the pictures, from 60 mm to 400 mm; letters keep their height of 7 points or more.
    #[arg(long, value_name = "LENGTH", default_value = "170 mm", value_parser = width)]
    width: f64,

    /// Folder of the results [default: out/NAME for NAME.toml, or the folder DIR]; the pictures go to the folder plot
    /// in it.
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
}

const EXAMPLES: &str = "\
Examples:
  oilwedge plot bearing.toml
  oilwedge plot out/bearing --field pressure,film_fraction --width \"85 mm\"
  oilwedge plot out/map --field load,friction_power
  oilwedge plot out/big_end out/thinner_oil

Exit status: 0 done; 1 no solution, or not converged (what there is of it is drawn); 2 bad scene, folder or arguments.";

fn width(text: &str) -> Result<f64, String> {
    let metres = unit::parse(text, Dimension::Length).map_err(|error| format!("{error}; {}", error.help("85 mm")))?;
    // The ends themselves are widths, whatever the unit makes of them.
    let width = (1e9 * metres).round() / 1e6;
    match WIDTHS.contains(&width) {
        true => Ok(width),
        false => Err(format!("give a width from {} mm to {} mm", WIDTHS.start(), WIDTHS.end())),
    }
}

/// What `--plot` draws.
pub(crate) fn usual() -> PlotOptions {
    PlotOptions { selected: Vec::new(), width: PAGE_WIDTH }
}

/// Pictures by name.
type Figures = Vec<(String, Figure)>;

/// The pictures of an orbit, if it is one and none are selected, then those of the film, if there is one.
///
/// # Errors
/// [`Failure`]: a selected picture is not there.
pub(crate) fn figures_of_run(
    result: &RunResult,
    picture: Option<&FilmPicture>,
    course: Option<&OrbitCourse>,
    options: &PlotOptions,
) -> Result<Figures, Failure> {
    let course = course.filter(|_| options.selected.is_empty());
    let of_orbit = course.map(|course| orbit_figures(&result.head.title, course, options.width));
    let of_film = match picture {
        Some(picture) => film_figures(&DrawnFilm::new(result.clone(), picture)?, options).map_err(unknown)?,
        None => Vec::new(),
    };
    Ok(of_orbit.into_iter().flatten().chain(of_film).collect())
}

/// The pictures of a sweep.
///
/// # Errors
/// [`Failure`]: a selected quantity is not there.
pub(crate) fn figures_of_sweep(sweep: &SweepResult, options: &PlotOptions) -> Result<Figures, Failure> {
    plot::figures_of_sweep(sweep, options).map_err(unknown)
}

/// The results in the file at `path`.
///
/// # Errors
/// [`Failure`]: it cannot be read, or holds something else.
pub(crate) fn results<T: DeserializeOwned>(path: &Path) -> Result<T, Failure> {
    serde_json::from_str(&text(path)?).map_err(|error| {
        Failure::Message(match error.is_data() {
            true => format!("{}: the results have another form: {error}; solve the scene again", path.display()),
            false => format!("the results are no JSON: {error}"),
        })
    })
}

fn unknown(Unknown { name, known }: Unknown) -> Failure {
    Failure::Message(format!("--field: there is no \"{name}\" to draw; there are {}", known.join(", ")))
}

/// Writes pictures, if there are any, and says so in a line.
///
/// # Errors
/// [`Failure`]: they cannot be written.
pub(crate) fn written(folder: &Path, figures: &[(String, Figure)]) -> Result<String, Failure> {
    written_files(folder, &picture_files(figures)?)
}

fn written_files(folder: &Path, pictures: &[PictureFiles]) -> Result<String, Failure> {
    if pictures.is_empty() {
        return Ok(String::new());
    }
    write_pictures(folder, pictures)?;
    let names: Vec<&str> = pictures.iter().map(|picture| picture.name.as_str()).collect();
    let place = folder.join(PLOT_FOLDER);
    Ok(format!("pictures  {}: {} (.svg, .png)\n", place.display(), names.join(", ")))
}

impl Plot {
    /// Draws the pictures.
    ///
    /// # Errors
    /// [`Failure`]: the scene or the results cannot be used, or the pictures cannot be written.
    pub(crate) fn run(&self) -> Result<ExitCode, Failure> {
        match self.of.is_dir() {
            _ if self.beside.is_some() => self.of_two(),
            true => self.of_folder(),
            false => self.of_scene(),
        }
    }

    fn options(&self) -> PlotOptions {
        PlotOptions { selected: self.fields.clone(), width: self.width }
    }

    fn of_scene(&self) -> Result<ExitCode, Failure> {
        let scene = oilwedge_study::read(&self.of)?;
        let options =
            RunOptions { interrupt: interrupt::listen_in_time(interrupt::NOTHING)?, ..RunOptions::of(&scene) };
        let working = ProgressLine::of("the film");
        let run = oilwedge_study::run(&scene, &options).map_err(Failure::of(&self.of))?;
        drop(working);
        let folder = folder(&self.out, &self.of);
        let course = run.orbit.as_ref().map(OrbitCourse::of_path);
        let figures = figures_of_run(&run.result, run.picture.as_ref(), course.as_ref(), &self.options())?;
        let orbit = run.orbit.as_ref().map(orbit_table).transpose()?;
        let picture = run.picture.map(|picture| to_vtu(&picture, VtuForm::usual(&picture)));
        let picture = picture.transpose()?;
        let _writing = interrupt::writing();
        write_results(
            &folder,
            &run.result,
            &Records::default(),
            ResultCompanions { picture: picture.as_deref(), orbit: orbit.as_deref() },
        )?;
        complain::warn(&run.result.tail.warnings);
        let mut text = written(&folder, &figures)?;
        if let Some(reason) = &run.result.head.reason {
            text += &format!("{}\n", printable(reason));
        }
        print(&text, Some(&folder))?;
        Ok(exit_code(run.result.head.status))
    }

    fn of_folder(&self) -> Result<ExitCode, Failure> {
        let [result, sweep, study] = [RESULT_FILE, REPORT_FILE, STUDY_FILE].map(|name| self.of.join(name));
        let figures = match [&result, &sweep, &study].map(|file| file.is_file()) {
            [true, ..] => {
                let picture = self.of.join(PICTURE_FILE);
                if !picture.is_file() {
                    return Err(Failure::Message(format!(
                        "{} has no {PICTURE_FILE}: there is no film to draw",
                        self.of.display()
                    )));
                }
                let picture = from_vtu(&read(&picture)?).map_err(Failure::of_file(&picture))?;
                let has_orbit = self.of.join(ORBIT_FILE).is_file();
                let orbit = has_orbit.then(|| orbit_in(&self.of)).transpose()?;
                figures_of_run(&results(&result)?, Some(&picture), orbit.as_ref(), &self.options())?
            }
            [_, true, _] => figures_of_sweep(&results(&sweep)?, &self.options())?,
            [.., true] => return self.of_study(&study),
            _ => {
                return Err(Failure::Message(format!(
                    "{} has no {RESULT_FILE}, {REPORT_FILE} or {STUDY_FILE}; give a scene, or a folder of oilwedge solve, sweep or converge",
                    self.of.display()
                )));
            }
        };
        let folder = self.out.clone().unwrap_or_else(|| self.of.clone());
        say(&folder, written(&folder, &figures)?)
    }

    /// Two orbits side by side.
    fn of_two(&self) -> Result<ExitCode, Failure> {
        if !self.fields.is_empty() {
            return Err(Failure::Message(
                "--field: of two folders the orbits are drawn; leave out --field, or give one folder".to_owned(),
            ));
        }
        let beside = self.beside.as_ref().unwrap_or(&self.of);
        let (one, other) = (orbit_in(&self.of)?, orbit_in(beside)?);
        let [name, other_name] = [&self.of, beside].map(|folder| folder.display().to_string());
        let figures = orbits_beside([(&name, &one), (&other_name, &other)], self.width);
        let folder = self.out.clone().unwrap_or_else(|| self.of.clone());
        say(&folder, written(&folder, &figures)?)
    }

    /// The picture that the study has drawn, copied, for its meshes are in no file.
    fn of_study(&self, study: &Path) -> Result<ExitCode, Failure> {
        if let Some(name) = self.fields.iter().find(|name| *name != CONVERGENCE) {
            let known = vec![CONVERGENCE.to_owned()];
            return Err(unknown(Unknown { name: name.clone(), known }));
        }
        if (self.width - PAGE_WIDTH).abs() > 1e-9 {
            return Err(Failure::Message(format!(
                "--width: the picture of a convergence study is {PAGE_WIDTH} mm wide"
            )));
        }
        let [svg, png] = ["svg", "png"].map(|ending| study.with_extension(ending));
        let drawn = svg.is_file().then(|| {
            Ok::<_, Failure>(PictureFiles { name: CONVERGENCE.to_owned(), svg: read(&svg)?, png: read(&png)? })
        });
        let folder = self.out.clone().unwrap_or_else(|| self.of.clone());
        say(&folder, written_files(&folder, drawn.transpose()?.as_slice())?)
    }
}

/// The orbit in a folder of results.
fn orbit_in(folder: &Path) -> Result<OrbitCourse, Failure> {
    let table = folder.join(ORBIT_FILE);
    if !table.is_file() {
        return Err(Failure::Message(format!(
            "{} has no {ORBIT_FILE}: there is no orbit to draw; give folders of oilwedge solve with [orbit]",
            folder.display()
        )));
    }
    OrbitCourse::from_csv(&read(&table)?).map_err(Failure::of_file(&table))
}

/// Prints the line about the pictures.
fn say(folder: &Path, line: String) -> Result<ExitCode, Failure> {
    let line = if line.is_empty() { "there is nothing to draw\n".to_owned() } else { line };
    print(&line, Some(folder))?;
    Ok(ExitCode::SUCCESS)
}

pub(crate) fn read(path: &Path) -> Result<Vec<u8>, Failure> {
    std::fs::read(path).map_err(|error| Failure::Message(format!("cannot read {}: {error}", path.display())))
}

pub(crate) fn text(path: &Path) -> Result<String, Failure> {
    let bytes = read(path)?;
    String::from_utf8(bytes).map_err(|_| Failure::Message(format!("{} is no text", path.display())))
}

impl Failure {
    /// A failure of the file at `path`.
    pub(crate) fn of_file(path: &Path) -> impl Fn(oilwedge_report::Error) -> Self {
        move |error| Self::Message(format!("{}: {error}", path.display()))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_width_is_a_length_within_bounds() {
        assert!(width("85 mm").is_ok_and(|width| (width - 85.0).abs() < 1e-9));
        assert!(width("17 cm").is_ok_and(|width| (width - 170.0).abs() < 1e-9));
        for text in ["85", "1 mm", "2 m", "85 N", ""] {
            assert!(width(text).is_err_and(|message| message.contains("mm")), "{text}");
        }
    }
}
