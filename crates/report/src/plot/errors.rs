//! Error against time and against unknowns: curves of all strategies, with their bars and the next digit.

use super::axes::{Axis, Frame, Scale};
use super::canvas::{CENTRE, Canvas, LEFT, Letters, Mark, Pen};
use super::palette::{BAND, GREY, INK, of_strategy};
use crate::Error;
use oilwedge_campaign::convergence::{ConvergenceReport, Course, LevelReport, Measure, Strategy};
use plotters::style::RGBColor;

/// Dashes of error bars, and of what is predicted [points].
const BAR: [f64; 2] = [5.0, 3.5];
const PREDICTED: [f64; 2] = [1.6, 2.6];

/// What a panel shows errors against.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Against {
    Time,
    Unknowns,
}

impl Against {
    fn of(self, level: &LevelReport) -> f64 {
        match self {
            Self::Time => level.seconds.total,
            Self::Unknowns => level.unknowns as f64,
        }
    }
}

fn mark(strategy: Strategy) -> Mark {
    match strategy {
        Strategy::P1Uniform => Mark::Disc,
        Strategy::P2Uniform => Mark::Square,
        Strategy::P2Adaptive => Mark::Triangle,
    }
}

/// True errors of a course that mean something: not below what the finest answer is known to.
fn errors(report: &ConvergenceReport, course: &Course, against: Against) -> Vec<[f64; 2]> {
    let floor = floor(report).unwrap_or(0.0);
    let point = |level: &LevelReport| Some([against.of(level), level.relative_error?]);
    let points = course.levels.iter().filter_map(point);
    points.filter(|[_, error]| *error > floor).collect()
}

/// Bars of a course.
fn bars(course: &Course, against: Against) -> Vec<[f64; 2]> {
    let point = |level: &LevelReport| Some([against.of(level), level.relative_bar?]);
    let points = course.levels.iter().filter_map(point);
    points.filter(|[_, bar]| *bar > 0.0).collect()
}

/// What is predicted: from the last known points of a strategy to its price beyond. Bars are what is predicted, if there are any.
fn predictions(report: &ConvergenceReport, against: Against) -> Vec<(Strategy, Vec<[f64; 2]>)> {
    let (Some(reference), Some(first)) = (&report.reference, report.prices.first()) else {
        return Vec::new();
    };
    let measure = first.measure;
    let predicted = |course: &Course| {
        let beyond: Vec<_> = (report.prices.iter())
            .filter(|price| price.extrapolated && price.measure == measure && price.strategy == course.strategy)
            .map(|price| match against {
                Against::Time => [price.seconds, price.accuracy],
                Against::Unknowns => [price.unknowns, price.accuracy],
            })
            .collect();
        let last = course.levels.last()?;
        let start = [against.of(last), last.error(measure, reference)?];
        // From the last point that is drawn on.
        let drawn = errors(report, course, against)
            .pop()
            .filter(|_| measure == Measure::Error);
        let points = drawn.into_iter().chain([start]).chain(beyond.iter().copied()).collect();
        (!beyond.is_empty()).then_some((course.strategy, points))
    };
    report.strategies.iter().filter_map(predicted).collect()
}

/// What the finest answer is known to.
fn floor(report: &ConvergenceReport) -> Option<f64> {
    report.reference.as_ref()?.uncertainty
}

/// Both panels side by side within the rectangle `left, top, width, height` [points].
pub(super) fn draw(
    canvas: &Canvas,
    report: &ConvergenceReport,
    [left, top, width, height]: [f64; 4],
) -> Result<(), Error> {
    const GAP: f64 = 64.0;
    const NUMBERS: f64 = 74.0;
    let half = 0.5 * (width - GAP - NUMBERS);
    let known = (report.strategies.iter())
        .flat_map(|course| [errors(report, course, Against::Time), bars(course, Against::Time)])
        .flatten();
    let predicted = predictions(report, Against::Time);
    let predicted = predicted.iter().flat_map(|(_, points)| points);
    let y = Axis::logarithmic(known.chain(predicted.copied()).map(|[_, error]| error), Scale::Powers);
    for (against, place) in [(Against::Time, 0.0), (Against::Unknowns, 1.0)] {
        let levels = report.levels().map(|(_, level)| against.of(level));
        let beyond = predictions(report, against);
        let beyond = beyond.iter().flat_map(|(_, points)| points.iter().map(|[x, _]| *x));
        let scale = match against {
            Against::Time => Scale::Seconds,
            Against::Unknowns => Scale::Powers,
        };
        let frame = Frame {
            left: left + NUMBERS + place * (half + GAP),
            top,
            width: half,
            height,
            x: Axis::logarithmic(levels.chain(beyond), scale),
            y,
        };
        panel(canvas, report, against, &frame)?;
    }
    Ok(())
}

