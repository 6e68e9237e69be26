//! An orbit as the rows of the catalogue see it: its films at many crank angles, and the path between them.

use oilwedge_bearing::Coordinates;
use oilwedge_bearing::duty_cycle::PeriodicSpline;
use oilwedge_bearing::orbit::Span;
use oilwedge_reynolds::error_bar::Bar;
use oilwedge_reynolds::film_thickness::Deflection;
use oilwedge_reynolds::{FilmProblem, FilmSystem, Gap, JournalState, Thinnest};

use super::{FILM_THICKNESS_MIN, FILM_THICKNESS_MIN_ANGLE, Quantity, Row};

/// A film on the orbit, measured.
#[derive(Debug, Clone)]
pub struct Sample {
    /// Time from the beginning of the cycle [s].
    pub time: f64,
    /// The journal.
    pub journal: JournalState,
    /// What was measured on the film; its bars are those at this place and velocity of the journal.
    pub quantities: Vec<Quantity>,
    /// How far off each number may be because the journal is elsewhere: by the mesh, and by the steps in time; empty
    /// where errors are not estimated.
    pub drift: Vec<[f64; 2]>,
}

impl Sample {
    /// A number.
    pub fn value(&self, row: &Row) -> Option<f64> {
        Some(self.quantities[self.index(row)?].value)
    }

    /// Bar of the quantity.
    pub fn bar(&self, row: &Row) -> Option<Bar> {
        self.bar_of(self.index(row)?)
    }

    /// All numbers with their bars on the orbit.
    pub fn judged(&self) -> Vec<Quantity> {
        let mut quantities = self.quantities.clone();
        for (index, quantity) in quantities.iter_mut().enumerate() {
            quantity.set_bar(self.bar_of(index));
        }
        quantities
    }

    fn bar_of(&self, index: usize) -> Option<Bar> {
        let [by_mesh, by_time] = self.drift.get(index)?;
        let bar = self.quantities[index].bar?;
        Some(Bar { position: bar.position + by_mesh.abs(), time: by_time.abs(), ..bar })
    }

    fn index(&self, row: &Row) -> Option<usize> {
        self.quantities.iter().position(|quantity| quantity.row == row)
    }
}

/// A value, and its bar where errors are estimated.
pub type ValueWithBar = (f64, Option<Bar>);

/// One cycle of an orbit.
#[derive(Debug)]
pub struct CycleView<'a> {
    /// Films at growing times, the last one at the end of the cycle.
    pub samples: &'a [Sample],
    /// The path from film to film.
    pub path: &'a [Span],
    /// Gap of the film, of a rigid wall.
    pub gap: &'a Gap,
    /// A wall that gives way; `None`: it is rigid.
    pub wall: Option<WallOnPath<'a>>,
    /// What is free.
    pub coordinates: Coordinates,
    /// Angular speed of the crank [rad/s].
    pub angular_speed: f64,
    /// How far the path may be off between the films where the film is thinnest [m].
    pub between: f64,
    /// Greatest load [N].
    pub peak_load: f64,
    /// Deviation [m] that halves the equivalent film; `None`: it is not asked for.
    pub deviation_scale: Option<f64>,
}

/// A wall that gives way, along the path.
pub struct WallOnPath<'a> {
    /// The film.
    pub problem: &'a FilmProblem,
    /// The mesh of the film.
    pub system: &'a FilmSystem,
    /// The wall at each film.
    pub walls: Vec<Deflection>,
}

impl std::fmt::Debug for WallOnPath<'_> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("WallOnPath").field("walls", &self.walls.len()).finish()
    }
}

/// Part of the film thickness that decides between two places of the least film.
const PLACES_BETWEEN: u32 = 12;
/// Places at which a spline is asked for its extremes and its mean.
const PLACES: u32 = 4096;

/// A value at a time of the cycle [s].
#[derive(Debug, Clone, Copy)]
pub struct At {
    /// The time [s].
    pub time: f64,
    /// The value.
    pub value: f64,
}

