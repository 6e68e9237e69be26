//! Pictures: which files the program writes, what they hold, and that they are small, readable and the same each time.

use std::collections::BTreeSet;
use std::fs;

use oilwedge_report::plot::{DrawnFilm, PlotOptions, film_figures};
use oilwedge_report::vtu::{Compression, VtuForm, to_vtu};
use oilwedge_report::vtu_read::from_vtu;
use oilwedge_study::film_lines::{REFORMATION, RUPTURE};
use oilwedge_study::picture::{FieldChoice, FilmPicture, PictureOptions, Surface};
use oilwedge_study::quantities::MIN_FILM_ANGLE;
use oilwedge_study::result::RunResult;
use oilwedge_study::{RunOptions, run};
use oilwedge_tests::bench::Bench;
use oilwedge_tests::program::repository;
use oilwedge_tests::scenes::{variant, written};
use oilwedge_tests::thermal_films::{FERRON, edited};

fn solved(name: &str, surface: Surface) -> (RunResult, FilmPicture) {
    let options = RunOptions {
        bars: false,
        picture: PictureOptions { surface, ..PictureOptions::default() },
        ..RunOptions::default()
    };
    let run = run(&variant(name, |_| {}), &options).expect("a film");
    (run.result, run.picture.expect("a picture"))
}

fn svgs(result: RunResult, picture: &FilmPicture, width: f64) -> Vec<(String, String)> {
    let film = DrawnFilm::new(result, picture).expect("a film to draw");
    let options = PlotOptions { selected: Vec::new(), width };
    let figures = film_figures(&film, &options).expect("pictures");
    figures.into_iter().map(|(name, figure)| (name, figure.to_svg())).collect()
}

/// Sizes of letters [points] in an SVG whose unit is a millimetre.
fn letters(svg: &str) -> Vec<f64> {
    let sizes = svg.split("font-size=\"").skip(1);
    sizes
        .map(|rest| rest.split('"').next().and_then(|size| size.parse::<f64>().ok()).expect("a size") * 72.0 / 25.4)
        .collect()
}

#[test]
fn pictures_of_the_engine_bearing_are_small_and_readable() {
    let (result, picture) = solved("17_engine_main_bearing", Surface::Developed);
    for width in [85.0, 170.0] {
        let svgs = svgs(result.clone(), &picture, width);
        let names: BTreeSet<&str> = svgs.iter().map(|(name, _)| name.as_str()).collect();
        for name in ["pressure", "film_thickness", "film_fraction", "viscosity", "mesh", "section", "profiles"] {
            assert!(names.contains(name), "no {name} in {names:?}");
        }
        for (name, svg) in &svgs {
            assert!(svg.len() < 250_000, "{name}: {} bytes", svg.len());
            assert!(svg.contains("<title") && svg.contains("<desc"), "{name}");
            // To the third decimal of a millimetre.
            assert!(letters(svg).iter().all(|size| *size > 6.99), "{name}: {:?}", letters(svg));
        }
    }
}

#[test]
fn a_film_on_the_cylinder_and_from_its_file_gives_the_same_pictures() {
    let (result, plane) = solved("02_flexpde_shell", Surface::Developed);
    let (_, cylinder) = solved("02_flexpde_shell", Surface::Cylinder);
    let drawn = svgs(result.clone(), &plane, 170.0);
    assert_eq!(drawn, svgs(result.clone(), &plane, 170.0));
    let read =
        from_vtu(&to_vtu(&plane, VtuForm { compression: Compression::Lz4, ..VtuForm::usual(&plane) }).expect("a file"))
            .expect("the file");
    assert_eq!(read, plane);
    assert_eq!(drawn, svgs(result.clone(), &read, 170.0));
    // On the cylinder places are rounded otherwise: the same levels, and files of nearly the same length.
    for ((name, svg), (_, other)) in drawn.iter().zip(svgs(result, &cylinder, 170.0)) {
        assert_eq!(svg.matches("<path").count(), other.matches("<path").count(), "{name}");
        let ratio = other.len() as f64 / svg.len() as f64;
        assert!((ratio - 1.0).abs() < 0.02, "{name}: {ratio}");
    }
}

#[test]
fn tension_is_drawn_in_the_diverging_map_and_a_film_of_one_sign_is_not() {
    let white_in_the_middle = |name: &str| {
        let (result, picture) = solved(name, Surface::Developed);
        let svgs = svgs(result, &picture, 170.0);
        let (_, svg) = svgs.into_iter().find(|(name, _)| name == "pressure").expect("a pressure");
        // The darkest brown of vik is no colour of batlowW.
        svg.contains("#5") && svg.contains("\u{2212}")
    };
    assert!(white_in_the_middle("04_flexpde_ring"));
    let (result, picture) = solved("11_swift_stieber_ring", Surface::Developed);
    let svgs = svgs(result, &picture, 170.0);
    let (_, svg) = svgs.iter().find(|(name, _)| name == "pressure").expect("a pressure");
    assert!(svg.contains("film breaks"), "no edge of the cavity");
}

