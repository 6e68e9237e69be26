//! Friction and the heat carried off against the temperature of the film, and where they cross.

use oilwedge_drawing::{BLUE, Chart, Figure, INK, Label, Mark, PAGE_WIDTH, Series, Stroke, VERMILION, charts_figure};
use oilwedge_study::quantities::{FRICTION_POWER, HEAT_CARRIED, HEAT_HOUSING, Row, TEMPERATURE_EFFECTIVE};
use serde_json::Value;

/// Files of the picture.
pub const TEMPERATURE_FILES: [&str; 2] = ["heat.svg", "heat.png"];

/// Name of the picture.
pub(crate) const BALANCE: &str = "heat";

/// True where a run has sought the temperature of one film: over a cycle there are no curves.
pub(super) fn is_sought(result: &Value) -> bool {
    result[BALANCE]["curve"].as_array().is_some_and(|curve| !curve.is_empty())
}

/// The picture of a balance of heat, at most that wide [mm], from the object of `result.json`; `None` where it has
/// none.
pub(crate) fn temperature_figure(result: &Value, width: f64) -> Option<Figure> {
    let points = result[BALANCE]["curve"].as_array().filter(|points| !points.is_empty())?;
    let number = |point: &Value, key: &str| point[key].as_f64().unwrap_or(f64::NAN);
    let curve = |name: &str, colour, value: &dyn Fn(&Value) -> f64| {
        let points = points.iter().map(|point| [number(point, "temperature"), value(point)]);
        Series::line(name, colour, points.collect()).marked(Mark::Disc)
    };
    let title = result["title"].as_str().unwrap_or_default();
    let name = Label::marked("mean temperature of the film *T*, \u{b0}C");
    let mut chart = Chart::new("", name, Label::plain("power, W"));
    chart.series = vec![
        curve("friction", VERMILION, &|point| number(point, FRICTION_POWER.name)),
        curve("heat carried off", BLUE, &|point| number(point, HEAT_CARRIED.name) + number(point, HEAT_HOUSING.name)),
    ];
    let found = |row: &Row| result["quantities"][row.name]["value"].as_f64();
    if let (Some(temperature), Some(power)) = (found(&TEMPERATURE_EFFECTIVE), found(&FRICTION_POWER)) {
        let name = format!("{temperature:.1} \u{b0}C, {power:.0} W");
        let line = vec![[temperature, 0.0], [temperature, power]];
        chart.series.push(Series::line("", INK, line).stroked(Stroke::Dashed));
        chart.series.push(Series::marks(&name, INK, Mark::Ring, vec![[temperature, power]]));
    }
    Some(charts_figure(&format!("{title}: balance of heat"), &[chart], 1, width.min(0.6 * PAGE_WIDTH)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plot::to_png;
    use serde_json::json;

    fn result(points: &[[f64; 3]]) -> Value {
        let point = |[temperature, friction, carried]: &[f64; 3]| json!({ "temperature": temperature, FRICTION_POWER.name: friction, HEAT_CARRIED.name: carried, HEAT_HOUSING.name: 1.0 });
        let found = |value: f64| json!({ "value": value });
        json!({
            "title": "A <bearing>",
            BALANCE: { "curve": points.iter().map(point).collect::<Vec<_>>() },
            "quantities": { TEMPERATURE_EFFECTIVE.name: found(82.0), FRICTION_POWER.name: found(330.0) },
        })
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
        let drawn = |result: &Value| temperature_figure(result, PAGE_WIDTH);
        assert!(drawn(&result(&[[80.0, 0.0, 0.0]])).is_some_and(|figure| to_png(&figure).is_ok()));
        assert!(drawn(&result(&[])).is_none() && drawn(&json!({ "title": "a" })).is_none());
    }
}
