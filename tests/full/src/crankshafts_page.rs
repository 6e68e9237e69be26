//! The page `docs/validation/crankshafts.md`: shafts at rest against a second code and limits in closed form, and
//! engines over a cycle.

use oilwedge_scene::ShaftScene;
use oilwedge_study::quantities::{
    CYCLE_FILM_THICKNESS_MIN, CYCLE_LOAD_MAX, CYCLE_PRESSURE_MAX, FILM_THICKNESS_MIN, LOAD_X, LOAD_Y, TILT_X, TILT_Y,
};
use oilwedge_study::shaft::{CounterweightReport, ShaftRun, best_counterweights};

use crate::tables::{head, replace, row};
use oilwedge_tests::crankshafts::*;

type Table = Vec<Vec<String>>;

/// Differences of numbers below this part of them are rounding.
const ROUNDING: f64 = 1e-11;

/// The page with its tables computed anew.
pub fn page(page: &str) -> String {
    over_cycles(&at_rest(page))
}

/// The page with those of its tables anew that take seconds.
pub fn at_rest(page: &str) -> String {
    let page = replace(page, "three films", &three_films());
    let page = replace(&page, "limits", &limits());
    replace(&page, "closed", &closed())
}

/// The page with those of its tables anew that take minutes.
fn over_cycles(page: &str) -> String {
    let engine = text("three_throws.toml");
    let (whole, cut) = (run(&engine), run(&three_throws_cut(&engine)));
    let page = replace(page, "balances", &balances(&whole));
    let page = replace(&page, "single", &single(&cut));
    let page = replace(&page, "beside", &beside(&whole, &cut));
    let scene = ShaftScene::read(&engines("in_line_four.toml")).unwrap_or_else(|error| panic!("{error}"));
    let (_, report) = best_counterweights(&scene).unwrap_or_else(|error| panic!("{error}"));
    let page = replace(&page, "weights", &weights(&report));
    replace(&page, "kept", &kept(&report))
}

/// A difference over what it is a part of, in percent.
fn percent(difference: f64, whole: f64) -> String {
    // Without the sign of a difference that is rounded to nothing.
    format!("{:.3}", 100.0 * difference / whole + 0.0).replace("-0.000", "0.000")
}

fn three_films() -> Table {
    let mut rows = vec![head(
        "shaft | bearing | W_x, W_y [N], reference | found | off [% of W] | g_x, g_y [c/R], reference | \
         found | off [% of the greatest] | least film [um], reference | found | off [%]",
    )];
    for case in THREE_FILMS {
        let run = case.solved();
        let columns = [&LOAD_X, &LOAD_Y, &TILT_X, &TILT_Y, &FILM_THICKNESS_MIN].map(|row| numbers(run, row));
        for (number, (report, wanted)) in run.result.bearings.iter().zip(case.bearings).enumerate() {
            let [force_x, force_y, tilt_x, tilt_y, film] = [0, 1, 2, 3, 4].map(|k: usize| columns[k][number]);
            let [tilt_x, tilt_y] = [tilt_x, tilt_y].map(|tilt| tilt / (CLEARANCE / RADIUS));
            let film = 1e6 * film;
            let off = |found: [f64; 2], from: usize| (found[0] - wanted[from]).hypot(found[1] - wanted[from + 1]);
            rows.push(vec![
                case.name.to_owned(),
                report.name.clone(),
                pair([wanted[0], wanted[1]], 1),
                pair([force_x, force_y], 1),
                percent(off([force_x, force_y], 0), wanted[0].hypot(wanted[1])),
                pair([wanted[2], wanted[3]], 4),
                pair([tilt_x, tilt_y], 4),
                percent(off([tilt_x, tilt_y], 2), case.greatest_tilt()),
                format!("{:.4}", wanted[4]),
                format!("{film:.4}"),
                percent(film - wanted[4], wanted[4]),
            ]);
        }
    }
    rows
}

/// Distance of a ratio from one; that of rounding has no digits, for it depends on the order of sums.
fn off(ratio: f64) -> String {
    let off = (ratio - 1.0).abs();
    if off < ROUNDING { "rounding".to_owned() } else { format!("{off:.1e}") }
}

fn pair(values: [f64; 2], digits: usize) -> String {
    let [x, y] = values.map(|value| {
        let text = format!("{value:.digits$}");
        let is_zero = text.trim_start_matches('-').chars().all(|it| it == '0' || it == '.');
        if is_zero { "0".to_owned() } else { text }
    });
    format!("{x}, {y}")
}

