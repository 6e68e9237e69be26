//! An orbit as pictures show it: crank angles, the path, and numbers of its films, from a run or from `orbit.csv`.

use oilwedge_study::duty::PeriodicSpline;
use oilwedge_study::orbit::OrbitPath;
use oilwedge_study::quantities::{
    CONTACT_SHARE, FILM_THICKNESS_MIN, FRICTION_POWER, LOAD_X, LOAD_Y, PRESSURE_MAX, Row, SIDE_FLOW, TILT_X, TILT_Y,
};

use crate::Error;

/// Numbers that are drawn over the crank angle.
const DRAWN: [&Row; 9] = [
    &FILM_THICKNESS_MIN,
    &PRESSURE_MAX,
    &FRICTION_POWER,
    &LOAD_X,
    &LOAD_Y,
    &SIDE_FLOW,
    &CONTACT_SHARE,
    &TILT_X,
    &TILT_Y,
];
/// Points of a curve over a cycle.
const POINTS: u32 = 720;
/// How the columns of `orbit.csv` begin: crank angle, time, and the offset over the clearance.
const FIRST: [&str; 4] = ["crank angle", "time", "e_x/c", "e_y/c"];

/// One cycle: a point for each film, the end of the cycle the last.
#[derive(Debug, Clone, PartialEq)]
pub struct OrbitCourse {
    /// Crank angles [deg].
    angles: Vec<f64>,
    /// Offsets of the journal over the clearance [1].
    offsets: Vec<[f64; 2]>,
    /// The numbers of [`DRAWN`], in SI; none where the films have no such number.
    numbers: [Option<Vec<f64>>; DRAWN.len()],
}

impl OrbitCourse {
    /// The course of the path that a run has followed.
    pub fn of_path(path: &OrbitPath) -> Self {
        let of_row = |row: &Row| {
            let value = |quantities: &Vec<_>| value(quantities, row);
            path.quantities.iter().map(value).collect()
        };
        Self { angles: path.crank_angles.clone(), offsets: path.offsets.clone(), numbers: DRAWN.map(of_row) }
    }

    /// The course in a table of an orbit.
    ///
    /// # Errors
    /// It is no table of an orbit.
    pub fn from_csv(bytes: &[u8]) -> Result<Self, Error> {
        let unreadable = |what: String| Error::format("table of an orbit")(what);
        let mut reader = csv::Reader::from_reader(bytes);
        let headings = reader.headers().map_err(|error| unreadable(error.to_string()))?.clone();
        let column = |name: &str| {
            let is_its_own = |heading: &str| {
                heading.strip_prefix(name).is_some_and(|rest| rest.is_empty() || rest.starts_with(" ["))
            };
            headings.iter().position(is_its_own)
        };
        let first: Option<Vec<usize>> = FIRST.iter().map(|name| column(name)).collect();
        let Some([angle, _, x, y]) = first.as_deref() else {
            return Err(unreadable(format!("it has no columns {}", FIRST.join(", "))));
        };
        let drawn = DRAWN.map(|row| column(row.name));
        let (mut angles, mut offsets) = (Vec::new(), Vec::new());
        let mut numbers = drawn.map(|column| column.map(|_| Vec::new()));
        for record in reader.records() {
            let record = record.map_err(|error| unreadable(error.to_string()))?;
            let number = |column: usize| {
                let cell = record.get(column).unwrap_or_default();
                let number = cell.parse().ok().filter(|number: &f64| number.is_finite());
                number.ok_or_else(|| unreadable(format!("\"{cell}\" is no number")))
            };
            angles.push(number(*angle)?);
            offsets.push([number(*x)?, number(*y)?]);
            for (list, column) in numbers.iter_mut().zip(drawn) {
                if let (Some(list), Some(column)) = (list, column) {
                    list.push(number(column)?);
                }
            }
        }
        Ok(Self { angles, offsets, numbers })
    }

    /// Crank angle of the cycle [deg].
    pub fn period(&self) -> f64 {
        self.angles.last().copied().unwrap_or(0.0)
    }

