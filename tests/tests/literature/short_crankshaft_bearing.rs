//! "Qualitative analysis of the bearings of an engine's crankshaft", task 1, South Ural State University, 2023 (in
//! Russian): a short bearing with half film, at rest (E = 0) and squeezed (E = 0.4), at five speeds.
//!
//! D = 74.5 mm, B = 25.7 mm, **diametral** clearance 0.092 mm, eps = 0.8, mu = 6.1 mPa s; phi from the narrowest film.
//! The document takes the diameter for the radius and the diametral clearance for the radial one, so its `a` and its
//! `p*` are each four times too small, and its spreadsheet has a wrong sign in `A2_00` and a lost square in `A3_00`.
//! [`Document`] is that arithmetic, slips and all: every printed number is asked to half a unit of its last digit, but
//! for the eight cells of [`SLIPS`], whose own right value is asked instead. The right values (`correct.csv`, from
//! quadrature of the pressure) are asked of the closed form to half a unit of their eighth digit, and to 1e-6.

use std::f64::consts::PI;

use oilwedge_tests::journal_bearings::each;
use oilwedge_tests::printed::{Row, rows};
use oilwedge_tests::short_crankshaft::finite::Film;
use oilwedge_tests::short_crankshaft::{DIAMETER, LENGTH};
use oilwedge_tests::short_crankshaft::{Document, RELATIVE_VISCOSITY, SLIPS, SPEED_SCALE, Scales, film, right, summit};

/// Compares a printed cell; a slip is compared with its own value, and must be one.
fn check(table: &str, row: &Row, k: usize, column: &str, value: f64) {
    let (e, n) = (row.number("E"), row.number("n"));
    let slip = SLIPS.iter().find(|slip| (slip.0, slip.1, slip.2, slip.3, slip.4) == (table, e, n, k, column));
    let Some(&(.., own)) = slip else {
        return row.assert_prints(column, value);
    };
    let digit = if own == 0.1 { 1e-12 } else { 0.5e-4 };
    let digit = if column == "phi[rad]" { 0.5e-6 } else { digit };
    assert!((value - own).abs() <= digit, "{table}, {column} of E = {e}, n = {n}: {value}, own {own}");
    assert!(!row.prints(column, value), "{table}, {column} of E = {e}, n = {n} is no slip");
}

#[test]
fn pressures_around_the_film() {
    for (table, squeezed) in [("table1", false), ("table2", true)] {
        let rows = rows(&format!("source000/{table}.csv"));
        assert_eq!(rows.len(), 5 * 19);
        for row in &rows {
            let (document, k) = (Document::of(row), row.number("row") as usize);
            let phi = document.angle(k);
            assert_eq!(row.number("E") > 0.0, squeezed);
            check(table, row, k, "phi[deg]", phi.to_degrees());
            check(table, row, k, "phi[rad]", phi);
            if k == 0 || k == 18 {
                assert!(row.number("Pi").abs() < 1e-12 && document.pressure(phi).abs() < 1e-12);
            } else {
                check(table, row, k, "Pi[-]", document.pressure(phi));
            }
        }
    }
}

/// `phi*` of the columns with E = 0.4 is printed as that of their own speed, but the numbers are those of the first
/// column's.
#[test]
fn pressures_along_the_axis() {
    let rows = rows("source000/table4.csv");
    assert_eq!(rows.len(), 10 * 9);
    for (k, row) in rows.iter().enumerate() {
        let document = Document::of(row);
        let middle = document.film.loaded_from() + PI / 2.0;
        row.assert_prints("phi_star[deg]", middle.to_degrees());
        row.assert_prints("phi_star[rad]", middle);
        let zeta = (k % 9) as f64 / 8.0 - 1.0;
        row.assert_prints("z[-]", zeta * document.scales.width);
        let first = Document::of(&rows[if row.number("E") > 0.0 { 5 * 9 } else { 0 }]);
        let used = first.film.loaded_from() + PI / 2.0;
        let pressure = |phi: f64| document.scales.factor() * document.film.pressure(phi, zeta);
        row.assert_prints("Pi[-]", pressure(used));
        assert!((pressure(used) - document.pressure_along(zeta)).abs() < 1e-15);
        if row.number("E") > 0.0 && row.number("n") > 1100.0 && zeta > -1.0 {
            assert!(!row.prints("Pi[-]", pressure(middle)), "its own phi* would do");
        }
    }
    // With its own phi* the middle of the axis is the tenth point of table 2.
    let around = self::rows("source000/table2.csv");
    for row in around.iter().filter(|row| row.number("row") == 9.0) {
        let document = Document::of(row);
        row.assert_prints("Pi[-]", document.pressure(document.film.loaded_from() + PI / 2.0));
    }
}