/// Swift and Stieber's long ring: the film breaks behind the thinnest film, as far as the converging part begins before
/// it.
#[test]
fn the_film_breaks_behind_its_thinnest_place() {
    let (result, picture) = solved("11_swift_stieber_ring", Surface::Developed);
    let radius = result.geometry.radius;
    let thinnest = result.quantity(&MIN_FILM_ANGLE).expect("an angle").value;
    let line = |name: &str| picture.lines.iter().find(|(other, _)| other == name).map(|(_, pieces)| pieces.clone());
    let rupture = line(RUPTURE).expect("a rupture");
    for piece in rupture.iter().flatten() {
        let behind = ((piece[0] / radius).to_degrees() - thinnest + 180.0).rem_euclid(360.0) - 180.0;
        assert!((0.0..90.0).contains(&behind), "{behind} deg behind the thinnest film");
    }
    let extent = rupture.iter().flatten().map(|point| point[1]);
    let length = extent.clone().fold(f64::NEG_INFINITY, f64::max) - extent.fold(f64::INFINITY, f64::min);
    assert!(length > 0.8 * result.geometry.length);
    let (result, full) = solved("02_flexpde_shell", Surface::Developed);
    assert_eq!(full.lines.len(), 1, "a full film has only the rim of its hole");
    assert!(full.lines[0].0.starts_with("rim."), "{}", full.lines[0].0);
    assert!(result.geometry.arc.is_some());
    let (_, conserving) = solved("17_engine_main_bearing", Surface::Developed);
    let has = |name: &str| conserving.lines.iter().any(|(other, _)| other == name);
    assert!(has(RUPTURE) && has(REFORMATION));
}

#[test]
fn the_program_draws_scenes_and_folders() {
    let bench = Bench::new();
    bench.scene("02_flexpde_shell", &[]);
    let told = bench.run(&["plot", "scene.toml", "--out", "run", "--field", "pressure,section", "--width", "85 mm"]);
    assert_eq!(told.status, 0, "{}", told.stderr);
    assert!(told.stdout.contains("pressure, section"), "{}", told.stdout);
    let files = |folder: &str| -> BTreeSet<String> {
        let entries = fs::read_dir(bench.path().join(folder)).expect("a folder");
        entries.map(|entry| entry.expect("an entry").file_name().to_string_lossy().into_owned()).collect()
    };
    let four = ["pressure.png", "pressure.svg", "section.png", "section.svg"].map(str::to_owned);
    assert_eq!(files("run/plot"), BTreeSet::from(four));
    let first = fs::read(bench.path().join("run/plot/pressure.svg")).expect("a picture");
    assert!(String::from_utf8_lossy(&first).contains("width=\"85mm\""));
    // From the folder, in other threads: the same bytes; the others of before are removed.
    let told = bench.run(&["plot", "run", "--field", "pressure", "--width", "8.5 cm", "--threads", "1"]);
    assert_eq!(told.status, 0, "{}", told.stderr);
    assert_eq!(fs::read(bench.path().join("run/plot/pressure.svg")).expect("a picture"), first);
    assert_eq!(files("run/plot").len(), 2);
    let told = bench.run(&["solve", "scene.toml", "--out", "solved", "--plot"]);
    assert_eq!(told.status, 0, "{}", told.stderr);
    assert!(told.stdout.contains("pictures  "), "{}", told.stdout);
    assert!(files("solved/plot").contains("profiles.png"));
}

#[test]
fn what_cannot_be_drawn_is_named() {
    let bench = Bench::new();
    bench.scene("02_flexpde_shell", &[]);
    bench.refuses(&["plot", "scene.toml", "--field", "temperature"], &["no \"temperature\"", "film_thickness"]);
    bench.refuses(&["plot", "scene.toml", "--width", "2 m"], &["from 60 mm to 400 mm"]);
    bench.refuses(&["plot", "scene.toml", "--width", "85"], &["no unit", "85 mm"]);
    fs::create_dir(bench.path().join("empty")).expect("a folder");
    bench.refuses(&["plot", "empty"], &["no result.json, sweep.json or converge.json"]);
    fs::write(bench.path().join("empty/result.json"), "{}").expect("a file");
    bench.refuses(&["plot", "empty"], &["no film.vtu"]);
    fs::write(bench.path().join("empty/film.vtu"), "<VTKFile").expect("a file");
    bench.refuses(&["plot", "empty"], &["film.vtu", "cannot be read"]);
}

