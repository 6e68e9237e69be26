//! What a scene of a bearing asks for beside its film counts on a shaft, too: roughness, bores, and criteria.

use oilwedge_report::difference::of_results;
use oilwedge_study::quantities::{FILM_THICKNESS_MIN, FRICTION_POWER, LOAD, Row};
use oilwedge_study::result::{Status, Verdict};
use oilwedge_study::{RunOptions, parse};
use oilwedge_tests::crankshafts::*;

/// The text of a bearing of `three_films.toml`, rough and on a mesh of its own, with further keys.
fn bearing(keys: &str) -> String {
    let scene = changed(&text("bearings/small_ring.toml"), "\"30 um\"", "\"30 um\"\nroughness = \"3 um\"");
    changed(&scene, "[journal]", &format!("[mesh]\nsize = \"3 mm\"\n\n{keys}\n[journal]"))
}

/// Numbers of that bearing by itself, under the load on the right one of [`two_films`].
fn alone(keys: &str, rows: [&Row; 2]) -> [f64; 2] {
    let scene = changed(&bearing(keys), "eccentricity   = 0.7\nmin_film_angle = \"240 deg\"\n", "");
    let scene = format!("{scene}\n[load]\nforce = \"{RIGHT} kN\"\nangle = \"270 deg\"\n");
    let scene = parse(&scene, &engines("bearings/alone.toml")).unwrap_or_else(|error| panic!("{error}"));
    let options = RunOptions { bars: false, ..RunOptions::of(&scene) };
    let found = oilwedge_study::run(&scene, &options).unwrap_or_else(|error| panic!("{error}"));
    rows.map(|row| found.result.quantity(row).expect(row.name).value)
}

/// The bearings of a cut shaft are, at the loads that statics gives them, what they are by themselves, and not what
/// they are without the keys.
#[test]
fn rough_and_crowned_bearings_of_a_cut_shaft_are_single_bearings() {
    let rows = [&FILM_THICKNESS_MIN, &FRICTION_POWER];
    let plain = alone("", rows);
    let [_, (_, cut)] = BY_STATICS;
    // The mesh of a crowned bore is graded for the position in the scene, so that the single bearing has another one.
    let (same_mesh, other_mesh) = (1e-6, 1e-4);
    for (keys, tolerance) in
        [("[roughness]\nmodel = \"patir-cheng\"\n", same_mesh), ("[[bore]]\ncrown = \"4 um\"\n", other_mesh)]
    {
        let folder = tempfile::tempdir().expect("a folder");
        let path = folder.path().join("ring.toml");
        std::fs::write(&path, bearing(keys)).expect("a file");
        let scene = two_films_with(cut);
        let run = run(&scene.replace("bearings/small_ring.toml", path.to_str().expect("a path")));
        assert_eq!(run.result.head.status, Status::Converged, "{:?}", run.result.head.reason);
        let single = alone(keys, rows);
        for (row, single) in rows.iter().zip(single) {
            let found = numbers(&run, row)[1];
            assert!((found / single - 1.0).abs() < tolerance, "{keys}: {} {found} {single}", row.name);
        }
        assert!((single[0] / plain[0] - 1.0).abs() > 1e-3, "{keys}: {single:?} {plain:?}");
    }
}

/// 5 um lie between the least films of the outer bearings, 6.1 um, and that of the middle one, 3.4 um.
#[test]
fn each_bearing_of_a_shaft_has_its_verdicts() {
    let folder = tempfile::tempdir().expect("a folder");
    let limits =
        "film_min = \"5 um\"\nmiddle_film_min = \"1 um\"\ndeviation_max = \"1 mm\"\nequivalent_film_min = \"1 nm\"";
    let limits = format!("[criteria]\n{limits}\n\n[journal]");
    let criteria = ("[journal]", &*limits);
    let run = run(&with_bearing(folder.path(), "small_ring", criteria, &text("three_films.toml")));
    let verdicts: Vec<_> = (run.result.bearings.iter())
        .map(|bearing| bearing.criteria.iter().map(|it| (it.what.as_str(), it.verdict)).collect::<Vec<_>>())
        .collect();
    let kept = ["least film at mid-length", "deviation of the film at the ends", "equivalent film"];
    let of = |verdict| {
        let kept = kept.map(|what| (what, Verdict::Pass));
        [("least film", verdict)].into_iter().chain(kept).collect::<Vec<_>>()
    };
    assert_eq!(verdicts, [of(Verdict::Pass), of(Verdict::Fail), of(Verdict::Pass)]);
    let whole = run.result.as_one();
    let middle = &run.result.bearings[1];
    let name = format!("{}: {}", middle.name, LOAD.name);
    assert_eq!(whole.by_name(&name).map(|it| it.value), middle.quantity(&LOAD).map(|it| it.value));
    assert_eq!(Verdict::of(&whole.criteria), Some(Verdict::Fail));
    assert!(of_results(&whole, &whole).is_ok_and(|difference| difference.is_none()));
    let mut other = run.result.clone();
    other.bearings[1].quantities.retain(|it| it.row != &LOAD);
    let difference = of_results(&whole, &other.as_one()).expect("a difference");
    assert_eq!(difference.quantities.iter().map(|it| it.name.as_str()).collect::<Vec<_>>(), [name.as_str()]);
}
