//! `oilwedge design`: its files, and what it says of wrong tables.

use oilwedge_tests::bench::{Bench, edited, object};

const DESIGN: &str = "
[mesh]
size = \"12 mm\"
[design]
free = { clearance = [\"30 um\", \"45 um\"] }
maximise = \"load\"
";

fn read(bench: &Bench, name: &str) -> String {
    std::fs::read_to_string(bench.path().join(name)).unwrap_or_else(|error| panic!("{name}: {error}"))
}

#[test]
fn the_optimum_is_written_with_its_scene_and_its_path() {
    let bench = Bench::new();
    bench.write("scene.toml", edited("09_drawn_ring", &[]) + DESIGN);
    let told = bench.run(&["design", "scene.toml", "--bars", "none", "--report"]);
    assert_eq!(told.status, 0, "{}", told.stderr);
    for words in ["at a bound", "30.000 um", "maximise: load", "films, none for gradients", "optimum.toml"] {
        assert!(told.stdout.contains(words), "{words}: {}", told.stdout);
    }
    let result = object(&read(&bench, "out/scene/result.json"));
    assert_eq!(result["design"]["keys"][0]["optimum"], 30.0);
    let [scene, optimum] = ["scene.toml", "out/scene/optimum.toml"].map(|name| read(&bench, name));
    assert_eq!(scene.replace("\"37.5 um\"", "\"30 um\""), optimum);
    let path = read(&bench, "out/scene/design.csv");
    assert!(path.starts_with("film,bearing.clearance [um],load [N],reason\n1,37.5,"), "{path}");
    assert!(read(&bench, "out/scene/report.html").contains("at a bound"));
    let solved = object(&bench.run(&["solve", "out/scene/optimum.toml", "--bars", "none", "--json"]).stdout);
    assert_eq!(solved["quantities"]["load"]["value"], result["quantities"]["load"]["value"]);
    let checked = bench.run(&["check", "scene.toml"]).stdout;
    assert!(checked.contains("maximise load; bearing.clearance from 30 um to 45 um"), "{checked}");
}

#[test]
fn limits_that_no_numbers_meet_are_an_answer() {
    let bench = Bench::new();
    let criteria = "[criteria]\nfilm_min = \"25 um\"\n";
    bench.write("scene.toml", edited("09_drawn_ring", &[]) + DESIGN + criteria);
    let told = bench.run(&["design", "scene.toml", "--bars", "none"]);
    assert_eq!(told.status, 1, "{}", told.stderr);
    assert!(told.stdout.contains("no numbers within the bounds meet all criteria"), "{}", told.stdout);
    assert!(told.stdout.contains("45.000 um"), "{}", told.stdout);
}

#[test]
fn wrong_tables_are_refused_with_a_way_out() {
    let bench = Bench::new();
    let scene = edited("09_drawn_ring", &[]);
    for (from, to, wanted) in [
        ("clearance =", "clearence =", "design.free.clearence: this key is not known as an axis"),
        ("clearance =", "\"bearing.hole\" =", "design.free.bearing.hole: is no number that stands in this scene"),
        ("[\"30 um\", \"45 um\"]", "[\"45 um\", \"30 um\"]", "has its bounds reversed: 45 um is not below 30 um"),
        ("[\"30 um\", \"45 um\"]", "[\"30 um\"]", "has no two bounds"),
        ("[\"30 um\", \"45 um\"]", "[\"40 um\", \"45 um\"]", "starts from 37.5 um, which lies outside"),
        (
            "[\"30 um\", \"45 um\"]",
            "[\"-30 um\", \"45 um\"]",
            "with bearing.clearance = -30 um, bearing.clearance: is not positive",
        ),
        ("[\"30 um\", \"45 um\"]", "[\"30 bar\", \"45 bar\"]", "\"bar\" is a unit of pressure"),
        ("\"load\"", "\"lod\"", "design.maximise: \"lod\" is no quantity"),
        ("maximise = \"load\"", "", "design: has no objective"),
        ("maximise", "minimise = \"load\"\nmaximise", "design.maximise: stands beside minimise"),
    ] {
        assert!(DESIGN.contains(from), "{from}");
        bench.write("scene.toml", scene.clone() + &DESIGN.replacen(from, to, 1));
        let told = bench.run(&["design", "scene.toml"]);
        assert_eq!(told.status, 2, "{to}: {}", told.stderr);
        assert!(told.stderr.contains(wanted) && told.stderr.contains("help"), "{to}: {}", told.stderr);
        assert!(!bench.path().join("out").exists());
    }
    bench.write("scene.toml", scene);
    let told = bench.run(&["design", "scene.toml"]);
    assert!(told.status == 2 && told.stderr.contains("has no [design]; write for example"), "{}", told.stderr);
}