fn limits() -> Table {
    let mut rows = vec![row(["shaft", "bearing", "W_y [N], wanted", "found", "off [1]"])];
    let mut add = |name: &str, run: &ShaftRun, wanted: &[f64]| {
        for ((report, found), wanted) in run.result.bearings.iter().zip(numbers(run, &LOAD_Y)).zip(wanted) {
            rows.push(vec![
                name.to_owned(),
                report.name.clone(),
                format!("{wanted:.4}"),
                format!("{found:.4}"),
                off(found / wanted),
            ]);
        }
    };
    add("knife edges", on_thin_films(), &KNIFE_EDGES.map(|part| -12e3 * part));
    for ((name, _), run) in BY_STATICS.iter().zip(by_statics()) {
        add(&format!("two films, {name}"), run, &[RIGHT - 13.0, -RIGHT].map(|kilo| 1e3 * kilo));
    }
    rows
}

fn balances(whole: &ShaftRun) -> Table {
    let of = whole.result.balances;
    let energy = (whole.result.bearings.iter()).filter_map(|bearing| bearing.energy).fold(0.0, f64::max);
    let mut rows = vec![row(["balance", "left, greatest over the cycle", "over"])];
    for (name, left, over) in [
        ("force: loads less films", of.force, "the loads"),
        ("moment about z = 0", of.moment, "the moments of the loads"),
        ("equations of the journals", of.journals, "the loads"),
        ("power, at each step", of.power.unwrap_or(f64::NAN), "the greatest dissipation"),
        ("energy of a bearing over the cycle", energy, "its dissipation over the cycle"),
    ] {
        rows.push(row([name, &format!("{left:.1e}"), over]));
    }
    rows
}

fn single(cut: &ShaftRun) -> Table {
    let mut rows = vec![row(["bearing", "least film [um], single bearing", "of the cut shaft", "off [1]"])];
    let films = numbers(cut, &CYCLE_FILM_THICKNESS_MIN);
    for (number, throws) in BESIDE.iter().enumerate() {
        let (alone, film) =
            (single_main(&text("three_throws.toml"), throws, &text("bearings/main_85.toml")), films[number]);
        rows.push(vec![
            cut.result.bearings[number].name.clone(),
            format!("{:.6}", 1e6 * alone),
            format!("{:.6}", 1e6 * film),
            format!("{:.1e}", (film / alone - 1.0).abs()),
        ]);
    }
    rows
}

fn beside(whole: &ShaftRun, cut: &ShaftRun) -> Table {
    let mut rows = vec![head(
        "bearing | greatest load [kN], whole | cut | change [%] | least film [um], whole | cut | \
         change [%] | greatest pressure [bar], whole | cut | change [%] | greatest tilt [mrad], whole",
    )];
    let columns = [(&CYCLE_LOAD_MAX, 1e-3, 3), (&CYCLE_FILM_THICKNESS_MIN, 1e6, 3), (&CYCLE_PRESSURE_MAX, 1e-5, 1)]
        .map(|(row, factor, digits)| (numbers(whole, row), numbers(cut, row), factor, digits));
    for (number, bearing) in whole.result.bearings.iter().enumerate() {
        let mut cells = vec![bearing.name.clone()];
        for (of_whole, of_cut, factor, digits) in &columns {
            let values = [of_whole[number], of_cut[number]];
            cells.extend(values.map(|value| format!("{:.*}", *digits, factor * value)));
            cells.push(format!("{:.1}", 100.0 * (values[1] / values[0] - 1.0)));
        }
        cells.push(format!("{:.4}", 1e3 * bearing.tilt_max));
        rows.push(cells);
    }
    rows
}

fn closed() -> Table {
    let best = CLOSED_THROW.found();
    let mut rows = vec![row(["number", "closed form", "found", "off [1]"])];
    for (name, wanted, found) in [
        ("counterweight [kg m]", CLOSED_THROW.best(), -best.at[0]),
        ("greatest load [N]", CLOSED_THROW.least_peak(), -best.value),
    ] {
        rows.push(vec![name.to_owned(), format!("{wanted:.6}"), format!("{found:.6}"), off(found / wanted)]);
    }
    rows
}

fn weights(report: &CounterweightReport) -> Table {
    let mut rows =
        vec![row(["throw", "web", "mass times radius [g m], before", "after", "angle [deg], before", "after"])];
    for web in &report.webs {
        let [before, after] = web.moment.map(|moment| format!("{:.2}", 1e3 * moment));
        let [was, is] = web.angle_deg.map(|angle| format!("{angle:.1}"));
        rows.push(vec![web.throw.to_string(), web.web.to_string(), before, after, was, is]);
    }
    rows
}

fn kept(report: &CounterweightReport) -> Table {
    let mut rows = vec![row(["number", "value"])];
    let [before, after] = report.film_by_maps.map(|film| format!("{:.4}", 1e6 * film));
    for (name, value) in [
        ("change of the force of the whole shaft, over all counterweights [1]", format!("{:.1e}", report.force_change)),
        (
            "change of its moment, over all counterweights times the length of the shaft [1]",
            format!("{:.1e}", report.moment_change),
        ),
        ("least film by maps, cut shaft, before [um]", before),
        ("after [um]", after),
        ("shafts asked for", report.asked.to_string()),
    ] {
        rows.push(row([name, &value]));
    }
    rows
}
