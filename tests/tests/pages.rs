//! The HTML page: what is in it, that it needs nothing else, that it is small and the same each time. How it looks and
//! behaves in a browser: `tests/crosscheck/test_report.py`.

use base64_simd::STANDARD;
use oilwedge_report::page::{Extras, film_page};
use oilwedge_study::result::RunResult;
use oilwedge_study::{RunOptions, run};
use oilwedge_tests::bench::Bench;
use oilwedge_tests::program::oilwedge_command;
use oilwedge_tests::scenes::{variant, written};
use sha2::{Digest, Sha256};

/// The result of a scene, and its page.
fn paged(name: &str) -> (RunResult, String) {
    let run = run(&variant(name, |_| {}), &RunOptions::default()).expect("a film");
    let page = film_page(&run.result, run.picture.as_ref(), Extras::default()).expect("a page");
    (run.result, page)
}

/// What stands between two marks, each time.
fn between<'a>(text: &'a str, from: &str, to: &str) -> Vec<&'a str> {
    text.split(from).skip(1).filter_map(|rest| rest.split(to).next()).collect()
}

/// The page without the wall times, the one part that differs from run to run.
fn timeless(page: &str) -> String {
    let (before, rest) = page.split_once("<div id=\"timings\">").expect("wall times");
    let (_, after) = rest.split_once("</table></div></div>").expect("their end");
    format!("{before}{after}")
}

#[test]
fn the_page_of_the_engine_bearing_is_whole_small_and_alone() {
    let (result, page) = paged("17_engine_main_bearing");
    let result = serde_json::to_value(&result).expect("JSON");
    assert!(page.len() < 1_000_000, "{} bytes", page.len());
    for other in ["url(http", "<link", "<img", "<iframe", "@import", "fetch(", "eval(", " src="] {
        assert!(!page.contains(other), "{other}");
    }
    let addresses: Vec<&str> = page.split("://").skip(1).map(|rest| &rest[..10]).collect();
    assert!(addresses.iter().all(|it| *it == "www.w3.org"), "{addresses:?}");
    for part in [
        "id=\"map\"",
        "id=\"view\"",
        "id=\"readout\"",
        "name=\"field\" value=\"pressure\"",
        "Not simulated:",
        "id=\"figure-pressure\"",
    ] {
        assert!(page.contains(part), "no {part}");
    }
    for (name, quantity) in result["quantities"].as_object().expect("quantities") {
        for key in ["value", "error"] {
            let Some(number) = quantity[key].as_f64() else { continue };
            assert!(page.contains(&format!("<data value=\"{number}\">")), "no {key} of {name}, {number}");
        }
        for (part, number) in quantity["error_parts"].as_object().into_iter().flatten() {
            let number = number.as_f64().expect("a number");
            assert!(
                number == 0.0 || page.contains(&format!("{part} <data value=\"{number}\">")),
                "no part {part} of {name}"
            );
        }
    }
    for table in ["balances", "regime"] {
        for (name, number) in result[table].as_object().expect("a table") {
            let Some(number) = number.as_f64() else { continue };
            let is_there = page.contains(&format!("<data value=\"{number}\">"))
                || page.contains(&format!("below {}", number.round()));
            assert!(is_there, "no {name} of {table}: {number}");
        }
    }
    let scene = result["scene"].as_str().expect("its text");
    assert!(scene.lines().all(|line| line.contains(['"', '<', '&', '>', '\'']) || page.contains(line)));
}

/// The first line says whether the bearing is fit, and the criteria stand below the cards.
#[test]
fn the_header_is_the_verdict() {
    let page = |limits: &str| {
        let scene = written(&format!(
            "[bearing]\ndiameter = '60 mm'\nlength = '30 mm'\nclearance = '30 um'\n[mesh]\nsize = '8 mm'\n\
             [journal]\nspeed = '3000 rpm'\neccentricity = 0.6\nmin_film_angle = '270 deg'\n\
             [oil]\ngrade = 'SAE 30'\n[heat]\ninlet = '60 C'\n[cavitation]\nmodel = 'reynolds'\n{limits}"
        ));
        let run = run(&scene, &RunOptions::of(&scene)).expect("a film");
        film_page(&run.result, None, Extras::default()).expect("a page")
    };
    let limited = page("[criteria]\nfilm_min = '11 um'\npressure_max = '1 bar'\n");
    let header = between(&limited, "<header>", "</header>")[0];
    assert!(header.contains("<p class=\"verdict bad\"><strong>NOT fit</strong>"), "{header}");
    assert!(header.contains("greatest pressure above 1 bar") && !header.contains("least film"), "{header}");
    let places = ["class=\"cards\"", "Design criteria", "The bearing"].map(|part| limited.find(part).expect(part));
    assert!(places.is_sorted());
    let first: Vec<&str> = between(&limited, "class=\"card\"><dt title=\"", "</dt>");
    let names =
        ["least film", "greatest pressure", "power loss", "oil flow", "temperature of the film", "eccentricity"];
    assert!(first.iter().zip(names).all(|(card, name)| card.contains(&format!(">{name} "))), "{first:?}");
    let free = page("");
    assert!(!free.contains("class=\"verdict") && free.contains("usual value below 115"), "{free}");
}

