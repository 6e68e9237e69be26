//! `validation [PART..]`: writes the computed tables and figures of the pages in `docs` anew; or those of pages in
//! whose names a part is. `validation gallery SCENE..` writes the entries of these scenes alone.

use oilwedge_full::{
    cavitation_page, crankshafts_page, docs_images, engine_page, flexpde_page, gallery, mesh_page, notation_page,
    orbits_page, quantities_page, scene_page, thermal_page,
};
use oilwedge_full::{short_bearing_figures as figures, short_bearing_page as page};
use oilwedge_tests::program::repository;

/// Runs the command.
pub(crate) fn run(arguments: &[String]) -> Result<(), Box<dyn std::error::Error>> {
    let docs = repository().join("docs");
    let is_wanted = |name: &str| arguments.is_empty() || arguments.iter().any(|part| name.contains(part.as_str()));
    let write = |name: &str, page: &dyn Fn(&str) -> String| {
        if !is_wanted(name) {
            return Ok(());
        }
        let path = docs.join(name);
        let written = std::fs::read_to_string(&path)?;
        std::fs::write(&path, page(&written))
    };
    write("reference/quantities.md", &quantities_page::page)?;
    write("reference/scene.md", &scene_page::page)?;
    write("theory/notation.md", &notation_page::page)?;
    write("validation/flexpde_study.md", &flexpde_page::page)?;
    write("theory/cavitation.md", &cavitation_page::page)?;
    write("howto/mesh.md", &mesh_page::page)?;
    write("validation/engine_bearings.md", &engine_page::page)?;
    write("validation/thermal_films.md", &thermal_page::page)?;
    write("validation/orbits.md", &orbits_page::page)?;
    write("validation/crankshafts.md", &crankshafts_page::page)?;
    if is_wanted("gallery.md") {
        write_gallery(&arguments[arguments.len().min(1)..])?;
    }
    if !arguments.is_empty() {
        return Ok(());
    }
    let study = page::Study::solved();
    write("validation/short_bearing.md", &|text| page::page_of(text, &study))?;
    let folder = docs.join("validation/short_bearing");
    std::fs::create_dir_all(&folder)?;
    for (name, svg) in figures::sheets(&study) {
        std::fs::write(folder.join(format!("{name}.svg")), svg)?;
    }
    std::fs::create_dir_all(docs.join("images"))?;
    for (file, svg) in docs_images::images() {
        std::fs::write(docs.join("images").join(file), svg)?;
    }
    Ok(())
}

/// Solves all scenes, or those that are named, and writes their page and pictures.
fn write_gallery(named: &[String]) -> std::io::Result<()> {
    let file = repository().join("docs/gallery.md");
    std::fs::create_dir_all(repository().join("docs").join(gallery::PICTURES))?;
    let before = std::fs::read_to_string(&file).unwrap_or_default();
    let mut parts = Vec::new();
    for (name, picture) in gallery::scenes() {
        let written = before.split("\n## ").find(|part| part.contains(&format!("`scenes/{name}.toml`")));
        if let Some(part) = written.filter(|_| !named.is_empty() && !named.iter().any(|it| it == name)) {
            parts.push(format!("## {}\n", part.trim_end()));
            continue;
        }
        eprintln!("{name}");
        let exhibit = gallery::exhibit(name, picture);
        std::fs::write(gallery::picture_file(name), exhibit.svg)?;
        parts.push(exhibit.text);
    }
    std::fs::write(file, gallery::page(parts.iter().map(String::as_str)))
}