#[test]
fn greatest_pressures_loads_flows_and_powers() {
    let mut cells = 0;
    for table in ["table3", "table6", "table7", "table8"] {
        let rows = rows(&format!("source000/{table}.csv"));
        assert_eq!(rows.len(), 10);
        for row in &rows {
            let document = Document::of(row);
            for column in row.columns().skip(2).filter(|column| !row.text(column).is_empty()) {
                check(table, row, 0, column, document.value(column));
                cells += 1;
            }
        }
    }
    assert_eq!(cells, 30 + 56 + 70 + 70);
}

/// Numbers within the text; those that are marked as cut off, not rounded, are compared with their uncut value.
#[test]
fn numbers_within_the_text() {
    let scales = Scales::printed();
    let (steady, squeezed) = ([("E", "0"), ("n", "1100")], [("E", "0.4"), ("n", "1100")]);
    let [steady, squeezed] = [steady, squeezed].map(|cells| Document::of(&Row::new(&cells)));
    let speed = PI * 1100.0 / 30.0;
    let named = [
        ("alpha", scales.width),
        ("omega(1)", speed),
        ("psi0", scales.clearance),
        ("omega0", SPEED_SCALE),
        ("omega1(1)", speed / SPEED_SCALE),
        ("mu1", RELATIVE_VISCOSITY),
        ("E", squeezed.film.closing),
        ("p*", scales.pressure),
        ("phi_H(1), E=0.4", squeezed.film.loaded_from().to_degrees()),
        ("phi_K(1), E=0.4", squeezed.film.loaded_from().to_degrees() + 180.0),
        ("S1, E=0 n=1100", steady.value("S1[-]")),
        ("P_mean, E=0 n=1100", steady.value("P_mean[Pa]")),
    ];
    let rows = rows("source000/scalars.csv");
    assert_eq!(rows.len(), named.len());
    for (row, (name, value)) in rows.iter().zip(named) {
        assert_eq!(row.text("quantity"), name);
        row.assert_prints("recomputed", value);
        row.assert_cuts_or_prints("printed", value);
    }
}

#[test]
fn the_closed_form_has_the_right_values() {
    let mut cells = 0;
    for row in rows("source000/correct.csv") {
        let film = film(&row);
        for column in row.columns().skip(2) {
            let (value, expected) = (right(&film, column), row.number(column));
            assert!((value - expected).abs() <= 1e-6 * expected.abs(), "{column}: {value}, {expected}");
            assert!((value - expected).abs() <= 6e-8 * expected.abs(), "{column}: {value}, {expected}");
            cells += 1;
        }
    }
    assert_eq!(cells, 10 * 23);
}

/// Finite elements by the theory of short bearings, at 1e-3: the half film is cut at lines that the mesh does not know.
/// At the least speed and at the greatest, at rest and squeezed.
#[test]
fn finite_elements_of_a_short_film_have_them_too() {
    let mut rows = rows("source000/correct.csv");
    rows.retain(|row| [1100.0, 3200.0].contains(&row.number("n")));
    assert_eq!(rows.len(), 4);
    each(&rows, |row| {
        let film = Film::new("reynolds", "short", [row.number("E"), row.number("n")], 1.0);
        let columns = [
            ("W", "W[-]"),
            ("V", "V[-]"),
            ("So", "So[-]"),
            ("maxPi", "maxPi[-]"),
            ("theta_deg", "theta[deg]"),
            ("kP", "kP[-]"),
            ("q_total", "q[-]"),
            ("kN", "kN[-]"),
            ("N_W", "N[W]"),
            ("R_N", "R[N]"),
        ];
        for (right, column) in columns {
            let (value, right) = (film.value(column).expect(column), row.number(right));
            if (value / right - 1.0).abs() > 1e-3 {
                return Err(format!("{column}: {value}, right {right}: {row:?}"));
            }
        }
        Ok(())
    });
}

/// What the document would have printed with its own scales and right integrals.
#[test]
fn the_documents_scales_with_exact_integrals() {
    let factor = Scales::printed().factor();
    let area = Scales::printed().pressure * LENGTH * DIAMETER;
    let rows = rows("source000/exact_integrals.csv");
    assert_eq!(rows.len(), 5);
    for row in &rows {
        let film = film(row);
        let (a, load) = (film.half_integrals(), film.half_film());
        let so = factor * load.magnitude();
        let values = [
            ("A2_00", a.a2_00),
            ("A3_00", a.a3_00),
            ("A3_02", a.a3_02),
            ("A3_20", a.a3_20),
            ("V", factor * load.across),
            ("W", factor * load.along),
            ("So", so),
            ("theta[deg]", load.attitude().to_degrees()),
            ("R[N]", area * so),
            ("maxPi", factor * film.pressure(summit(&film), 0.0)),
            ("phi_max[deg]", summit(&film).to_degrees()),
        ];
        assert_eq!(row.columns().count(), values.len() + 2);
        for (column, value) in values {
            row.assert_prints(column, value);
        }
    }
}
