//! A bent shaft: its centre line along the axis, in the plane of the load on the bearing with the least film and across
//! it, in the clearances of all bearings.

use oilwedge_drawing::{BLUE, Chart, Figure, GREY, Label, Note, Series, charts_figure};
use oilwedge_study::result::Geometry;
use oilwedge_study::shaft::{BearingReport, ShaftDeflection};

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
    let line = view.result.deflection.as_ref()?;
    let [x, y] = line.force;
    let size = x.hypot(y);
    // The way against the load is upwards; without a load, that of x.
    let up = if size > 0.0 { [-x / size, -y / size] } else { [1.0, 0.0] };
    let planes = [
        Plane { title: format!("the load on {} acts downwards", line.bearing), towards: up },
        Plane { title: "across that load".to_owned(), towards: [up[1], -up[0]] },
    ];
    let charts: Vec<Chart> = planes.iter().map(|plane| chart(view.bearings(), line, plane)).collect();
    let when = line.crank_angle_deg.map_or(String::new(), |angle| format!(" at {angle:.0} deg, where a film is least"));
    Some(charts_figure(&format!("The shaft bent{when}: {}", view.result.head.title), &charts, 2, width))
}

fn chart(bearings: &[BearingReport], line: &ShaftDeflection, plane: &Plane) -> Chart {
    let micrometres = |[x, y]: [f64; 2]| 1e6 * (x * plane.towards[0] + y * plane.towards[1]);
    let degrees = plane.towards[1].atan2(plane.towards[0]).to_degrees().round().rem_euclid(360.0);
    let upwards = Label::plain(&format!("displacement towards {degrees:.0} deg, um"));
    let mut chart = Chart::new(&plane.title, Label::marked("*z*, mm"), upwards);
    for (bearing, shell) in bearings.iter().zip(&line.shells) {
        let Geometry { length, clearance, .. } = bearing.geometry;
        let (z, half, clearance) = (1e3 * bearing.at, 5e2 * length, 1e6 * clearance);
        let middle = micrometres(*shell);
        let corners = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0], [-1.0, -1.0]];
        let band = corners.map(|[across, up]| [z + across * half, middle + up * clearance]);
        chart.series.push(Series::line("clearance in which a journal lies", GREY, band.to_vec()));
        let name = Label::plain(&bearing.name);
        let [above, room] = [NAME, NAME + 0.1].map(|times| [z, middle + times * clearance]);
        chart.notes.push(Note { at: above, label: name, colour: GREY });
        // The axis reaches beyond the names: notes themselves take no room.
        chart.series.push(Series::line("", GREY, vec![room]));
    }
    let points = line.z.iter().zip(line.x.iter().zip(&line.y));
    let points = points.map(|(z, (x, y))| [1e3 * z, micrometres([*x, *y])]);
    chart.series.push(Series::line("centre line of the shaft", BLUE, points.collect()));
    chart
}