#[test]
fn the_policy_names_the_hashes_of_script_and_style() {
    let (_, page) = paged("01_plain_ring");
    let policy =
        between(&page, "Content-Security-Policy\" content=\"", "\"")[0].replace("&#x27;", "'").replace("&#x2f;", "/");
    assert!(policy.starts_with("default-src 'none'; "), "{policy}");
    assert!(!policy.contains("unsafe"), "{policy}");
    let script = *between(&page, "<script>", "</script>").last().expect("a script");
    let style = between(&page, "<style>", "</style>")[0];
    for (directive, text) in [("script-src", script), ("style-src", style)] {
        let hash = STANDARD.encode_to_string(Sha256::digest(text));
        assert!(policy.contains(&format!("{directive} 'sha256-{hash}'")), "{directive}: {policy}");
    }
    let body = page.split("<body>").nth(1).expect("a body").split("<script").next().expect("its elements");
    assert!(!body.contains(" style=") && !body.contains(" onclick"), "the policy forbids it");
}

#[test]
fn the_same_results_give_the_same_page_but_for_its_wall_times() {
    let [first, second] = [0, 1].map(|_| paged("12_flexpde_shell_cavitated").1);
    assert_eq!(timeless(&first), timeless(&second));
}

#[test]
fn titles_cannot_break_out_of_the_page() {
    let mut result = paged("01_plain_ring").0;
    result.head.title = "</title><script>alert(1)</script>".into();
    result.head.scene = "title = \"</pre><script>alert(2)</script>\"".into();
    let page = film_page(&result, None, Extras::default()).expect("a page");
    assert!(!page.contains("<script>alert"), "not escaped");
}

/// An orbit that closes soon.
const ORBIT: &str = r#"
bearing = { diameter = "50 mm", length = "25 mm", clearance = "30 um" }
mesh.size = "8 mm"
journal.speed = "3000 rpm"
oil.viscosity = "10 mPa.s"
cavitation.model = "reynolds"
orbit = { tolerance = 3e-2 }

[load]
harmonics = [{ order = 0, cos = { x = "2 kN" } }, { order = 1, sin = { y = "3 kN" } }]
frame = "shell"
period = "360 deg"
"#;

/// The scene is saved from the page with the files that it names; the page of a folder can but name them.
#[test]
fn the_files_of_a_scene_are_saved_with_it() {
    let bench = Bench::new();
    bench.scene("01_plain_ring", &[]);
    let told = bench.run(&["solve", "scene.toml", "--bars", "none", "--out", "out", "--report"]);
    assert_eq!(told.status, 0, "{}", told.stderr);
    let page = || std::fs::read_to_string(bench.path().join("out/report.html")).expect("a page");
    let links = |page: &str| between(page, "<a download=\"", "\"").join(" ");
    assert_eq!(links(&page()), "scene.toml ring.msh");
    bench.run(&["report", "out"]);
    assert_eq!(links(&page()), "scene.toml");
    assert!(page().contains("files that are not on this page") && page().contains("ring.msh"));
}

#[test]
fn the_page_of_a_folder_is_that_of_its_run() {
    let bench = Bench::new();
    bench.write("scene.toml", ORBIT);
    let told = bench.run(&["solve", "scene.toml", "--bars", "none", "--out", "out", "--report"]);
    assert_eq!(told.status, 0, "{}", told.stderr);
    assert!(told.stdout.contains("report.html"), "{}", told.stdout);
    let path = bench.path().join("out/report.html");
    let first = std::fs::read_to_string(&path).expect("a page");
    std::fs::remove_file(&path).expect("removed");
    let told = bench.run(&["report", "out"]);
    assert_eq!(told.status, 0, "{}", told.stderr);
    assert!(std::fs::read_to_string(&path).expect("a page") == first, "another page");
    assert!(first.contains("id=\"figure-orbit_load\"") && first.contains("The cycle"));
    // A page of an earlier run does not stand beside other results.
    bench.run(&["solve", "scene.toml", "--bars", "none", "--out", "out"]);
    assert!(!path.exists());
}

#[test]
fn a_folder_without_results_is_refused() {
    let bench = Bench::new();
    let told = bench.run(&["report", "."]);
    assert_eq!(told.status, 2);
    assert!(told.stderr.contains("result.json") && told.stderr.contains("oilwedge solve"), "{}", told.stderr);
}

#[cfg(target_os = "linux")]
#[test]
fn a_browser_that_does_not_open_is_told() {
    use std::os::unix::fs::PermissionsExt;
    let bench = Bench::new();
    bench.scene("01_plain_ring", &[]);
    bench.write("xdg-open", "#!/bin/sh\nexit 3\n");
    let browser = bench.path().join("xdg-open");
    std::fs::set_permissions(browser, std::fs::Permissions::from_mode(0o755)).expect("a program");
    let told = oilwedge_command()
        .args(["solve", "scene.toml", "--out", "out", "--open"])
        .current_dir(bench.path())
        .env("PATH", bench.path())
        .output()
        .expect("oilwedge starts");
    let stderr = String::from_utf8_lossy(&told.stderr);
    assert!(told.status.success(), "{stderr}");
    assert!(stderr.contains("no browser could be opened"), "{stderr}");
    assert!(bench.path().join("out/report.html").is_file());
}
