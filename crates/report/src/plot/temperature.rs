//! Friction and the heat carried off against the temperature of the film, and where they cross.

use oilwedge_drawing::{BLUE, Chart, Figure, INK, Label, Mark, PAGE_WIDTH, Series, Stroke, VERMILION, charts_figure};
use oilwedge_study::quantities::{FRICTION_POWER, Row, TEMPERATURE_EFFECTIVE};
use oilwedge_study::result::{RunResult, TemperaturePoint};

/// Files of the picture.
pub const TEMPERATURE_FILES: [&str; 2] = ["heat.svg", "heat.png"];

/// Name of the picture.
pub(crate) const BALANCE: &str = "heat";

/// The curves of the balance of heat of one film; of a cycle or without a balance there are none.
pub(super) fn temperature_curve(result: &RunResult) -> &[TemperaturePoint] {
    result.temperature.as_ref().map_or(&[], |report| &report.curve)
}

/// The picture of a balance of heat, at most that wide [mm]; `None` where a result has none.
pub(crate) fn temperature_figure(result: &RunResult, width: f64) -> Option<Figure> {
    let points = Some(temperature_curve(result)).filter(|points| !points.is_empty())?;
    let curve = |name: &str, colour, value: &dyn Fn(&TemperaturePoint) -> f64| {
        let points = points.iter().map(|point| [point.temperature, value(point)]);
        Series::line(name, colour, points.collect()).marked(Mark::Disc)
    };
    let name = Label::marked("mean temperature of the film *T*, \u{b0}C");
    let mut chart = Chart::new("", name, Label::plain("power, W"));
    chart.series = vec![
        curve("friction", VERMILION, &|point| point.friction_power),
        curve("heat carried off", BLUE, &|point| point.removed()),
    ];
    let found = |row: &Row| result.quantity(row).map(|it| it.value);
    if let (Some(temperature), Some(power)) = (found(&TEMPERATURE_EFFECTIVE), found(&FRICTION_POWER)) {
        let name = format!("{temperature:.1} \u{b0}C, {power:.0} W");
        let line = vec![[temperature, 0.0], [temperature, power]];
        chart.series.push(Series::line("", INK, line).stroked(Stroke::Dashed));
        chart.series.push(Series::marks(&name, INK, Mark::Ring, vec![[temperature, power]]));
    }
    Some(charts_figure(&format!("{}: balance of heat", result.head.title), &[chart], 1, width.min(0.6 * PAGE_WIDTH)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plot::to_png;
    use oilwedge_study::quantities::Quantity;
    use oilwedge_study::result::{ResultHead, TemperatureReport};

    fn result(points: &[[f64; 3]]) -> RunResult {
        let point = |&[temperature, friction_power, carried]: &[f64; 3]| TemperaturePoint {
            temperature,
            friction_power,
            ..TemperaturePoint::removing(carried, 1.0)
        };
        let curve = points.iter().map(point).collect();
        RunResult {
            head: ResultHead { title: "A <bearing>".to_owned(), ..ResultHead::default() },
            temperature: Some(TemperatureReport { curve, ..TemperatureReport::default() }),
            quantities: vec![Quantity::new(&TEMPERATURE_EFFECTIVE, 82.0), Quantity::new(&FRICTION_POWER, 330.0)],
            ..RunResult::default()
        }
    }

    #[test]
    fn the_picture_shows_both_curves_and_where_they_cross() {
        let points = [[75.0, 400.0, -3.0], [82.0, 330.0, 329.0], [90.0, 280.0, 700.0]];
        let figure = temperature_figure(&result(&points), PAGE_WIDTH).expect("a picture");
        let svg = figure.to_svg();
        for words in ["A &lt;bearing&gt;", "friction", "heat carried off", "82.0 \u{b0}C, 330 W", "power, W"] {
            assert!(svg.contains(words), "no {words}");
        }
        assert!(to_png(&figure).is_ok());
    }

    /// A cycle has no points of a heat balance to draw.
    #[test]
    fn one_point_is_drawn_and_none_is_no_picture() {
        let drawn = |result: &RunResult| temperature_figure(result, PAGE_WIDTH);
        assert!(drawn(&result(&[[80.0, 0.0, 0.0]])).is_some_and(|figure| to_png(&figure).is_ok()));
        assert!(drawn(&result(&[])).is_none() && drawn(&RunResult::default()).is_none());
    }
}