    /// Offset of the journal over the clearance at crank angles [deg], on a smooth curve through its films; none where
    /// there is no curve.
    pub fn places(&self, angles: impl Iterator<Item = f64>) -> Vec<[f64; 2]> {
        let spline = self.spline(&self.offsets);
        spline.map_or(Vec::new(), |spline| angles.map(|angle| spline.at(angle)).collect())
    }

    /// The path over the cycle.
    pub fn path(&self) -> Vec<[f64; 2]> {
        self.places(self.even_angles())
    }

    /// A quantity over the crank angle [deg], on a smooth curve; nothing where the films have none.
    pub fn curve(&self, row: &Row) -> Vec<[f64; 2]> {
        let values = self.values(row);
        let values: Vec<[f64; 1]> = values.into_iter().flatten().map(|value| [*value]).collect();
        let spline = self.spline(&values);
        spline.map_or(Vec::new(), |spline| self.even_angles().map(|angle| [angle, spline.at(angle)[0]]).collect())
    }

    /// Two components of a vector at crank angles [deg], on a smooth curve; nothing where the films have none.
    pub fn vectors(&self, components: [&Row; 2], angles: impl Iterator<Item = f64>) -> Vec<[f64; 2]> {
        let [Some(x), Some(y)] = components.map(|row| self.values(row)) else {
            return Vec::new();
        };
        let values: Vec<[f64; 2]> = x.iter().zip(y).map(|(x, y)| [*x, *y]).collect();
        let spline = self.spline(&values);
        spline.map_or(Vec::new(), |spline| angles.map(|angle| spline.at(angle)).collect())
    }

    /// Crank angles over the cycle [deg], its end included.
    pub fn even_angles(&self) -> impl Iterator<Item = f64> + use<> {
        let period = self.period();
        (0..=POINTS).map(move |k| period * f64::from(k) / f64::from(POINTS))
    }

    /// Crank angles of the cycle at multiples of a `step` [deg].
    pub fn marked_angles(&self, step: f64) -> impl Iterator<Item = f64> + use<> {
        let period = self.period();
        (0..).map(move |k| step * f64::from(k)).take_while(move |mark| *mark < period - 1e-9)
    }

    fn values(&self, row: &Row) -> Option<&Vec<f64>> {
        let number = DRAWN.iter().position(|drawn| *drawn == row)?;
        self.numbers[number].as_ref()
    }

    /// The curve through values of the films; the last film is that of the first crank angle again.
    fn spline<const N: usize>(&self, values: &[[f64; N]]) -> Option<PeriodicSpline<N>> {
        let (end, angles) = self.angles.split_last()?;
        let values = values.get(..angles.len())?.to_vec();
        PeriodicSpline::new(angles.to_vec(), values, *end).ok()
    }
}

fn value(quantities: &[oilwedge_study::quantities::Quantity], row: &Row) -> Option<f64> {
    Some(quantities.iter().find(|quantity| quantity.row == row)?.value)
}

#[cfg(test)]
mod tests {
    use super::*;

    const TABLE: &str = "crank angle [deg],time [s],e_x/c [1],e_y/c [1],film_thickness_min [m],film_thickness_min error [m]\n\
        0.0,0.0,0.5,0.0,1e-5,1e-8\n90.0,0.1,0.0,0.5,2e-5,1e-8\n180.0,0.2,-0.5,0.0,1e-5,1e-8\n270.0,0.3,0.0,-0.5,2e-5,1e-8\n360.0,0.4,0.5,0.0,1e-5,1e-8\n";

    #[test]
    fn a_table_is_read() {
        let course = OrbitCourse::from_csv(TABLE.as_bytes()).unwrap_or_else(|error| panic!("{error}"));
        assert_eq!(course.period(), 360.0);
        let places = course.places([90.0, 360.0].into_iter());
        assert!((places[0][1] - 0.5).abs() < 1e-12 && (places[1][0] - 0.5).abs() < 1e-12, "{places:?}");
        assert_eq!((course.curve(&FILM_THICKNESS_MIN).len(), course.curve(&PRESSURE_MAX).len()), (721, 0));
        for (from, to) in [("crank angle", "angle"), ("-0.5,0.0", "-0.5,x")] {
            assert!(OrbitCourse::from_csv(TABLE.replacen(from, to, 1).as_bytes()).is_err(), "{to}");
        }
    }
}
