//! The keys of `[oil]` by which viscosity depends on temperature: `grade`, `walther`, `vogel`, `table`.

use oilwedge_reynolds::existence::readable;
use oilwedge_reynolds::lubricant::density::ZERO_CELSIUS;
use oilwedge_reynolds::lubricant::grades::GRADES;
use oilwedge_reynolds::lubricant::walther::LEAST_ON_CHART;
use oilwedge_reynolds::lubricant::{Density, Grade, TemperatureLaw, ViscosityTable, Vogel, Walther};

use crate::reader::TableReader;
use crate::spelling::nearest;
use crate::unit::Dimension;

/// A law of temperature as far as it could be read.
pub(super) struct Law {
    /// Whether there is one at all.
    pub(super) is_given: bool,
    /// It; none where it was complained about.
    pub(super) law: Option<TemperatureLaw>,
    /// The density given, else that of the grade.
    pub(super) density: Option<Density>,
}

/// The ways to write it.
const WAYS: [&str; 4] = ["grade", "walther", "vogel", "table"];

/// Reads the one that is written.
pub(super) fn read(table: &mut TableReader<'_>, density: Option<Density>) -> Law {
    let written: Vec<&str> = WAYS.into_iter().filter(|way| table.has(way)).collect();
    if let [first, second, ..] = written[..] {
        let message = format!("stands beside {first}, but viscosity follows one law of temperature");
        table.complain(second, message, "keep one of grade, walther, vogel and table");
    }
    let grade = table
        .text_if_given("grade", "SAE 10W-40")
        .and_then(|name| grade(table, &name));
    let of_grade = grade.and_then(Grade::oil);
    let mut law = of_grade.as_ref().map(|oil| oil.law.clone());
    let density = density.or_else(|| of_grade.map(|oil| oil.density));
    if let Some(walther) = table.table_if_given("walther") {
        law = walther_line(walther).map(TemperatureLaw::Walther);
    }
    if let Some(vogel) = table.table_if_given("vogel") {
        law = Some(TemperatureLaw::Vogel(vogel_law(vogel)));
    }
    if table.has("table") {
        law = points(table, density.unwrap_or_default()).map(TemperatureLaw::Table);
    }
    Law {
        is_given: !written.is_empty(),
        law,
        density,
    }
}

fn grade(table: &TableReader<'_>, name: &str) -> Option<Grade> {
    let found = Grade::named(name);
    if found.is_none() {
        let near = nearest(name, GRADES.iter().map(|grade| grade.name));
        let near = near.map_or(String::new(), |near| format!("did you mean \"{near}\"? "));
        let help = format!("{near}oilwedge oil lists all; or give walther = {{ nu40, nu100 }} of its data sheet");
        table.complain("grade", format!("\"{name}\" is no grade that is known"), help);
    }
    found
}

const LINE: &str =
    "write walther = { nu40 = \"95 mm2/s\", nu100 = \"14.3 mm2/s\" }, or t1, nu1, t2 and nu2 for other temperatures";

/// Two points: at 40 and 100 degrees C, or at temperatures given.
fn walther_line(mut table: TableReader<'_>) -> Option<Walther> {
    let usual = table.has("nu40") || table.has("nu100");
    let general = ["t1", "nu1", "t2", "nu2"].into_iter().any(|key| table.has(key));
    if usual && general {
        table.complain_here("mixes two ways to give two points", LINE);
    }
    let mut viscosity = |key: &'static str, example: &str, asked: bool| match asked {
        true => table.quantity(key, Dimension::KinematicViscosity, example),
        false => table
            .quantity_if_given(key, Dimension::KinematicViscosity, example)
            .unwrap_or(f64::NAN),
    };
    let at_40 = viscosity("nu40", "95 mm2/s", !general);
    let at_100 = viscosity("nu100", "14.3 mm2/s", !general);
    let (one, other) = (
        viscosity("nu1", "95 mm2/s", general),
        viscosity("nu2", "14.3 mm2/s", general),
    );
    let mut temperature = |key: &'static str, example: &str| match general {
        true => table.quantity(key, Dimension::Temperature, example),
        false => f64::NAN,
    };
    let points = match general {
        true => [(temperature("t1", "40 C"), one), (temperature("t2", "100 C"), other)],
        false => [(ZERO_CELSIUS + 40.0, at_40), (ZERO_CELSIUS + 100.0, at_100)],
    };
    if !general {
        table.quantity_if_given("t1", Dimension::Temperature, "40 C");
        table.quantity_if_given("t2", Dimension::Temperature, "100 C");
    }
    let line = Walther::through(points[0], points[1]);
    let is_read = points
        .iter()
        .all(|(temperature, viscosity)| temperature.is_finite() && viscosity.is_finite());
    if line.is_none() && is_read && !(usual && general) {
        table.complain_here(unfit(&points), LINE);
    }
    table.finish();
    line
}

