//! The tables of `docs/validation/short_bearing.md`.

use rayon::prelude::*;
use std::f64::consts::PI;

use crate::tables::{replace, row};
use oilwedge_tests::printed::{Row, rows};
use oilwedge_tests::short_crankshaft::finite::Film;
use oilwedge_tests::short_crankshaft::{
    Document, SLIPS, SPEED_SCALE, SPEEDS, SQUEEZES, Scales, film, film_at, right, right_pressure,
};

/// Longest edges [mm] of the meshes of the films of finite length.
const SIZE: f64 = 1.5;
/// Models of those films.
pub const MODELS: [&str; 2] = ["guembel", "reynolds"];
/// Digits of numbers in closed form and of the films in finite elements.
const DIGITS: [usize; 2] = [6, 4];

/// The films of finite length of all cases.
pub struct Study {
    films: Vec<[Film; 2]>,
}

impl Study {
    /// Solves them.
    pub fn solved() -> Self {
        let cases: Vec<[f64; 2]> =
            SQUEEZES.into_iter().flat_map(|squeeze| SPEEDS.map(|speed| [squeeze, speed])).collect();
        let films = cases.par_iter().map(|&case| MODELS.map(|model| Film::new(model, "full", case, SIZE)));
        Self { films: films.collect() }
    }

    /// The films of a case, by both models.
    ///
    /// # Panics
    /// If the document has no such case.
    pub fn of(&self, squeeze: f64, speed: f64) -> &[Film; 2] {
        let case = SQUEEZES.iter().position(|it| *it == squeeze).expect("E 0 or 0.4");
        let place = SPEEDS.iter().position(|it| *it == speed).expect("one of five speeds");
        &self.films[SPEEDS.len() * case + place]
    }
}

/// The page with its tables computed anew.
pub fn page(page: &str) -> String {
    page_of(page, &Study::solved())
}

/// The page with its tables computed from films that are solved.
pub fn page_of(page: &str, study: &Study) -> String {
    let mut page = replace(page, "scales", &scales());
    page = replace(&page, "table1", &around("table1", study));
    page = replace(&page, "table2", &around("table2", study));
    page = replace(&page, "table4", &along(study));
    for name in ["table3", "table6", "table7", "table8"] {
        page = replace(&page, name, &columns(name, study));
    }
    page
}

/// A number with so many digits, as a decimal where that is short. Rounding is zero.
fn told(value: f64, digits: usize) -> String {
    if value.abs() < 1e-12 {
        return "0".to_owned();
    }
    let decimals = digits - 1;
    let scientific = format!("{value:.decimals$e}");
    let exponent: i32 = scientific.rsplit('e').next().and_then(|text| text.parse().ok()).unwrap_or(0);
    match exponent {
        exponent if (-4..digits as i32).contains(&exponent) => {
            format!("{value:.0$}", (decimals as i32 - exponent).max(0) as usize)
        }
        _ => scientific,
    }
}

fn closed(value: f64) -> String {
    told(value, DIGITS[0])
}

fn meshed(value: f64) -> String {
    told(value, DIGITS[1])
}

const ANSWERS: [&str; 5] = ["printed", "recomputed", "right", "finite, Guembel", "finite, Reynolds"];

fn head(places: &[&str], more: &[&str]) -> Vec<String> {
    let all = places.iter().chain(&ANSWERS).chain(more);
    all.map(|&cell| cell.to_owned()).collect()
}

/// The scales of the document.
fn scales() -> Vec<Vec<String>> {
    let mut table = vec![row(["number", "printed", "recomputed", "right"])];
    let [right, own] = [Scales::right(), Scales::printed()];
    let named = [
        ("alpha", "half-width over radius", own.width, right.width),
        ("psi0", "relative clearance", own.clearance, right.clearance),
        ("omega0", "scale of speed [rad/s]", SPEED_SCALE, SPEED_SCALE),
        ("p*", "scale of pressure [Pa]", own.pressure, right.pressure),
    ];
    let printed = rows("source000/scalars.csv");
    for (name, what, own, right) in named {
        let text = printed.iter().find(|row| row.text("quantity") == name);
        let text = text.map_or("-", |row| row.text("printed")).to_owned();
        table.push(vec![what.to_owned(), text, closed(own), closed(right)]);
    }
    table
}

/// Tables 1 and 2: Pi(phi, 0).
fn around(name: &str, study: &Study) -> Vec<Vec<String>> {
    let mut table = vec![head(&["n", "phi [deg]"], &[])];
    for row in rows(&format!("source000/{name}.csv")) {
        let (own, film) = (Document::of(&row), film(&row));
        let phi = own.angle(row.number("row") as usize);
        let finite = study.of(row.number("E"), row.number("n"));
        let mut cells = vec![
            row.text("n").to_owned(),
            row.text("phi[deg]").to_owned(),
            row.text("Pi").to_owned(),
            closed(own.pressure(phi)),
            closed(right_pressure(&film, phi, 0.0)),
        ];
        cells.extend(finite.iter().map(|film| meshed(film.pressure(phi, 0.0))));
        table.push(cells);
    }
    table
}

/// Table 4: Pi(phi*, z), the right ones at their own phi*.
fn along(study: &Study) -> Vec<Vec<String>> {
    let mut table = vec![head(&["E", "n", "2 z/B"], &[])];
    for (k, row) in rows("source000/table4.csv").iter().enumerate() {
        let (own, film) = (Document::of(row), film(row));
        let zeta = (k % 9) as f64 / 8.0 - 1.0;
        let phi = film.loaded_from() + PI / 2.0;
        let finite = study.of(row.number("E"), row.number("n"));
        let mut cells = vec![
            row.text("E").to_owned(),
            row.text("n").to_owned(),
            format!("{zeta:.3}"),
            row.text("Pi").to_owned(),
            closed(own.pressure_along(zeta)),
            closed(right_pressure(&film, phi, zeta)),
        ];
        cells.extend(finite.iter().map(|film| meshed(film.pressure(phi, zeta))));
        table.push(cells);
    }
    table
}

/// Tables 3, 6, 7 and 8, a row for each cell.
fn columns(name: &str, study: &Study) -> Vec<Vec<String>> {
    let mut table = vec![head(&["quantity", "E", "n"], &["right / printed"])];
    let rows = rows(&format!("source000/{name}.csv"));
    let Some(first) = rows.first() else { return table };
    for column in first.columns().skip(2) {
        for row in rows.iter().filter(|row| !row.text(column).is_empty()) {
            table.push(cell(name, row, column, study));
        }
    }
    table
}

fn cell(name: &str, row: &Row, column: &str, study: &Study) -> Vec<String> {
    let (squeeze, speed) = (row.number("E"), row.number("n"));
    let is_slip = SLIPS.iter().any(|slip| (slip.0, slip.1, slip.2, slip.4) == (name, squeeze, speed, column));
    let found = right(&film_at(squeeze, speed), column);
    let mut cells = vec![
        column.replace("[-]", "").replace('[', " ["),
        row.text("E").to_owned(),
        row.text("n").to_owned(),
        format!("{}{}", row.text(column), if is_slip { " (slip)" } else { "" }),
        closed(Document::of(row).value(column)),
        closed(found),
    ];
    let finite = study.of(squeeze, speed).iter();
    cells.extend(finite.map(|film| film.value(column).map_or("-".to_owned(), meshed)));
    let printed = row.number(column);
    let parts = (printed != 0.0).then(|| format!("{:.3}", found / printed));
    cells.push(parts.unwrap_or("-".to_owned()));
    cells
}
