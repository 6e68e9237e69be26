//! Friction and the heat carried off against the temperature of the film, and where they cross.

use super::chart::{COLOURS, Chart, Series, Style, charts_to_svg};
use super::shortened;
use crate::Error;
use oilwedge_study::quantities::{FRICTION_POWER, Row, TEMPERATURE_EFFECTIVE};
use oilwedge_study::result::{RunResult, TemperaturePoint, TemperatureReport};

fn carried(point: &TemperaturePoint) -> f64 {
    point.carried + point.given_off
}

/// Files of the picture.
pub const TEMPERATURE_FILES: [&str; 2] = ["heat.svg", "heat.png"];

/// The picture of a run's balance of heat as SVG; `None` where it has none.
///
/// # Errors
/// [`Error::Format`].
pub fn temperature_to_svg(result: &RunResult) -> Result<Option<String>, Error> {
    let value = |row: &Row| result.quantity(row).map(|quantity| quantity.value);
    let found = value(&TEMPERATURE_EFFECTIVE).zip(value(&FRICTION_POWER));
    let found = found.map(|(temperature, power)| [temperature, power]);
    let drawn = |report: &TemperatureReport| to_svg(&result.title, report, found);
    result.temperature.as_ref().map(drawn).transpose()
}

/// `found` is the temperature found [degrees C] and the power there [W].
fn to_svg(title: &str, report: &TemperatureReport, found: Option<[f64; 2]>) -> Result<String, Error> {
    let curve = |name: &str, colour: [u8; 3], value: &dyn Fn(&TemperaturePoint) -> f64| {
        let points: Vec<[f64; 2]> = (report.curve.iter())
            .map(|point| [point.temperature, value(point)])
            .collect();
        let series = |style| Series {
            name: name.to_owned(),
            style,
            colour,
            points: points.clone(),
        };
        [series(Style::Line), series(Style::Discs)]
    };
    let friction = curve("friction", COLOURS[4], &|point| point.friction_power);
    let oil = curve("heat carried off", COLOURS[0], &carried);
    let crossing = found.map(|[temperature, power]| {
        let series = |style, points| Series {
            name: format!("{temperature:.1} C, {power:.0} W"),
            style,
            colour: COLOURS[5],
            points,
        };
        let at = [temperature, power];
        [
            series(Style::Dashes, vec![[temperature, 0.0], at]),
            series(Style::Rings, vec![at]),
        ]
    });
    let chart = Chart {
        title: shortened(title),
        x: "mean temperature of the film [C]".to_owned(),
        y: "power [W]".to_owned(),
        is_drawing: false,
        series: friction
            .into_iter()
            .chain(oil)
            .chain(crossing.into_iter().flatten())
            .collect(),
    };
    charts_to_svg(&[chart], 1)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plot::to_png;

    fn report(points: &[(f64, f64, f64)]) -> TemperatureReport {
        let point = |&(temperature, friction_power, carried): &(f64, f64, f64)| TemperaturePoint {
            temperature,
            viscosity: 0.01,
            friction_power,
            carried,
            given_off: 1.0,
            eccentricity: 0.5,
        };
        TemperatureReport {
            inlet_temperature: 75.0,
            curve: points.iter().map(point).collect(),
            ..TemperatureReport::default()
        }
    }

    #[test]
    fn the_picture_tells_both_curves_and_where_they_cross() {
        let report = report(&[(75.0, 400.0, -3.0), (82.0, 330.0, 329.0), (90.0, 280.0, 700.0)]);
        let svg = to_svg("A <bearing>", &report, Some([82.0, 330.0])).expect("a drawing");
        for words in [
            "A &lt;bearing&gt;",
            "mean temperature of the film [C]",
            "friction",
            "heat carried off",
            "82.0 C, 330 W",
            "power [W]",
        ] {
            assert!(
                svg.contains(words) || svg.contains(&words.replace(['<', '>'], "\n")),
                "no {words}"
            );
        }
        assert!(to_png(&svg).is_ok());
    }

    #[test]
    fn few_points_are_drawn_too() {
        for points in [&[][..], &[(80.0, 0.0, 0.0)]] {
            assert!(to_svg("a", &report(points), None).is_ok());
        }
    }
}
