//! The folder `plot` beside results: every picture as SVG and PNG.

use std::ffi::{OsStr, OsString};
use std::ops::RangeInclusive;
use std::path::Path;

use oilwedge_drawing::Figure;
use oilwedge_study::fields::{FIELDS, VISCOSITY};
use oilwedge_study::quantities::CATALOGUE;
use rayon::prelude::*;

use super::field_map::{field_figure, is_constant, mesh_figure};
use super::film::DrawnFilm;
use super::profiles::profiles_figure;
use super::section::section_figure;
use super::sweep::{quantity_names, sweep_figures};
use super::temperature::{BALANCE, temperature_curve, temperature_figure};
use super::to_png;
use super::tolerances::{TOLERANCES, tolerances_figure};
use crate::sweep::SweepResult;
use crate::{Error, folder};

/// Name of the folder.
pub const PLOT_FOLDER: &str = "plot";
/// The picture of a convergence study.
pub const CONVERGENCE: &str = "converge";
/// Pictures of a film beside its fields.
const OF_FILM: [&str; 5] = ["mesh", "section", "profiles", BALANCE, TOLERANCES];

/// What is drawn.
#[derive(Debug, Clone, PartialEq)]
pub struct PlotOptions {
    /// Names of fields and pictures, of a sweep of quantities; empty: all that say something.
    pub selected: Vec<String>,
    /// Width of the pictures [mm], one of [`WIDTHS`].
    pub width: f64,
}

/// Narrowest and widest pictures [mm].
pub const WIDTHS: RangeInclusive<f64> = 60.0..=400.0;

/// A name that was selected but is not there.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Unknown {
    /// The name.
    pub name: String,
    /// Names that are there.
    pub known: Vec<String>,
}

/// The pictures of a film by name.
///
/// # Errors
/// [`Unknown`]: a selected picture is not one of this film.
pub fn film_figures(film: &DrawnFilm, options: &PlotOptions) -> Result<Vec<(String, Figure)>, Unknown> {
    let is_there = |name: &&str| match *name {
        BALANCE => !temperature_curve(&film.result).is_empty(),
        TOLERANCES => film.result.quantities.iter().any(|quantity| quantity.spread.is_some()),
        _ => true,
    };
    let others = OF_FILM.into_iter().filter(is_there);
    let known: Vec<String> = film.field_names().chain(others.clone()).map(str::to_owned).collect();
    check(&options.selected, &known)?;
    let says_something =
        |name: &str| name != VISCOSITY.name || film.values(name).is_some_and(|values| !is_constant(values));
    let usual = || {
        FIELDS.iter().map(|row| row.name).filter(|name| known.iter().any(|other| other == name) && says_something(name))
    };
    let names: Vec<String> = match options.selected.is_empty() {
        true => usual().chain(others).map(str::to_owned).collect(),
        false => options.selected.clone(),
    };
    let draw = |name: String| {
        let figure = match name.as_str() {
            "mesh" => Some(mesh_figure(film, options.width)),
            "section" => section_figure(film, options.width),
            "profiles" => profiles_figure(film, options.width),
            BALANCE => temperature_figure(&film.result, options.width),
            TOLERANCES => tolerances_figure(&film.result, options.width),
            field => field_figure(film, field, options.width),
        };
        Some((name, figure?))
    };
    Ok(names.into_par_iter().filter_map(draw).collect())
}

/// The pictures of a sweep by name.
///
/// # Errors
/// [`Unknown`]: a selected quantity is none of the sweep.
pub fn figures_of_sweep(sweep: &SweepResult, options: &PlotOptions) -> Result<Vec<(String, Figure)>, Unknown> {
    check(&options.selected, &quantity_names(sweep))?;
    Ok(sweep_figures(sweep, &options.selected, options.width))
}

fn check(selected: &[String], known: &[String]) -> Result<(), Unknown> {
    match selected.iter().find(|name| !known.contains(name)) {
        None => Ok(()),
        Some(name) => Err(Unknown { name: name.clone(), known: known.to_vec() }),
    }
}

/// The two files of a picture.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct PictureFiles {
    /// Name of the file without an ending.
    pub name: String,
    /// Content of the SVG.
    pub svg: Vec<u8>,
    /// Content of the PNG.
    pub png: Vec<u8>,
}

/// Figures by name as files.
///
/// # Errors
/// [`Error::Format`]: a figure is too large for a PNG.
pub fn picture_files(figures: &[(String, Figure)]) -> Result<Vec<PictureFiles>, Error> {
    let files = |(name, figure): &(String, Figure)| {
        Ok(PictureFiles { name: name.clone(), svg: figure.to_svg().into_bytes(), png: to_png(figure)? })
    };
    figures.par_iter().map(files).collect()
}

/// Writes pictures into the folder `plot` of `dir`; those of an earlier run that are not drawn again are removed.
///
/// # Errors
/// The system refuses; the old pictures are then left as they were.
pub fn write_pictures(dir: &Path, pictures: &[PictureFiles]) -> Result<(), Error> {
    let mut files: Vec<(OsString, Option<&[u8]>)> = Vec::new();
    for PictureFiles { name, svg, png } in pictures {
        files.push((format!("{name}.png").into(), Some(png)));
        files.push((format!("{name}.svg").into(), Some(svg)));
    }
    let usual = FIELDS.iter().map(|row| row.name.to_owned());
    let maps = CATALOGUE.iter().map(|row| format!("map_{}", row.name));
    let known = usual.chain(OF_FILM.map(str::to_owned)).chain(maps).chain(["sweep", CONVERGENCE].map(str::to_owned));
    for name in known.filter(|name| pictures.iter().all(|picture| picture.name != *name)) {
        files.extend(["svg", "png"].map(|ending| (format!("{name}.{ending}").into(), None)));
    }
    let steps: Vec<(&OsStr, Option<&[u8]>)> = files.iter().map(|(name, bytes)| (name.as_os_str(), *bytes)).collect();
    folder::replace(&dir.join(PLOT_FOLDER), &steps)
}
