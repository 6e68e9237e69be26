//! `grade`, `walther`, `vogel` and `table` of `[oil]`: how the viscosity falls with temperature.

use crate::reader::{Number, TableReader};
use crate::unit::ZERO_CELSIUS;
use crate::wording::celsius;

keys! {
    "oil.grade" = Text; "SAE 10W-40", "no grade", "a name that `oilwedge oil` lists",
        "a typical oil of that class, as `\"SAE 10W-40\"` or `\"ISO VG 46\"`: viscosity and density";
    "oil.walther" = Table; "", "no such law", "",
        "kinematic viscosity by lg lg(nu + 0.7) = A - B lg T through two points";
    "oil.walther.nu40" = Quantity(KinematicViscosity); "95 mm2/s", "required unless two other points", "> 0.3 mm2/s",
        "kinematic viscosity at 40 degrees C, as data sheets give it";
    "oil.walther.nu100" = Quantity(KinematicViscosity); "14.3 mm2/s", "required unless two other points", "> 0.3 mm2/s, at most `nu40`",
        "kinematic viscosity at 100 degrees C, as data sheets give it";
    "oil.walther.t1" = Quantity(Temperature); "40 C", "`nu40` and `nu100` are the points", "-60 to 350 C",
        "instead: the temperature of the first of two other points";
    "oil.walther.nu1" = Quantity(KinematicViscosity); "95 mm2/s", "required with `t1`", "> 0.3 mm2/s",
        "kinematic viscosity at `t1`";
    "oil.walther.t2" = Quantity(Temperature); "100 C", "required with `t1`", "-60 to 350 C",
        "temperature of the second point";
    "oil.walther.nu2" = Quantity(KinematicViscosity); "14.3 mm2/s", "required with `t1`", "> 0.3 mm2/s",
        "kinematic viscosity at `t2`";
    "oil.vogel" = Table; "", "no such law", "",
        "Vogel's law mu = a exp(b/(t + c)), t in degrees C";
    "oil.vogel.a" = Quantity(Viscosity); "0.06 mPa.s", "required", "> 0",
        "a of mu = a exp(b/(t + c)), t in degrees C";
    "oil.vogel.b" = Quantity(TemperatureDifference); "1000 K", "required", ">= 0",
        "b of mu = a exp(b/(t + c))";
    "oil.vogel.c" = Quantity(TemperatureDifference); "95 K", "required", "t + c > 0",
        "c of mu = a exp(b/(t + c))";
    "oil.exponential" = Table; "", "no such law", "",
        "Reynolds' exponential law mu = mu_1 exp(-beta (t - t_1)), that of most published thermal films";
    "oil.exponential.viscosity" = Quantity(Viscosity); "27.7 mPa.s", "required", "> 0",
        "viscosity mu_1 at the temperature `at`";
    "oil.exponential.at" = Quantity(Temperature); "40 C", "required", "-60 to 350 C",
        "temperature t_1";
    "oil.exponential.beta" = Quantity(InverseTemperature); "0.034 1/K", "required", "0 to 0.2 1/K",
        "relative fall of the viscosity beta";
    "oil.table" = Tables; "", "no such law", "two points or more, falling",
        "measured viscosities, kinematic or dynamic; between two points straight on the chart of ASTM D341";
    "oil.table.t" = Quantity(Temperature); "40 C", "required", "-60 to 350 C",
        "temperature of a point";
    "oil.table.nu" = Quantity(KinematicViscosity); "95 mm2/s", "required unless `mu`", "> 0.3 mm2/s",
        "kinematic viscosity at `t`";
    "oil.table.mu" = Quantity(Viscosity); "80 mPa.s", "`nu` gives the viscosity", "> 0",
        "instead of `nu`: dynamic viscosity at `t`";
}

/// The keys that give a law of temperature.
const WAYS: [&str; 5] = ["grade", "walther", "vogel", "exponential", "table"];

/// How the viscosity falls with temperature.
#[derive(Debug, Clone, PartialEq)]
pub enum TemperatureLawTable {
    /// The law of a typical oil of this grade, as `SAE 10W-40`.
    Grade(String),
    /// A line through two points `(T [K], nu [m2/s])` on the chart of ASTM D341.
    Walther([(f64, f64); 2]),
    /// Vogel's law: mu = a exp(b/(t + c)), t in degrees Celsius.
    Vogel {
        /// Viscosity a at infinite temperature [Pa.s].
        a: f64,
        /// Constant b [K].
        b: f64,
        /// Constant c [K].
        c: f64,
    },
    /// Reynolds' law: mu = mu_1 exp(-beta (t - t_1)).
    Exponential {
        /// Viscosity mu_1 [Pa.s].
        viscosity: f64,
        /// Temperature t_1 [K].
        at: f64,
        /// Relative fall beta [1/K].
        beta: f64,
    },
    /// Lines between points on the chart of ASTM D341.
    Table(Vec<ViscosityPoint>),
}

/// One point of a table.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ViscosityPoint {
    /// Temperature [K].
    pub temperature: f64,
    /// Viscosity there.
    pub viscosity: PointViscosity,
}

/// The viscosity of a point.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum PointViscosity {
    /// Kinematic viscosity nu [m2/s].
    Kinematic(f64),
    /// Dynamic viscosity mu [Pa.s].
    Dynamic(f64),
}

impl<'a> TableReader<'a> {
    /// A temperature [K] at which oil is a liquid.
    pub(crate) fn oil_temperature(&mut self, key: &'a str) -> Number<'_, 'a> {
        self.number(key).within_or(
            |temperature, [least, most]| {
                let [temperature, least, most] = [temperature, least, most].map(celsius);
                format!("is {temperature}, but oil films are liquid between {least} and {most}")
            },
            "give for example \"80 C\"; a value in K counts from the absolute zero",
        )
    }
}