/// Why points make no law.
fn unfit(points: &[(f64, f64)]) -> String {
    match points.iter().find(|(_, viscosity)| *viscosity <= LEAST_ON_CHART) {
        Some((_, viscosity)) => format!(
            "has a viscosity of {} mm2/s, but the chart begins above 0.3 mm2/s",
            readable(1e6 * viscosity)
        ),
        None => "needs two points or more, each hotter one with a lower viscosity".to_owned(),
    }
}

fn vogel_law(mut table: TableReader<'_>) -> Vogel {
    let factor = table.quantity("a", Dimension::Viscosity, "0.06 mPa.s");
    let exponent = table.quantity("b", Dimension::TemperatureDifference, "1000 K");
    let offset = table.quantity("c", Dimension::TemperatureDifference, "95 K");
    table.finish();
    Vogel {
        factor,
        exponent,
        singular: ZERO_CELSIUS - offset,
    }
}

/// Points with kinematic viscosities `nu`, or with dynamic ones `mu`, which the density makes kinematic.
fn points(table: &mut TableReader<'_>, density: Density) -> Option<ViscosityTable> {
    let is_list = table.is_list("table");
    let rows = table.tables("table");
    let points: Vec<(f64, f64)> = rows.into_iter().map(|row| point(row, density)).collect();
    let is_read = points
        .iter()
        .all(|(temperature, viscosity)| temperature.is_finite() && viscosity.is_finite());
    let found = ViscosityTable::through(&points);
    if found.is_none() && is_read && is_list {
        let help = "write table = [{ t = \"40 C\", nu = \"95 mm2/s\" }, { t = \"100 C\", nu = \"14.3 mm2/s\" }], or mu = \"80 mPa.s\" in place of nu";
        table.complain("table", unfit(&points), help);
    }
    found.filter(|_| is_read)
}

fn point(mut row: TableReader<'_>, density: Density) -> (f64, f64) {
    let temperature = row.quantity("t", Dimension::Temperature, "40 C");
    let dynamic = row.quantity_if_given("mu", Dimension::Viscosity, "80 mPa.s");
    let viscosity = match dynamic {
        Some(dynamic) => {
            if row.has("nu") {
                row.complain(
                    "nu",
                    "stands beside mu, but one of them gives the other",
                    "keep one of mu and nu",
                );
                row.quantity_if_given("nu", Dimension::KinematicViscosity, "95 mm2/s");
            }
            dynamic / density.at(temperature)
        }
        None => row.quantity("nu", Dimension::KinematicViscosity, "95 mm2/s"),
    };
    row.finish();
    (temperature, viscosity)
}

#[cfg(test)]
mod tests {
    use crate::schema::tests::{STUDY, read, told};

    const OIL: &str = "oil = { viscosity = \"0.4 Pa.s\", barus = { alpha = \"2.5e-8 1/Pa\" } }";

    fn with_oil(oil: &str) -> String {
        assert!(STUDY.contains(OIL));
        STUDY.replacen(OIL, &format!("oil = {{ {oil} }}"), 1)
    }

    #[test]
    fn every_law_is_read() {
        for (oil, temperature, viscosity) in [
            ("grade = \"SAE 10W-40\"", "40 C", 95e-6 * 855.09),
            ("grade = \"sae10w40\", density = \"900 kg/m3\"", "40 C", 95e-6 * 887.6),
            (
                "walther = { nu40 = \"55 mm2/s\", nu100 = \"8.19 cSt\" }, density = \"885 kg/m3\"",
                "100 C",
                8.19e-6 * 836.3,
            ),
            (
                "walther = { t1 = \"313.15 K\", nu1 = \"55 mm2/s\", t2 = \"100 C\", nu2 = \"8.19 mm2/s\" }",
                "373.15 K",
                8.19e-6 * 822.1,
            ),
            (
                "vogel = { a = \"0.05 mPa.s\", b = \"1000 K\", c = \"95 K\" }",
                "80 C",
                5e-5 * (1000.0f64 / 175.0).exp(),
            ),
            (
                "table = [{ t = \"40 C\", mu = \"80 mPa.s\" }, { t = \"100 C\", mu = \"12 mPa.s\" }]",
                "100 C",
                0.012,
            ),
            (
                "density = { value = \"868 kg/m3\", at = \"15 C\", expansion = \"70e-5 1/K\" }, table = [{ t = \"40 C\", nu = \"95 mm2/s\" }, { t = \"100 C\", nu = \"14 mm2/s\" }]",
                "40 C",
                95e-6 * 868.0 * (1.0 - 70e-5 * 20.0) / (1.0 + 70e-5 * 5.0),
            ),
        ] {
            let scene = read(&with_oil(&format!("{oil}, temperature = \"{temperature}\""))).expect(oil);
            let found = scene.oil.viscosity;
            assert!(
                (found / viscosity - 1.0).abs() < 1e-4,
                "{oil}: {found} is not {viscosity}"
            );
            assert!(scene.oil.thermal.is_some() && scene.oil.temperature.is_some());
        }
    }

