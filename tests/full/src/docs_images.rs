//! The pictures of `docs/images`, drawn by the program's own pictures of its scenes.

use oilwedge_report::plot::{DrawnFilm, PlotOptions, film_figures};
use oilwedge_study::picture::{PictureOptions, Surface};
use oilwedge_study::{RunOptions, run};

use oilwedge_tests::scenes::variant;

/// Scene, picture, and the file in `docs/images`.
pub const IMAGES: [(&str, &str, &str); 9] = [
    ("02_flexpde_shell", "pressure", "shell_pressure"),
    ("02_flexpde_shell", "film_thickness", "shell_film_thickness"),
    ("02_flexpde_shell", "viscosity", "shell_viscosity"),
    ("02_flexpde_shell", "profiles", "shell_profiles"),
    ("02_flexpde_shell", "section", "shell_section"),
    ("13_grooved_ring", "film_fraction", "grooved_ring_film_fraction"),
    ("17_engine_main_bearing", "film_fraction", "engine_film_fraction"),
    ("17_engine_main_bearing", "pressure", "engine_pressure"),
    ("17_engine_main_bearing", "section", "engine_section"),
];

/// Width of the pictures [mm].
const WIDTH: f64 = 170.0;

/// Names of the files and their SVG.
///
/// # Panics
/// A scene of the repository has no such picture.
pub fn images() -> Vec<(String, String)> {
    let mut images = Vec::new();
    let mut of_scene: Option<(&str, DrawnFilm)> = None;
    for (name, picture, file) in IMAGES {
        if of_scene.as_ref().is_none_or(|(other, _)| *other != name) {
            let options = RunOptions {
                bars: false,
                picture: PictureOptions { surface: Surface::Developed, ..PictureOptions::default() },
                ..RunOptions::default()
            };
            let run = run(&variant(name, |_| {}), &options).expect("a film");
            let film = DrawnFilm::new(run.result, &run.picture.expect("a picture")).expect("a film to draw");
            of_scene = Some((name, film));
        }
        let (_, film) = of_scene.as_ref().expect("the film of the scene");
        let options = PlotOptions { selected: vec![picture.to_owned()], width: WIDTH };
        let figures = film_figures(film, &options).expect("a picture of the film");
        let (_, figure) = figures.first().expect("a figure");
        images.push((format!("{file}.svg"), figure.to_svg()));
    }
    images
}