/// Reads the law that is written, if there is one.
pub(super) fn read(oil: &mut TableReader<'_>) -> Option<TemperatureLawTable> {
    let written: Vec<&str> = WAYS.into_iter().filter(|way| oil.has(way)).collect();
    if let [first, second, ..] = written[..] {
        let message = format!("stands beside {first}, but viscosity follows one law of temperature");
        oil.complain(second, message, "keep one of grade, walther, vogel, exponential and table");
    }
    let grade = oil.text_if_given("grade").map(TemperatureLawTable::Grade);
    let walther = oil.table_if_given("walther").map(walther);
    let vogel = oil.table_if_given("vogel").map(vogel);
    let exponential = oil.table_if_given("exponential").map(exponential);
    let points = oil.tables("table").into_iter().map(point).collect();
    match written.first() {
        None => None,
        Some(&"table") => Some(TemperatureLawTable::Table(points)),
        // A grade that was refused is none that is known.
        Some(_) => grade.or(walther).or(vogel).or(exponential).or(Some(TemperatureLawTable::Grade(String::new()))),
    }
}

/// Two points: at 40 and 100 degrees C, or at temperatures given.
fn walther(mut table: TableReader<'_>) -> TemperatureLawTable {
    let is_usual = table.has("nu40") || table.has("nu100");
    let is_general = ["t1", "nu1", "t2", "nu2"].into_iter().any(|key| table.has(key));
    if is_usual && is_general {
        let help = "write nu40 and nu100, or t1, nu1, t2 and nu2 for other temperatures";
        table.complain_here("mixes two ways to give two points", help);
    }
    let mut number = |is_wanted: bool, key| {
        let number = table.number(key);
        if is_wanted { number.required() } else { number.or(f64::NAN) }
    };
    let [nu_40, nu_100] = ["nu40", "nu100"].map(|key| number(!is_general, key));
    let [nu_1, nu_2, t_1, t_2] = ["nu1", "nu2", "t1", "t2"].map(|key| number(is_general, key));
    TemperatureLawTable::Walther(match is_general {
        true => [(t_1, nu_1), (t_2, nu_2)],
        false => [(ZERO_CELSIUS + 40.0, nu_40), (ZERO_CELSIUS + 100.0, nu_100)],
    })
}

fn vogel(mut table: TableReader<'_>) -> TemperatureLawTable {
    let help = "give a constant that is not negative, some 600 to 1500 K for mineral oil";
    let b = table.number("b");
    let b = b.within("is negative", help).required();
    TemperatureLawTable::Vogel { a: table.required("a"), b, c: table.required("c") }
}

fn exponential(mut table: TableReader<'_>) -> TemperatureLawTable {
    let help = "give the relative fall of the viscosity, some 0.02 to 0.05 1/K";
    TemperatureLawTable::Exponential {
        viscosity: table.required("viscosity"),
        at: table.oil_temperature("at").required(),
        beta: table.number("beta").within("is not a relative fall of viscosity", help).required(),
    }
}

/// A point with a kinematic viscosity `nu`, or with a dynamic one `mu`.
fn point(mut row: TableReader<'_>) -> ViscosityPoint {
    let temperature = row.required("t");
    let dynamic = row.given("mu");
    let kinematic = row.given("nu");
    row.refuse_if(
        dynamic.is_some() && kinematic.is_some(),
        "nu",
        "stands beside mu, but one of them gives the other",
        "keep one of mu and nu",
    );
    if dynamic.is_none() {
        row.require("nu");
    }
    ViscosityPoint {
        temperature,
        viscosity: match dynamic {
            Some(dynamic) => PointViscosity::Dynamic(dynamic),
            None => PointViscosity::Kinematic(kinematic.unwrap_or(f64::NAN)),
        },
    }
}

#[cfg(test)]
mod tests {
    use crate::scene::tests::told;

    const OIL: &str = "oil = { viscosity = \"0.4 Pa.s\", barus = { alpha = \"2.5e-8 1/Pa\" } }";

    #[test]
    fn what_is_wrong_with_a_law_is_told_once() {
        let at = ", temperature = \"80 C\"";
        for (oil, wanted, help) in [
            ("", "oil.viscosity: is missing", "grade = \"SAE 10W-40\""),
            ("grade = \"SAE 10W-40\"", "oil.temperature: is missing", "\"80 C\""),
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
            (&format!("viscosity = \"9 mPa.s\"{at}"), "oil.temperature: has a meaning only", "remove it"),
            (&format!("walther = {{ nu40 = \"55 mm2/s\" }}{at}"), "oil.walther.nu100: is missing", "nu100 = "),
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
                &format!(
                    "table = [{{ t = \"40 C\", nu = \"95 mm2/s\", mu = \"80 mPa.s\" }}, {{ t = \"90 C\", nu = \"15 mm2/s\" }}]{at}"
                ),
                "oil.table[0].nu: stands beside mu",
                "keep one",
            ),
            (&format!("table = [{{ nu = \"95 mm2/s\" }}]{at}"), "oil.table[0].t: is missing", "40 C"),
            ("grade = \"VG 46\", temperature = 80", "oil.temperature: a bare number has no unit", "\"80 C\""),
            ("viscosity = \"9 mPa.s\", density = \"0.9\"", "oil.density: \"0.9\" has no unit", "kg/m3"),
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