impl CycleView<'_> {
    /// Length of the cycle [s].
    pub fn period(&self) -> f64 {
        self.samples.last().map_or(0.0, |sample| sample.time)
    }

    /// Crank angle at a time [deg].
    pub fn crank_angle(&self, time: f64) -> f64 {
        let turns = (self.angular_speed * self.period()).to_degrees();
        (self.angular_speed * time).to_degrees().rem_euclid(turns.max(f64::MIN_POSITIVE))
    }

    /// Number of the part of the path in which a time [s] lies.
    fn part(&self, time: f64) -> usize {
        let ended = self.path.partition_point(|span| span.times[1] < time);
        ended.min(self.path.len().saturating_sub(1))
    }

    /// The journal at a time [s].
    pub fn journal(&self, time: f64) -> JournalState {
        let rest = self.samples.first().map_or_else(JournalState::default, |sample| sample.journal);
        match self.path.get(self.part(time)) {
            Some(span) => self.coordinates.placed(&rest, span.at(time)),
            None => rest,
        }
    }

    /// The film at a time [s] under the wall that it has there; `None` of a rigid wall.
    fn under_wall(&self, time: f64) -> Option<(FilmProblem, &FilmSystem)> {
        let wall = self.wall.as_ref()?;
        let part = self.part(time);
        let (from, to) = (wall.walls.get(part)?, wall.walls.get(part + 1)?);
        let bent = from.with(self.path.get(part)?.wall([from, to], time));
        let problem = FilmProblem { journal: self.journal(time), ..wall.problem.clone() };
        Some((problem.deflected(Some(&bent)), wall.system))
    }

    /// The thinnest film at a time [s].
    fn thinnest_at(&self, time: f64) -> Thinnest {
        match self.under_wall(time) {
            Some((problem, system)) => Gap::of(&problem, system).thinnest_film(&problem, system),
            None => self.gap.thinnest(&self.journal(time)),
        }
    }

    /// The thinnest film of the cycle, and when it is there [s].
    pub fn thinnest(&self) -> (Thinnest, f64) {
        self.least_of(|time| self.thinnest_at(time))
    }

    /// The least film of the cycle along the axis at `z` [m], and when it is there [s].
    pub fn least_along(&self, z: f64) -> (Thinnest, f64) {
        self.least_of(|time| match self.under_wall(time) {
            Some((problem, system)) => Gap::of(&problem, system).thinnest_film_at(&problem, system, z),
            None => self.gap.thinnest_at(&self.journal(time), z),
        })
    }

    /// The least film of the cycle where `film` looks for it, and when it is there [s].
    fn least_of(&self, film: impl Fn(f64) -> Thinnest) -> (Thinnest, f64) {
        let at = |time: f64| (film(time), time);
        let times = self.path.iter().flat_map(|span| {
            let [from, to] = span.times;
            (0..PLACES_BETWEEN).map(move |k| from + (to - from) * f64::from(k) / f64::from(PLACES_BETWEEN))
        });
        let thinner = |a: (Thinnest, f64), b: (Thinnest, f64)| if b.0.thickness < a.0.thickness { b } else { a };
        let mut best = times.map(at).reduce(thinner).unwrap_or_else(|| at(0.0));
        // Golden section around the best of them.
        let width = (self.path.iter().map(|span| span.times[1] - span.times[0])).fold(0.0, f64::max);
        let mut step = width / f64::from(PLACES_BETWEEN);
        while step > 1e-9 * self.period().max(f64::MIN_POSITIVE) {
            best = [best.1 - step, best.1 + step]
                .map(|time| at(time.clamp(0.0, self.period())))
                .into_iter()
                .fold(best, thinner);
            step *= 0.7;
        }
        best
    }

    /// Half of the time [s] around `time` in which a value is within twice its `bar` of an extreme: where that may be
    /// in truth.
    pub fn doubt(&self, time: f64, bar: f64, off: impl Fn(f64) -> f64) -> f64 {
        let step = self.period() / f64::from(PLACES);
        let reach = |way: f64| {
            let is_within = |k: &u32| off(time + way * step * f64::from(*k)).abs() <= 2.0 * bar;
            f64::from((1..PLACES / 2).take_while(is_within).count() as u32 + 1)
        };
        step * reach(1.0).max(reach(-1.0))
    }

    /// The bar of the thinnest film of the cycle, at its time [s]: that of the films around it, and what the path is
    /// off between them.
    pub fn bar_of_thinnest(&self, time: f64) -> Option<Bar> {
        let bar = self.bar_at(&FILM_THICKNESS_MIN, time)?;
        Some(Bar { time: bar.time + self.between, ..bar })
    }

    /// The crank angle [deg] of the thinnest film and its bar.
    pub fn thinnest_crank_angle(&self) -> ValueWithBar {
        let (thinnest, time) = self.thinnest();
        let film = |at: f64| self.thinnest_at(at.rem_euclid(self.period())).thickness;
        let bar = self.bar_of_thinnest(time);
        let doubt = bar.map(|bar| self.doubt(time, bar.total(), |at| film(at) - thinnest.thickness));
        (self.crank_angle(time), doubt.map(|doubt| self.bar_of_time(doubt)))
    }

    /// The angle [deg] around the bearing at which the film is thinnest, and its bar.
    pub fn thinnest_angle(&self) -> ValueWithBar {
        let (thinnest, time) = self.thinnest();
        let film = |at: f64| self.thinnest_at(at.rem_euclid(self.period()));
        let bar = self.bar_of_thinnest(time);
        let doubt = bar.map(|bar| self.doubt(time, bar.total(), |at| film(at).thickness - thinnest.thickness));
        // Farthest from it in all of the time in doubt: after that time a journal that runs round may be back.
        let turned = |doubt: f64| {
            let step = self.period() / f64::from(PLACES);
            let times = (1..=(doubt / step).round() as u32)
                .flat_map(|k| [-1.0, 1.0].map(|way| time + way * step * f64::from(k)));
            let away = times.map(|at| {
                let (sin, cos) = (film(at).angle - thinnest.angle).sin_cos();
                sin.atan2(cos).abs()
            });
            away.fold(0.0, f64::max).to_degrees()
        };
        let at = self.bar_at(&FILM_THICKNESS_MIN_ANGLE, time);
        let bar = doubt.zip(at).map(|(doubt, at)| at + Bar::of(turned(doubt)));
        (super::view::degrees(thinnest.angle), bar)
    }

    /// The crank angle [deg] at which a row is greatest, and its bar.
    pub fn greatest_crank_angle(&self, row: &Row) -> Option<ValueWithBar> {
        let At { time, value } = self.greatest(row)?;
        let spline = self.spline(row)?;
        let bar = self.bar_at(row, time);
        let doubt = bar.map(|bar| self.doubt(time, bar.total(), |at| spline.at(at)[0] - value));
        Some((self.crank_angle(time), doubt.map(|doubt| self.bar_of_time(doubt))))
    }

    /// A bar [deg] of the crank angle, of a time [s].
    fn bar_of_time(&self, time: f64) -> Bar {
        Bar::of((self.angular_speed * time).to_degrees())
    }

    /// The greatest value of a row over the cycle, on the spline through those of the films.
    pub fn greatest(&self, row: &Row) -> Option<At> {
        let spline = self.spline(row)?;
        let time = |k: u32| self.period() * f64::from(k) / f64::from(PLACES);
        let at = |time: f64| At { time, value: spline.at(time)[0] };
        let all = (0..PLACES).map(|k| at(time(k)));
        all.reduce(|a, b| if b.value > a.value { b } else { a })
    }

    /// The part of the cycle [1] in which a row is above a level, on the spline through its values; its bar is the part
    /// in which it is within its bar of the level.
    pub fn part_above(&self, row: &Row, level: f64) -> Option<ValueWithBar> {
        let spline = self.spline(row)?;
        let places = (0..PLACES).map(|k| self.period() * f64::from(k) / f64::from(PLACES));
        let values: Vec<[f64; 2]> = places.map(|time| [time, spline.at(time)[0]]).collect();
        let part = |count: usize| count as f64 / f64::from(PLACES);
        let above = values.iter().filter(|[_, value]| *value > level).count();
        let bars: Option<Vec<f64>> = (values.iter()).map(|[time, _]| Some(self.bar_at(row, *time)?.total())).collect();
        let near =
            |bars: Vec<f64>| values.iter().zip(bars).filter(|([_, value], bar)| (value - level).abs() <= *bar).count();
        Some((part(above), bars.map(|bars| Bar::of(part(near(bars).max(1))))))
    }

    /// The mean of a row over the cycle.
    pub fn mean(&self, row: &Row) -> Option<f64> {
        let spline = self.spline(row)?;
        let time = |k: u32| self.period() * f64::from(k) / f64::from(PLACES);
        Some((0..PLACES).map(|k| spline.at(time(k))[0]).sum::<f64>() / f64::from(PLACES))
    }

    /// The bar of a mean: that of its films, and the mean of what is off by the orbit.
    pub fn bar_of_mean(&self, row: &Row) -> Option<Bar> {
        let bars: Option<Vec<Bar>> = self.samples.iter().map(|sample| sample.bar(row)).collect();
        let bars = bars?;
        let mut sum = Bar::default();
        for (pair, bars) in self.samples.windows(2).zip(bars.windows(2)) {
            let weight = 0.5 * (pair[1].time - pair[0].time) / self.period();
            sum = sum + bars[0].scaled(weight) + bars[1].scaled(weight);
        }
        Some(sum)
    }

    /// The bar of a row at a time [s]: the wider one of both films around it.
    pub fn bar_at(&self, row: &Row, time: f64) -> Option<Bar> {
        let next = self.samples.partition_point(|sample| sample.time < time);
        let around = [next.saturating_sub(1), next.min(self.samples.len().saturating_sub(1))];
        let [a, b] = around.map(|k| self.samples.get(k).and_then(|sample| sample.bar(row)));
        let (a, b) = (a?, b?);
        Some(if b.total() > a.total() { b } else { a })
    }

    fn spline(&self, row: &Row) -> Option<PeriodicSpline<1>> {
        let (_, films) = self.samples.split_last()?;
        let times = films.iter().map(|sample| sample.time).collect();
        let values: Option<Vec<[f64; 1]>> = films.iter().map(|sample| Some([sample.value(row)?])).collect();
        PeriodicSpline::new(times, values?, self.period()).ok()
    }
}
