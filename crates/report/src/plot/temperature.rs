//! Friction and the heat carried off against the temperature of the film, and where they cross.

use oilwedge_drawing::{BLUE, Chart, INK, Label, Mark, PAGE_WIDTH, Series, Stroke, VERMILION, charts_figure};
use oilwedge_study::quantities::{FRICTION_POWER, Row, TEMPERATURE_EFFECTIVE};
use oilwedge_study::result::{RunResult, TemperaturePoint, TemperatureReport};

fn carried(point: &TemperaturePoint) -> f64 {
    point.carried + point.given_off
}

/// Files of the picture.
pub const TEMPERATURE_FILES: [&str; 2] = ["heat.svg", "heat.png"];

/// The picture of a run's balance of heat as SVG; `None` where it has none.
pub fn temperature_to_svg(result: &RunResult) -> Option<String> {
    let value = |row: &Row| result.quantity(row).map(|quantity| quantity.value);
    let found = value(&TEMPERATURE_EFFECTIVE).zip(value(&FRICTION_POWER));
    let found = found.map(|(temperature, power)| [temperature, power]);
    result
        .temperature
        .as_ref()
        .map(|report| to_svg(&result.title, report, found))
}

/// `found` is the temperature found [degrees C] and the power there [W].
fn to_svg(title: &str, report: &TemperatureReport, found: Option<[f64; 2]>) -> String {
    let curve = |name: &str, colour, value: &dyn Fn(&TemperaturePoint) -> f64| {
        let points = report.curve.iter().map(|point| [point.temperature, value(point)]);
        Series::line(name, colour, points.collect()).marked(Mark::Disc)
    };
    let mut chart = Chart::new(
        title,
        Label::plain("mean temperature of the film, \u{b0}C"),
        Label::plain("power, W"),
    );
    chart.series = vec![
        curve("friction", VERMILION, &|point| point.friction_power),
        curve("heat carried off", BLUE, &carried),
    ];
    if let Some([temperature, power]) = found {
        let name = format!("{temperature:.1} \u{b0}C, {power:.0} W");
        let line = vec![[temperature, 0.0], [temperature, power]];
        chart.series.push(Series::line("", INK, line).stroked(Stroke::Dashed));
        chart
            .series
            .push(Series::marks(&name, INK, Mark::Ring, vec![[temperature, power]]));
    }
    charts_figure("Balance of heat", &[chart], 1, 0.6 * PAGE_WIDTH).to_svg()
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
        let svg = to_svg("A <bearing>", &report, Some([82.0, 330.0]));
        for words in [
            "A &lt;bearing&gt;",
            "mean temperature of the film, \u{b0}C",
            "friction",
            "heat carried off",
            "82.0 \u{b0}C, 330 W",
            "power, W",
        ] {
            assert!(svg.contains(words), "no {words}");
        }
        assert!(to_png(&svg).is_ok());
    }

    #[test]
    fn few_points_are_drawn_too() {
        for points in [&[][..], &[(80.0, 0.0, 0.0)]] {
            assert!(to_png(&to_svg("a", &report(points), None)).is_ok());
        }
    }
}
