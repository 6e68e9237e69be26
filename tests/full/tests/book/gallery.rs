//! The gallery shows all scenes, as they are.

use oilwedge_full::book::Page;
use oilwedge_full::gallery::{PICTURES, exhibit, picture_file, scenes as all};
use oilwedge_tests::program::repository;

#[test]
fn the_gallery_has_every_scene_in_order() {
    let page = Page::read("docs/gallery.md");
    let entries = std::fs::read_dir(repository().join("scenes")).expect("the scenes");
    let mut scenes: Vec<String> = entries
        .map(|entry| entry.expect("an entry").file_name().to_string_lossy().into_owned())
        .filter_map(|name| name.strip_suffix(".toml").map(str::to_owned))
        .collect();
    scenes.sort();
    assert!(all().map(|(name, _)| name).eq(scenes.iter().map(String::as_str)));
    let shown: Vec<&str> = page.text.lines().filter(|line| line.starts_with("![")).collect();
    let wanted = scenes.iter().map(|name| format!("]({PICTURES}/{name}.svg)"));
    assert_eq!(shown.len(), scenes.len());
    assert!(shown.iter().zip(wanted).all(|(line, end)| line.ends_with(&end)));
    assert_eq!(page.text.matches("\n## ").count(), scenes.len());
    let pictures = std::fs::read_dir(repository().join("docs").join(PICTURES)).expect("the pictures");
    assert_eq!(pictures.count(), scenes.len());
}

/// A film, one that breaks, one under a load, and a sweep; all of them take minutes.
#[test]
fn the_gallery_is_up_to_date() {
    let page = Page::read("docs/gallery.md");
    for chosen in ["01_plain_ring", "12_flexpde_shell_cavitated", "16_loaded_shell", "18_sweep_eccentricity"] {
        let (name, picture) = all().find(|(name, _)| *name == chosen).expect("a scene");
        let exhibit = exhibit(name, picture);
        let svg = std::fs::read_to_string(picture_file(name)).expect("a picture");
        assert!(
            page.text.contains(&exhibit.text) && svg == exhibit.svg,
            "{name}: run: cargo run --release -p oilwedge-full -- validation gallery"
        );
    }
}