#[test]
fn sweeps_are_drawn_with_their_bars_and_as_maps() {
    let bench = Bench::new();
    let sweep = "[sweep]\neccentricity = { from = 0.2, to = 0.8, steps = 4 }\nspeed = [\"1000 rpm\", \"2000 rpm\", \"3000 rpm\"]\n\n[journal]";
    bench.scene("01_plain_ring", &[("[journal]", sweep)]);
    let told = bench.run(&["sweep", "scene.toml", "--out", "map", "--plot"]);
    assert_eq!(told.status, 0, "{}", told.stderr);
    let read = |name: &str| fs::read_to_string(bench.path().join(format!("map/plot/{name}.svg"))).expect("a picture");
    let (curves, map) = (read("sweep"), read("map_load"));
    for words in ["eccentricity = 0.2", "eccentricity = 0.8", "load"] {
        assert!(curves.contains(words), "no {words}");
    }
    assert!(map.contains("eccentricity") && map.contains("3000"));
    let told = bench.run(&["plot", "map", "--field", "attitude_angle"]);
    assert_eq!(told.status, 0, "{}", told.stderr);
    assert!(
        bench.path().join("map/plot/map_attitude_angle.png").is_file()
            && !bench.path().join("map/plot/map_load.png").exists()
    );
    bench.refuses(&["plot", "map", "--field", "pressure"], &["no \"pressure\"", "load"]);
}

#[test]
fn a_convergence_study_is_drawn_again_from_its_folder() {
    let bench = Bench::new();
    bench.scene("01_plain_ring", &[]);
    let told = bench.run(&["converge", "scene.toml", "--out", "study", "--max-seconds", "1"]);
    assert_eq!(told.status, 0, "{}", told.stderr);
    let told = bench.run(&["plot", "study"]);
    assert_eq!(told.status, 0, "{}", told.stderr);
    let read = |name: &str| fs::read(bench.path().join(name)).expect("a picture");
    for ending in ["svg", "png"] {
        let [own, again] = ["study", "study/plot"].map(|folder| read(&format!("{folder}/converge.{ending}")));
        assert!(own == again, "another {ending}");
    }
    bench.refuses(&["plot", "study", "--field", "load"], &["no \"load\"", "converge"]);
    bench.refuses(&["plot", "study", "--width", "85 mm"], &["--width", "170 mm"]);
}

#[test]
fn every_picture_of_the_documentation_has_a_title_and_a_description() {
    let mut folders = vec![repository().join("docs")];
    let mut pictures = 0;
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(&folder).expect("a folder") {
            let path = entry.expect("an entry").path();
            if path.is_dir() {
                folders.push(path);
            } else if path.extension().is_some_and(|ending| ending == "svg") {
                let svg = fs::read_to_string(&path).expect("a picture");
                assert!(
                    svg.contains("<title>") && svg.contains("<desc>") && svg.contains("mm\""),
                    "{} is not drawn by the crate drawing",
                    path.display()
                );
                pictures += 1;
            }
        }
    }
    assert!(pictures > 10);
}

/// A film with temperatures across it has charts of them, and a row of temperatures at each node of its file.
#[test]
fn temperatures_of_a_film_are_drawn_and_written() {
    let options = RunOptions {
        bars: false,
        picture: PictureOptions { surface: Surface::Developed, fields: FieldChoice::All },
        ..RunOptions::default()
    };
    let found = run(&written(&edited(FERRON, &[("size = \"6 mm\"", "size = \"10 mm\"")])), &options).expect("a film");
    let (result, picture) = (found.result, found.picture.expect("a picture"));
    let across = result.temperature_across.clone().expect("temperatures across the film");
    let hottest = result.by_name("temperature_max").expect("the hottest point").value;
    assert!(across.temperature.iter().any(|t| (t - hottest).abs() < 1e-9), "{hottest}: {across:?}");
    for (eta, t) in across.eta.iter().zip(&across.temperature) {
        assert!(across.at(*eta).is_some_and(|at| (at - t).abs() < 1e-9), "{eta}");
    }
    let rows = picture.at_points("temperature_layers [degC]").expect("layers");
    let mean = picture.at_points("temperature_greatest").expect("a field").numbers();
    let greatest = rows.numbers().chunks(7).map(|row| row.iter().copied().fold(f64::NEG_INFINITY, f64::max));
    assert!(greatest.zip(mean).all(|(a, b)| (a - b).abs() < 1e-9));
    let file = to_vtu(&picture, VtuForm::usual(&picture)).expect("a file");
    assert_eq!(from_vtu(&file).expect("the file"), picture);
    let (_, svg) = svgs(result, &picture, 170.0).into_iter().find(|(name, _)| name == "profiles").expect("profiles");
    for words in ["Temperature around the liner", "Across the film where it is hottest", "Temperature of the bush"] {
        assert!(svg.contains(words), "no {words}");
    }
}
