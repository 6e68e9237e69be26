//! Feeds that overlap, and grooves that divide the film.

use oilwedge_mesh::generate::{Blueprint, Feature, RoundedRectangle, generate};
use oilwedge_mesh::{developed::LinerDomain, quality::Quality};
use oilwedge_scene::Scene;
use oilwedge_study::outline::LinerOutline;
use oilwedge_study::warnings::warnings;
use oilwedge_study::{RunOptions, run};
use oilwedge_tests::bench::Bench;
use oilwedge_tests::scenes::{Solved, solve, written};

const GROOVE: &str = r#"groove = { from = "80 deg", to = "100 deg", width = "16 mm" }"#;
const HOLE: &str = r#"hole = { diameter = "14 mm", angle = "90 deg" }"#;

/// A journal bearing of 60 x 30 mm with these keys of `[bearing]`, this model of cavitation and these feeds.
fn text(bearing: &str, model: &str, feeds: &[(&str, &str, &str)]) -> String {
    let feed = |(name, shape, pressure): &(&str, &str, &str)| {
        format!("[[feed]]\ngroup = \"{name}\"\npressure = \"{pressure} bar\"\n{shape}\n")
    };
    let feeds: String = feeds.iter().map(feed).collect();
    format!(
        r#"
[bearing]
diameter = "60 mm"
length = "30 mm"
clearance = "30 um"
{bearing}
[mesh]
size = "2 mm"
[journal]
speed = "3000 rpm"
eccentricity = 0.6
min_film_angle = "300 deg"
[oil]
viscosity = "20 mPa.s"
[cavitation]
model = "{model}"
{feeds}"#
    )
}

fn scene(model: &str, feeds: &[(&str, &str, &str)]) -> Scene {
    written(&text("", model, feeds))
}

fn solved(scene: &Scene) -> Solved {
    solve(scene).unwrap_or_else(|reason| panic!("{reason}"))
}

/// A hole within a groove changes nothing but the name.
#[test]
fn a_hole_within_a_groove_is_the_groove() {
    let small = r#"hole = { diameter = "5 mm", angle = "91 deg", z = "1 mm" }"#;
    for model in ["reynolds", "jfo"] {
        let alone = solved(&scene(model, &[("groove", GROOVE, "2")]));
        let both = solved(&scene(model, &[("groove", GROOVE, "2"), ("hole", small, "2")]));
        assert_eq!(alone.measured.load.total, both.measured.load.total);
        assert_eq!(alone.quantity("feed_flow.groove"), both.quantity("feed_flow.groove+hole"));
    }
}

/// Two grooves that overlap are the groove of their extent, in any order; a groove divided in two halves that touch is
/// the whole one.
#[test]
fn parts_of_a_groove_are_the_groove() {
    let whole = solved(&scene("reynolds", &[("groove", GROOVE, "2")]));
    for (first, second) in
        [("80 deg\", to = \"92", "87 deg\", to = \"100"), ("80 deg\", to = \"90", "90 deg\", to = \"100")]
    {
        let part = |ends: &str| format!("groove = {{ from = \"{ends} deg\", width = \"16 mm\" }}");
        let parts = [part(first), part(second)];
        for order in [[0, 1], [1, 0]] {
            let feeds = order.map(|k| (["a", "b"][k], parts[k].as_str(), "2"));
            let union = solved(&scene("reynolds", &feeds));
            let name = ["feed_flow.a+b", "feed_flow.b+a"][order[0]];
            let off = union.quantity(name) / whole.quantity("feed_flow.groove") - 1.0;
            assert!(off.abs() < 2e-3, "{off}");
            let off = union.quantity("load") / whole.quantity("load") - 1.0;
            assert!(off.abs() < 1e-3, "{off}");
        }
    }
}

/// The rim of a union is booked once: its oil balances, and its share of the load is that of its area.
#[test]
fn a_hole_wider_than_its_groove_adds_two_caps() {
    let groove = r#"groove = { from = "70 deg", to = "110 deg", width = "6 mm" }"#;
    for model in ["none", "jfo"] {
        let union = solved(&scene(model, &[("groove", groove, "2"), ("hole", HOLE, "2")]));
        let flows = &union.measured.flows;
        assert!(flows.imbalance < 1e-8, "{}", flows.imbalance);
        let area = union.measured.load.cut_out[0].1.pressure / 2e5;
        let (radius, half) = (7e-3_f64, 3e-3_f64);
        let inside = 2.0 * (radius * radius * (half / radius).asin() + half * (radius * radius - half * half).sqrt());
        let arc = 0.03 * 40f64.to_radians();
        let wanted = arc * 6e-3 + std::f64::consts::PI * radius * radius - inside;
        assert!((area / wanted - 1.0).abs() < 1e-6, "{model}: {area} {wanted}");
    }
}