    #[test]
    fn what_is_wrong_with_a_law_is_told_once() {
        let at = ", temperature = \"80 C\"";
        for (oil, wanted, help) in [
            ("", "oil.viscosity: is missing", "grade = \"SAE 10W-40\""),
            ("grade = \"SAE 10W-40\"", "oil.temperature: is missing", "\"80 C\""),
            (
                &format!("grade = \"SAE 10W-41\"{at}"),
                "oil.grade: \"SAE 10W-41\" is no grade",
                "did you mean \"SAE 10W-40\"",
            ),
            (
                &format!("grade = \"oil\"{at}"),
                "oil.grade: \"oil\" is no grade",
                "oilwedge oil lists all",
            ),
            (
                &format!("viscosity = \"9 mPa.s\", grade = \"VG 46\"{at}"),
                "oil.viscosity: stands beside a law",
                "keep one of",
            ),
            (
                &format!("grade = \"VG 46\", vogel = {{ a = \"0.05 mPa.s\", b = \"900 K\", c = \"95 K\" }}{at}"),
                "oil.vogel: stands beside grade",
                "keep one of",
            ),
            (
                &format!("viscosity = \"9 mPa.s\"{at}"),
                "oil.temperature: has a meaning only",
                "remove it",
            ),
            (
                &format!("walther = {{ nu40 = \"55 mm2/s\" }}{at}"),
                "oil.walther.nu100: is missing",
                "nu100 = ",
            ),
            (
                &format!("walther = {{ nu40 = \"8 mm2/s\", nu100 = \"55 mm2/s\" }}{at}"),
                "oil.walther: needs two points or more, each hotter one",
                "nu40 = \"95 mm2/s\"",
            ),
            (
                &format!("walther = {{ nu40 = \"8 mm2/s\", nu100 = \"0.3 mm2/s\" }}{at}"),
                "oil.walther: has a viscosity of 0.3 mm2/s",
                "nu100",
            ),
            (
                &format!(
                    "walther = {{ nu40 = \"55 mm2/s\", nu100 = \"8 mm2/s\", t1 = \"40 C\", nu1 = \"55 mm2/s\", t2 = \"90 C\", nu2 = \"9 mm2/s\" }}{at}"
                ),
                "oil.walther: mixes two ways",
                "t1",
            ),
            (
                &format!("walther = {{ nu40 = \"55 mPa.s\", nu100 = \"8 mm2/s\" }}{at}"),
                "oil.walther.nu40: \"mPa.s\" is a unit of dynamic viscosity, but a kinematic viscosity is wanted",
                "mm2/s",
            ),
            (
                &format!("vogel = {{ a = \"0.05 mPa.s\", b = \"900 C\", c = \"95 K\" }}{at}"),
                "oil.vogel.b: \"C\" is a unit of temperature, but a temperature difference is wanted",
                "K",
            ),
            (
                &format!("table = [{{ t = \"40 C\", nu = \"95 mm2/s\" }}]{at}"),
                "oil.table: needs two points",
                "table = [",
            ),
            (
                &format!(
                    "table = [{{ t = \"40 C\", nu = \"95 mm2/s\", mu = \"80 mPa.s\" }}, {{ t = \"90 C\", nu = \"15 mm2/s\" }}]{at}"
                ),
                "oil.table[0].nu: stands beside mu",
                "keep one",
            ),
            (&format!("table = []{at}"), "oil.table: needs two points", "table = ["),
            (
                &format!("table = [{{ nu = \"95 mm2/s\" }}]{at}"),
                "oil.table[0].t: is missing",
                "40 C",
            ),
            (
                "grade = \"VG 46\", temperature = 80",
                "oil.temperature: a bare number has no unit",
                "\"80 C\"",
            ),
            (
                "viscosity = \"9 mPa.s\", density = \"0.9\"",
                "oil.density: \"0.9\" has no unit",
                "kg/m3",
            ),
            (
                &format!("grade = \"VG 46\", density = {{ at = \"15 C\" }}{at}"),
                "oil.density.value: is missing",
                "kg/m3",
            ),
        ] {
            let told = told(OIL, &format!("oil = {{ {oil} }}"));
            assert!(told.len() == 1, "{oil}: {told:?}");
            assert!(told[0].to_string().starts_with(wanted), "{oil}: {told:?}");
            assert!(told[0].help.contains(help), "{oil}: {told:?}");
        }
    }
}
