//! The tables of `docs/theory/cavitation.md`: the models side by side, and how well the figures of other codes are
//! reached.

use crate::tables::{replace, row};
use oilwedge_tests::journal_bearings::{Ring, block, number, reference};
use oilwedge_tests::scenes::{Solved, solve, table, variant};

/// Sizes [mm] of the meshes, from coarse to fine.
const SIZES: [f64; 3] = [8.0, 5.0, 3.0];

/// The page with its tables computed anew.
pub fn page(page: &str) -> String {
    let page = replace(page, "models", &models());
    replace(&page, "figures", &figures())
}

/// Scene 13 with an edit.
fn grooved(edit: impl FnOnce(&mut toml::Table)) -> Solved {
    solve(&variant("13_grooved_ring", edit)).unwrap_or_else(|reason| panic!("{reason}"))
}

fn models() -> Vec<Vec<String>> {
    let head = [
        "model",
        "load [N]",
        "attitude [deg]",
        "p_max [kPa]",
        "p_min [kPa]",
        "groove delivers [ml/s]",
        "leaves at the ends [ml/s]",
    ];
    let mut rows = vec![row(head)];
    for model in ["none", "guembel", "reynolds", "jfo"] {
        let film = grooved(|scene| {
            table(scene, "cavitation").insert("model".into(), model.into());
        });
        let mut cells = vec![format!("`{model}`")];
        let quantities = [
            ("load", 1.0, 1),
            ("attitude_angle", 1.0, 2),
            ("pressure_max", 1e-3, 1),
            ("pressure_min", 1e-3, 1),
            ("feed_flow.groove", 1e6, 2),
            ("side_flow", 1e6, 2),
        ];
        cells.extend(quantities.map(|(name, unit, digits)| format!("{:.digits$}", unit * film.quantity(name))));
        rows.push(cells);
    }
    rows
}

/// A bearing of `jfo_groove_bearing` with edges of at most `size` [mm].
fn supplied(region: &str, size: f64) -> Solved {
    grooved(|scene| {
        table(scene, "mesh").insert("size".into(), format!("{size} mm").into());
        let feeds = scene["feed"].as_array_mut().expect("feeds");
        let feed = feeds[0].as_table_mut().expect("a feed");
        feed.remove("groove");
        feed.extend(region.parse::<toml::Table>().expect("TOML"));
    })
}

fn figures() -> Vec<Vec<String>> {
    let mut rows = vec![row(["bearing", "model", "nodes", "load", "other code", "off"])];
    let mut add = |bearing: &str, model: &str, film: &Solved, value: f64, digits: usize, expected: f64| {
        rows.push(vec![
            bearing.to_owned(),
            format!("`{model}`"),
            film.study.system.space().dofs().to_string(),
            format!("{value:.digits$}"),
            expected.to_string(),
            format!("{:+.1e}", value / expected - 1.0),
        ]);
    };
    let case = &reference("plain360_swift_stieber", "rows")[5];
    for model in ["reynolds", "jfo"] {
        for size in SIZES {
            let ring = Ring { film_start: true, model, size: Some(size / 37.5), ..Ring::of(case) };
            let film = ring.solve();
            let value = film.sommerfeld_number();
            add("scene 11, So", model, &film.solved, value, 4, number(case, "So"));
        }
    }
    let data = block("jfo_groove_bearing");
    let groove = |width: f64| format!(r#"groove = {{ from = "82.5 deg", to = "97.5 deg", width = "{width} mm" }}"#);
    let hole = format!(
        r#"hole = {{ diameter = "{} mm", angle = "{} rad" }}"#,
        100.0 * number(&data["hole"], "radius_over_R"),
        number(&data["hole"], "angle_rad")
    );
    let cases = [
        ("scene 13, W [N]", "groove", groove(60.0)),
        ("with a short groove", "short_groove", groove(20.0)),
        ("with a round hole", "hole", hole),
    ];
    for (bearing, name, region) in cases {
        for size in SIZES {
            let film = supplied(&region, size);
            let value = film.quantity("load");
            add(bearing, "jfo", &film, value, 1, number(&data[name], "F"));
        }
    }
    rows
}