/// The share of a union in the load is exact only where its rim is straight: the arcs of a hole are parabolas of the
/// mesh.
#[test]
fn the_share_of_a_union_has_a_bar() {
    let groove = r#"groove = { from = "70 deg", to = "110 deg", width = "6 mm" }"#;
    let wide = r#"groove = { from = "85 deg", to = "95 deg", width = "10 mm" }"#;
    let share = |second: &str, size: &str| {
        let text = text("", "reynolds", &[("groove", groove, "2"), ("other", second, "2")]);
        let scene = written(&text.replace("size = \"2 mm\"", &format!("size = \"{size}\"")));
        let result = run(&scene, &RunOptions::default()).expect("a film").result;
        let share = result.by_name("load_y.groove+other").expect("its share");
        let bar = share.error().expect("a bar");
        // It is in the bar of the whole load as well.
        let whole = result.by_name("load").and_then(|load| load.bar).expect("a bar");
        assert!(whole.geometry >= bar, "{whole:?} {bar:e}");
        (share.value, bar)
    };
    let ([coarse, fine], straight) = (["3 mm", "1 mm"].map(|size| share(HOLE, size)), share(wide, "3 mm"));
    assert!(coarse.1 > 0.0 && fine.1 < coarse.1, "{coarse:?} {fine:?}");
    let off = (coarse.0 - fine.0).abs();
    assert!(off <= coarse.1 + fine.1 && off > 0.3 * coarse.1, "{coarse:?} {fine:?}");
    assert_eq!(straight.1, 0.0);
}

/// Holes in grooves all around, across the seam, and three in a row.
#[test]
fn unions_are_meshed_well() {
    let liner = LinerDomain { radius: 0.03, length: 0.03, arc: None };
    let rectangle = |x: f64, half: [f64; 2]| RoundedRectangle { centre: [x, 0.0], half, corner: 0.0 };
    let cases = [
        (true, vec![rectangle(0.0, [f64::INFINITY, 2e-3]), RoundedRectangle::disc([0.05, 0.0], 5e-3)]),
        (false, vec![rectangle(0.0, [5e-3, 9e-3]), RoundedRectangle::disc([-6e-3, 2e-3], 4e-3)]),
        (
            false,
            vec![
                RoundedRectangle::disc([0.05, 0.0], 5e-3),
                RoundedRectangle::disc([0.056, 0.0], 5e-3),
                RoundedRectangle::disc([0.06, 3e-3], 5e-3),
            ],
        ),
        (false, vec![rectangle(0.05, [3e-3, 0.015]), RoundedRectangle::disc([0.05, 0.0], 5e-3)]),
    ];
    for (meshed, shapes) in cases {
        let feature = |shape| Feature { name: "one".to_owned(), shape, meshed };
        let features = shapes.into_iter().map(feature).collect();
        let line = None;
        let mesh =
            generate(&Blueprint { liner, features, line }, &|_| 2e-3).unwrap_or_else(|faults| panic!("{faults:?}"));
        let quality = Quality::of(&mesh);
        assert!(quality.least_angle > 20.0, "{}", quality.least_angle);
        assert_eq!(quality.unnamed_boundary_edges, 0);
    }
}

#[test]
fn overlapping_feeds_of_different_pressures_are_refused_with_a_way_out() {
    let bench = Bench::new();
    bench.write("scene.toml", text("", "reynolds", &[("groove", GROOVE, "3"), ("hole", HOLE, "2")]));
    let words = ["overlaps \"groove\"", "at 2 bar and the other at 3 bar", "give both one pressure"];
    bench.refuses(&["solve", "scene.toml"], &words);
    let beside = r#"hole = { diameter = "5 mm", angle = "75.3 deg" }"#;
    bench.write("scene.toml", text("", "reynolds", &[("groove", GROOVE, "2"), ("hole", beside, "2")]));
    bench.refuses(
        &["solve", "scene.toml"],
        &["the rims of \"groove+hole\" meet at 10.1 deg", "overlap feeds of one pressure more"],
    );
}

