//! A convergence study: error against time and against unknowns, and the adaptive mesh.

use oilwedge_campaign::convergence::{
    AccuracyMeasure, Convergence, ConvergenceReport, LevelReport, Strategy, StrategyLevels,
};
use oilwedge_drawing::{
    Anchor, Axis, BLUE, Band, Chart, Colour, Figure, GREEN, GREY, INK, Label, LegendEntry, Letters, Mark, Note,
    PAGE_WIDTH, SMALLEST_LETTERS, Scale, Series, Stroke, VERMILION, draw_legend, legend_height,
};

use super::error_map;

/// Margin around the sheet, and gap between its parts [mm].
const MARGIN: f64 = 1.0;
const GAP: f64 = 5.0;
/// Height of the charts [mm].
const HEIGHT: f64 = 66.0;

/// What a chart shows errors against.
#[derive(Debug, Clone, Copy, PartialEq)]
enum ErrorAxis {
    Time,
    Unknowns,
}

impl ErrorAxis {
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

fn colour(strategy: Strategy) -> Colour {
    match strategy {
        Strategy::P1Uniform => VERMILION,
        Strategy::P2Uniform => BLUE,
        Strategy::P2Adaptive => GREEN,
    }
}

/// True errors of a course that mean something: not below what the finest answer is known to.
fn errors(report: &ConvergenceReport, course: &StrategyLevels, against: ErrorAxis) -> Vec<[f64; 2]> {
    let floor = floor(report).unwrap_or(0.0);
    let point = |level: &LevelReport| Some([against.of(level), level.relative_error?]);
    let points = course.levels.iter().filter_map(point);
    points.filter(|[_, error]| *error > floor).collect()
}

/// Bars of a course.
fn bars(course: &StrategyLevels, against: ErrorAxis) -> Vec<[f64; 2]> {
    let point = |level: &LevelReport| Some([against.of(level), level.relative_bar?]);
    let points = course.levels.iter().filter_map(point);
    points.filter(|[_, bar]| *bar > 0.0).collect()
}

/// What is predicted: from the last known points of a strategy to its price beyond. Bars are what is predicted, if
/// there are any.
fn predictions(report: &ConvergenceReport, against: ErrorAxis) -> Vec<(Strategy, Vec<[f64; 2]>)> {
    let (Some(reference), Some(first)) = (&report.reference, report.prices.first()) else {
        return Vec::new();
    };
    let measure = first.measure;
    let predicted = |course: &StrategyLevels| {
        let beyond: Vec<_> = (report.prices.iter())
            .filter(|price| price.extrapolated && price.measure == measure && price.strategy == course.strategy)
            .map(|price| match against {
                ErrorAxis::Time => [price.seconds, price.accuracy],
                ErrorAxis::Unknowns => [price.unknowns, price.accuracy],
            })
            .collect();
        let last = course.levels.last()?;
        let start = [against.of(last), last.error(measure, reference)?];
        // From the last point that is drawn on.
        let drawn = errors(report, course, against).pop().filter(|_| measure == AccuracyMeasure::Error);
        let points = drawn.into_iter().chain([start]).chain(beyond.iter().copied()).collect();
        (!beyond.is_empty()).then_some((course.strategy, points))
    };
    report.strategies.iter().filter_map(predicted).collect()
}

/// What the finest answer is known to.
fn floor(report: &ConvergenceReport) -> Option<f64> {
    report.reference.as_ref()?.uncertainty
}

/// One chart of errors.
fn chart(report: &ConvergenceReport, against: ErrorAxis) -> Chart {
    let (x, y) = match against {
        ErrorAxis::Time => (
            (Label::plain("time from the scene to the answer"), Scale::Seconds),
            Label::plain(&format!("relative error of the {}", report.goal.name)),
        ),
        ErrorAxis::Unknowns => ((Label::plain("unknown pressures"), Scale::Powers), Label::default()),
    };
    let mut chart = Chart::new("", x.0, y);
    (chart.x.1, chart.y.1) = (x.1, Scale::Powers);
    for (strategy, points) in predictions(report, against) {
        let last = points.last().copied();
        let line = Series::line("", colour(strategy), points).stroked(Stroke::Dotted);
        let end = Series::marks("", colour(strategy), Mark::Diamond, last.into_iter().collect());
        chart.series.extend([line, end]);
    }
    for course in &report.strategies {
        let colour = colour(course.strategy);
        let dashed = Series::line("", colour, bars(course, against)).stroked(Stroke::Dashed);
        let line = Series::line("", colour, errors(report, course, against)).marked(mark(course.strategy));
        chart.series.extend([dashed, line]);
    }
    if let Some(high) = floor(report) {
        let note = match against {
            ErrorAxis::Time => Label::plain("below the uncertainty of the finest answer"),
            ErrorAxis::Unknowns => Label::default(),
        };
        let low = f64::NEG_INFINITY;
        chart.bands.push(Band { low, high, note });
    }
    chart
}

fn legend(report: &ConvergenceReport) -> Vec<LegendEntry> {
    let entry = |name: &str, colour: Colour, stroke: Stroke, mark: Option<Mark>| LegendEntry {
        name: Label::plain(name),
        colour,
        stroke: Some(stroke),
        mark,
        area: None,
    };
    let courses = report.strategies.iter().filter(|course| !course.levels.is_empty());
    let of_course = |course: &StrategyLevels| {
        let strategy = course.strategy;
        entry(strategy.name(), colour(strategy), Stroke::Solid, Some(mark(strategy)))
    };
    let mut entries: Vec<LegendEntry> = courses.map(of_course).collect();
    if report.levels().any(|(_, level)| level.relative_bar.is_some()) {
        entries.push(entry("estimated error bar", INK, Stroke::Dashed, None));
    }
    if report.prices.iter().any(|price| price.extrapolated) {
        entries.push(entry("predicted", INK, Stroke::Dotted, Some(Mark::Diamond)));
    }
    entries
}

/// What errors are measured against.
fn subtitle(report: &ConvergenceReport) -> String {
    let Some(reference) = &report.reference else {
        return String::new();
    };
    let unit = match report.goal.unit.as_str() {
        "1" => String::new(),
        unit => format!(" {unit}"),
    };
    let known = reference.uncertainty.map(|known| format!(", itself known to {known:.0e}")).unwrap_or_default();
    let decimals = (9.0 - reference.value.abs().log10().floor()).clamp(0.0, 15.0) as usize;
    format!(
        "Error of the {} against the finest answer, {:.decimals$}{unit}: {}, level {}, {} unknowns{known}",
        report.goal.name,
        reference.value,
        reference.strategy.name(),
        reference.level,
        reference.unknowns
    )
}

/// The picture of a study.
pub(super) fn figure(study: &Convergence) -> Figure {
    let report = &study.report;
    let width = PAGE_WIDTH - 2.0 * MARGIN;
    let description = format!(
        "{}. Relative error against computing time and against the number of unknowns, for each way to more accuracy{}.",
        subtitle(report),
        if study.mesh.is_some() { "; below, the adaptive mesh" } else { "" }
    );
    let mut figure = Figure::new([PAGE_WIDTH, 0.0], &report.head.title, &description);
    let (bold, small) = (Letters::sized(9.0).bold(), Letters::sized(SMALLEST_LETTERS).coloured(GREY));
    let mut y = MARGIN + 0.5 * bold.line();
    figure.text([MARGIN, y], &Label::fitted(&report.head.title, bold, width), bold, Anchor::Left);
    y += 0.5 * bold.line();
    for line in Label::wrapped(&subtitle(report), small, width) {
        figure.text([MARGIN, y + 0.5 * small.line()], &line, small, Anchor::Left);
        y += small.line();
    }
    y += 1.0;
    let entries = legend(report);
    draw_legend(&mut figure, &entries, [MARGIN, y], width);
    y += legend_height(&entries, width);
    let charts = [ErrorAxis::Time, ErrorAxis::Unknowns].map(|against| chart(report, against));
    let errors = charts[0].axis(1);
    let half = 0.5 * (width - GAP);
    for (k, mut chart) in charts.into_iter().enumerate() {
        let x = chart.axis(0);
        if floor(report).is_none() {
            let middle = |axis: &Axis| 10f64.powf(0.5 * (axis.low + axis.high));
            chart.notes.push(Note {
                at: [middle(&x), middle(&errors)],
                label: Label::plain("one level only: no error is known"),
                colour: INK,
            });
        }
        let left = MARGIN + (half + GAP) * k as f64;
        let errors = Axis { name: chart.y.0.clone(), ..errors.clone() };
        chart.draw_over(&mut figure, [left, y, half, HEIGHT], x, errors);
    }
    y += HEIGHT + GAP;
    if let Some(marked) = &study.mesh {
        y += error_map::draw(&mut figure, marked, report, [MARGIN, y, width, 0.0]) + MARGIN;
    }
    figure.set_height(y);
    figure
}