/// One diagram of errors.
fn panel(canvas: &Canvas, report: &ConvergenceReport, against: Against, frame: &Frame) -> Result<(), Error> {
    draw_ground(canvas, report, against, frame)?;
    let place = |points: &[[f64; 2]]| -> Vec<[f64; 2]> { points.iter().map(|point| frame.at(*point)).collect() };
    for (strategy, points) in predictions(report, against) {
        let points = place(&points);
        canvas.dashed(&points, PREDICTED, Pen(1.6, of_strategy(strategy)))?;
        if let Some(&point) = points.last() {
            canvas.mark(point, Mark::Diamond, of_strategy(strategy), false)?;
        }
    }
    for course in &report.strategies {
        let colour = of_strategy(course.strategy);
        let dashed = place(&bars(course, against));
        if dashed.len() > 1 {
            canvas.dashed(&dashed, BAR, Pen(1.4, colour))?;
        }
        let points = place(&errors(report, course, against));
        if points.len() > 1 {
            canvas.line(&points, Pen(1.8, colour))?;
        }
        for point in points {
            canvas.mark(point, mark(course.strategy), colour, true)?;
        }
    }
    match against {
        Against::Time => {
            let name = format!("relative error of the {}", report.goal.name);
            frame.draw_frame(canvas, "time from the scene to the answer", &name)
        }
        Against::Unknowns => frame.draw_frame(canvas, "unknown pressures", ""),
    }
}

/// The grid, and the band of errors below the uncertainty of the finest answer.
fn draw_ground(canvas: &Canvas, report: &ConvergenceReport, against: Against, frame: &Frame) -> Result<(), Error> {
    let [right, bottom] = frame.corner();
    let level = floor(report).map(|floor| frame.at([1.0, floor])[1]);
    let band = level.filter(|level| *level < bottom).map(|level| level.max(frame.top));
    if let Some(level) = band {
        canvas.rectangle([frame.left, level], [right, bottom], BAND)?;
    }
    frame.draw_grid(canvas)?;
    if band.is_some_and(|level| bottom - level > 18.0) && against == Against::Time {
        let note = "below the uncertainty of the finest answer";
        canvas.text(
            [frame.left + 8.0, bottom - 16.0],
            note,
            Letters::new(11.0, LEFT).coloured(GREY),
        )?;
    }
    if floor(report).is_none() {
        let middle = [0.5 * (frame.left + right), 0.5 * (frame.top + bottom)];
        canvas.text(middle, "one level only: no error is known", Letters::new(13.0, CENTRE))?;
    }
    Ok(())
}

/// The legend in one row, from `left` on, its middle at `y` [points].
pub(super) fn draw_legend(canvas: &Canvas, report: &ConvergenceReport, left: f64, y: f64) -> Result<(), Error> {
    let mut x = left;
    let mut entry = |name: &str, sample: &dyn Fn(f64) -> Result<(), Error>| {
        sample(x)?;
        canvas.text([x + 36.0, y], name, Letters::new(13.0, LEFT))?;
        x += 36.0 + 7.2 * name.chars().count() as f64 + 22.0;
        Ok::<(), Error>(())
    };
    let stroke = |x: f64| [[x, y], [x + 28.0, y]];
    for course in report.strategies.iter().filter(|course| !course.levels.is_empty()) {
        let colour = of_strategy(course.strategy);
        entry(course.strategy.name(), &|x| {
            canvas.line(&stroke(x), Pen(1.8, colour))?;
            canvas.mark([x + 14.0, y], mark(course.strategy), colour, true)
        })?;
    }
    let sample = |dashes: [f64; 2], colour: RGBColor| move |x: f64| canvas.dashed(&stroke(x), dashes, Pen(1.5, colour));
    if report.levels().any(|(_, level)| level.relative_bar.is_some()) {
        entry("estimated error bar", &sample(BAR, INK))?;
    }
    if report.prices.iter().any(|price| price.extrapolated) {
        entry("predicted", &|x| {
            sample(PREDICTED, INK)(x)?;
            canvas.mark([x + 14.0, y], Mark::Diamond, INK, false)
        })?;
    }
    Ok(())
}