/// With pressures that differ from case to case two feeds are one region in one case, and a fault in the other.
#[test]
fn regions_follow_the_pressures() {
    let names = |pressure| {
        let far = r#"hole = { diameter = "5 mm", angle = "200 deg" }"#;
        let feeds = [("a", GROOVE, "2"), ("b", far, pressure), ("c", HOLE, "2")];
        let scene = scene("reynolds", &feeds);
        LinerOutline::of(&scene).regions().into_iter().map(|region| region.name).collect::<Vec<String>>()
    };
    assert_eq!(names("2"), ["a+c", "b"]);
    assert_eq!(names("1"), ["a+c", "b"]);
}

const FULL: [(&str, &str, &str); 2] = [
    ("top", r#"groove = { from = "80 deg", to = "100 deg", width = "30 mm" }"#, "0"),
    ("bottom", r#"groove = { from = "260 deg", to = "280 deg", width = "30 mm" }"#, "0"),
];

/// Two grooves from end to end leave two films, each that of an arc. Both grooves have the pressure of the ends, as the
/// edges of arcs have.
#[test]
fn grooves_of_full_length_leave_independent_arcs() {
    for (model, within) in [("none", 1e-3), ("reynolds", 1e-3), ("jfo", 6e-3)] {
        let options = RunOptions::default();
        let of = |scene: &Scene| {
            let run = run(scene, &options).unwrap_or_else(|error| panic!("{error}"));
            let value = |name: &str| {
                let found = run.result.quantities.iter().find(|it| it.name == name);
                found.map_or(0.0, |it| it.value)
            };
            ["load_x", "load_y", "side_flow", "friction_power"].map(value)
        };
        let divided = of(&scene(model, &FULL));
        let arcs = [("100", "260"), ("280", "440")].map(|(from, to)| {
            let arc = format!("arc = {{ from = \"{from} deg\", to = \"{to} deg\" }}");
            of(&written(&text(&arc, model, &[])))
        });
        let sum: Vec<f64> = (0..4).map(|k| arcs[0][k] + arcs[1][k]).collect();
        let load = sum[0].hypot(sum[1]);
        for k in 0..4 {
            let scale = if k < 2 { load } else { sum[k].abs() };
            assert!((divided[k] - sum[k]).abs() < within * scale, "{model} {k}: {divided:?} {sum:?}");
        }
    }
}

/// What a groove of full length carries is its pressure on its projection, and its oil balances; the flow round its
/// corners has no limit, which is said.
#[test]
fn a_groove_of_full_length_carries_its_pressure() {
    for model in ["reynolds", "jfo"] {
        let feeds = FULL.map(|(name, shape, _)| (name, shape, "2"));
        let solved = solved(&scene(model, &feeds));
        let top = &solved.measured.load.cut_out.iter().find(|(name, _)| name == "top").expect("the groove").1;
        let chord = 2.0 * 0.03 * 10f64.to_radians().sin();
        assert!((top.force[1] / (2e5 * 0.03 * chord) - 1.0).abs() < 1e-9, "{:?}", top.force);
        assert!((top.pressure / (2e5 * 0.03 * 0.03 * 20f64.to_radians()) - 1.0).abs() < 1e-9);
        assert!(solved.measured.flows.imbalance < 1e-8);
        let all = warnings(&solved.study, &solved.measured);
        assert!(all.iter().any(|it| it.contains("has no limit")), "{all:?}");
    }
    let solved = solved(&scene("reynolds", &FULL));
    let all = warnings(&solved.study, &solved.measured);
    assert!(!all.iter().any(|it| it.contains("has no limit")), "{all:?}");
}

/// The loaded film begins behind a groove of full length at the widest film, as behind the leading edge of an arc.
#[test]
fn the_loaded_film_begins_behind_a_groove_of_full_length() {
    let widest = r#"groove = { from = "110 deg", to = "130 deg", width = "30 mm" }"#;
    let groove = solved(&scene("jfo", &[("top", widest, "0")])).quantity("inlet_flow");
    let arc = written(&text(r#"arc = { from = "130 deg", to = "470 deg" }"#, "jfo", &[]));
    let arc = solved(&arc).quantity("inlet_flow");
    assert!((groove / arc - 1.0).abs() < 1e-2, "{groove} {arc}");
}

/// A groove that leaves next to no land at the ends carries as much as one of full length.
#[test]
fn a_short_land_makes_little_difference() {
    let short = r#"groove = { from = "80 deg", to = "100 deg", width = "29.6 mm" }"#;
    let load = |shape: &str| solved(&scene("reynolds", &[("top", shape, "2")])).quantity("load");
    let (full, short) = (load(FULL[0].1), load(short));
    assert!((full / short - 1.0).abs() < 2e-3, "{full} {short}");
}

/// The step pad of Rayleigh with finite width, whose pocket begins at the edge of the arc and has its whole width.
/// Reference: series of `cos(n pi z/L)` along the axis, exact along the arc for each n, to n = 399.
#[test]
fn a_step_from_the_edge_of_an_arc_is_that_of_the_series() {
    let of = |to: &str| {
        written(&format!(
            r#"
bearing = {{ diameter = "100 mm", length = "100 mm", clearance = "50 um", arc = {{ from = "0 deg", to = "60 deg" }} }}
mesh = {{ size = "4 mm" }}
journal = {{ speed = "1000 rpm", eccentricity = 0 }}
oil = {{ viscosity = "20 mPa.s" }}
cavitation = {{ model = "reynolds" }}
[[feed]]
group = "step"
groove = {{ from = "0 deg", to = "{to}", width = "100 mm" }}
depth = "43.3 um"
"#
        ))
    };
    let result = run(&of("43.08 deg"), &RunOptions::default()).expect("a film").result;
    for (name, exact) in [("load", 1_357.266_245), ("load_angle", 35.378_325)] {
        let found = result.quantities.iter().find(|it| it.name == name).expect(name);
        let (off, bar) = ((found.value - exact).abs(), found.error().expect("a bar"));
        assert!(off < bar && bar < 1e-2 * exact, "{name}: {} +- {bar}", found.value);
    }
}

/// The dam of Nicholas, Barrett and Leader, ASME J. Mech. Des. 102 (1980) 80, table 6, bearing 1 of set 1, begins where
/// its groove ends: S = 3.5, eps = 0.29, stable up to `omega sqrt(c/g)` = 7.5; 10 % is asked, for their film has other
/// elements and other rules for the cavity.
#[test]
fn a_pressure_dam_begins_where_its_groove_ends() {
    let dam = |start: &str| {
        format!(
            r#"
bearing = {{ diameter = "1 in", length = "1 in", clearance = "2.2 mil" }}
journal = {{ speed = "8000 rpm" }}
load = {{ force = "66.278 N", angle = "270 deg" }}
oil = {{ viscosity = "7.60e-6 reyn" }}
cavitation = {{ model = "reynolds" }}
mesh = {{ size = "2 mm" }}
dynamics = {{ mass = "6.75848 kg" }}
[[feed]]
group = "groove_a"
groove = {{ from = "-10 deg", to = "10 deg", width = "1 in" }}
pressure = "0 bar"
[[feed]]
group = "groove_b"
groove = {{ from = "170 deg", to = "190 deg", width = "1 in" }}
pressure = "0 bar"
[[feed]]
group = "dam"
groove = {{ from = "{start}", to = "145 deg", width = "19.05 mm" }}
depth = "60.96 um"
"#
        )
    };
    let result = run(&written(&dam("10 deg")), &RunOptions::default()).expect("a film").result;
    let value = |name: &str| result.quantities.iter().find(|it| it.name == name).expect(name).value;
    // Of the same geometry as a mesh of gmsh.
    assert!((value("eccentricity") / 0.28181 - 1.0).abs() < 2e-3, "{}", value("eccentricity"));
    assert!((value("critical_mass") / 88.36 - 1.0).abs() < 1e-2, "{}", value("critical_mass"));
    assert!((value("eccentricity") / 0.29 - 1.0).abs() < 0.1);
    let bench = Bench::new();
    for (start, words) in [
        ("9.9 deg", ["\"groove_a\"", "straight sides may touch"]),
        ("10.01 deg", ["\"groove_a\" and \"dam\" leave 2.2e-6 m of land", "straight sides touch"]),
    ] {
        bench.write("scene.toml", dam(start));
        bench.refuses(&["check", "scene.toml"], &words);
    }
}

#[test]
fn almost_no_land_is_refused_in_plain_words() {
    let bench = Bench::new();
    let refused = |width: &str, words: &[&str]| {
        let groove = format!("groove = {{ from = \"80 deg\", to = \"100 deg\", width = \"{width} mm\" }}");
        bench.write("scene.toml", text("", "reynolds", &[("top", &groove, "2")]));
        bench.refuses(&["solve", "scene.toml"], words);
    };
    refused(
        "29.995",
        &[
            "\"top\" leaves only 2.500e-6 m of land",
            "let a straight side of it, without round corners, lie on the edge",
        ],
    );
    let beyond = r#"groove = { from = "80 deg", to = "100 deg", width = "20 mm", z = "6 mm" }"#;
    bench.write("scene.toml", text("", "reynolds", &[("top", beyond, "2")]));
    bench.refuses(&["solve", "scene.toml"], &["reaches 1.000e-3 m beyond the edge of the liner"]);
}
