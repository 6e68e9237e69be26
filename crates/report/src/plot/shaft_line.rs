//! A bent shaft: its centre line along the axis, in the plane of the load on the bearing with the least film and across
//! it, in the clearances of all bearings.

use oilwedge_drawing::{BLUE, Chart, Figure, GREY, Label, Note, Series, charts_figure};
use serde_json::Value;

use crate::shaft_view::ShaftView;

/// Height at which the name of a bearing stands, over its clearance.
const NAME: f64 = 1.12;

/// A plane through the axis: the components of a vector along it.
struct Plane {
    title: String,
    towards: [f64; 2],
}

/// The picture; `None` where the shaft has no line.
pub(super) fn shaft_line(view: &ShaftView, width: f64) -> Option<Figure> {
    let line = &view.result["deflection"];
    let [x, y] = pair(&line["force"])?;
    let size = x.hypot(y);
    // The way against the load is upwards; without a load, that of x.
    let up = if size > 0.0 { [-x / size, -y / size] } else { [1.0, 0.0] };
    let planes = [
        Plane { title: format!("the load on {} acts downwards", line["bearing"].as_str()?), towards: up },
        Plane { title: "across that load".to_owned(), towards: [up[1], -up[0]] },
    ];
    let charts: Vec<Chart> = planes.iter().map(|plane| chart(view, plane)).collect::<Option<_>>()?;
    let when = line["crank_angle_deg"].as_f64();
    let when = when.map_or(String::new(), |angle| format!(" at {angle:.0} deg, where a film is least"));
    Some(charts_figure(&format!("The shaft bent{when}: {}", view.title()), &charts, 2, width))
}

fn chart(view: &ShaftView, plane: &Plane) -> Option<Chart> {
    let line = &view.result["deflection"];
    let micrometres = |[x, y]: [f64; 2]| 1e6 * (x * plane.towards[0] + y * plane.towards[1]);
    let degrees = plane.towards[1].atan2(plane.towards[0]).to_degrees().round().rem_euclid(360.0);
    let upwards = Label::plain(&format!("displacement towards {degrees:.0} deg, um"));
    let mut chart = Chart::new(&plane.title, Label::marked("*z*, mm"), upwards);
    for (bearing, shell) in view.bearings().iter().zip(line["shells"].as_array()?) {
        let size = |key: &str| bearing["geometry"][key].as_f64();
        let (z, half, clearance) = (1e3 * bearing["at"].as_f64()?, 5e2 * size("length")?, 1e6 * size("clearance")?);
        let middle = micrometres(pair(shell)?);
        let corners = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0], [-1.0, -1.0]];
        let band = corners.map(|[across, up]| [z + across * half, middle + up * clearance]);
        chart.series.push(Series::line("clearance in which a journal lies", GREY, band.to_vec()));
        let name = Label::plain(bearing["name"].as_str()?);
        let [above, room] = [NAME, NAME + 0.1].map(|times| [z, middle + times * clearance]);
        chart.notes.push(Note { at: above, label: name, colour: GREY });
        // The axis reaches beyond the names: notes themselves take no room.
        chart.series.push(Series::line("", GREY, vec![room]));
    }
    let [z, x, y] = ["z", "x", "y"].map(|key| line[key].as_array());
    let places = z?.iter().zip(x?.iter().zip(y?));
    let points = places.map(|(z, (x, y))| Some([1e3 * z.as_f64()?, micrometres([x.as_f64()?, y.as_f64()?])]));
    chart.series.push(Series::line("centre line of the shaft", BLUE, points.collect::<Option<_>>()?));
    Some(chart)
}

fn pair(vector: &Value) -> Option<[f64; 2]> {
    Some([vector[0].as_f64()?, vector[1].as_f64()?])
}
