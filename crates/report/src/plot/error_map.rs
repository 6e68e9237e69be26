//! The adaptive mesh of a convergence study, coloured by where the error comes from.

use oilwedge_campaign::convergence::{ConvergenceReport, MarkedMesh};
use oilwedge_drawing::{
    Anchor, Axis, Colour, ColourMap, Figure, Label, Letters, Levels, Pen, Rectangle, SMALLEST_LETTERS, Scale,
    draw_bands, draw_colour_bar, draw_mesh,
};

use super::liner::{LinerWindow, TriangleNodes};

/// Decades that the colours span, bands in a decade, and room for their bar [mm].
pub(super) const MOST_DECADES: f64 = 5.0;
const BANDS: f64 = 4.0;
const BAR: f64 = 16.0;
/// Sides of triangles.
const SIDES: Colour = Colour([110, 118, 126]);
/// Colour where nothing is known of the error.
const UNKNOWN: Colour = Colour([225, 236, 242]);

/// Exponents of ten of the contributions of triangles, their range, and its bands.
pub(super) struct Decades {
    pub(super) exponents: Vec<f64>,
    pub(super) axis: Axis,
    pub(super) levels: Levels,
}

impl Decades {
    /// The decades of positive contributions over their reference; `None` where none is positive.
    pub(super) fn of(contributions: &[f64], reference: f64) -> Option<Self> {
        let exponent = |share: &f64| (share / reference).abs().log10();
        let exponents: Vec<f64> = contributions.iter().map(exponent).collect();
        let finite = || exponents.iter().copied().filter(|exponent| exponent.is_finite());
        let high = finite().reduce(f64::max)?;
        let low = finite().fold(high, f64::min).max(high - MOST_DECADES).min(high - 1.0);
        let count = (BANDS * (high - low)).ceil() as usize;
        Some(Self {
            exponents: exponents.iter().map(|exponent| if exponent.is_finite() { *exponent } else { low }).collect(),
            axis: Axis::between(low, high, Scale::Powers, Label::default()),
            levels: Levels::even([low, high], ColourMap::Lajolla, count),
        })
    }

    /// Values between bands as the axis counts them.
    pub(super) fn edges(&self) -> Vec<f64> {
        self.levels.edges.iter().map(|edge| 10f64.powf(*edge)).collect()
    }
}

/// Draws the mesh with its axes and the bar of its colours; returns the height of all [mm].
pub(super) fn draw(
    figure: &mut Figure,
    marked: &MarkedMesh,
    report: &ConvergenceReport,
    [left, top, width, _]: Rectangle,
) -> f64 {
    let mesh = &marked.mesh;
    let cells: Vec<TriangleNodes> = (0..mesh.triangles().len()).map(|t| mesh.nodes(t)).collect();
    let liner = LinerWindow::of(&cells, marked.radius, mesh.period(), None);
    let reference = report.reference.as_ref().map(|reference| reference.value.abs());
    let decades = marked.indicator.as_deref().zip(reference);
    let decades = decades.and_then(|(indicator, reference)| Decades::of(indicator, reference));
    let what = match &decades {
        Some(_) => format!("colour: contribution of each to the relative error of the {}", report.goal.name),
        None => "where the error comes from is not estimated".to_owned(),
    };
    let title = format!("Adaptive mesh, level {}: {} triangles; {what}", marked.level, cells.len());
    let letters = Letters::sized(SMALLEST_LETTERS + 0.5);
    figure.text([left, top + 0.5 * letters.line()], &Label::fitted(&title, letters, width), letters, Anchor::Left);
    let below = top + letters.line() + 1.0;
    let frame = liner.frame([left, below, width - BAR, 0.0]);
    let patches = liner.patches(&frame, &cells, |t| match &decades {
        Some(decades) => [decades.exponents[t]; 6],
        None => [0.0; 6],
    });
    let plain = Levels { edges: Vec::new(), colours: vec![UNKNOWN] };
    // The finer the mesh, the finer its lines.
    let pen = Pen::new((12.0 / (cells.len() as f64).sqrt()).clamp(0.1, 0.5), SIDES);
    liner.within(figure, &frame, |figure| {
        draw_bands(figure, &patches, decades.as_ref().map_or(&plain, |decades| &decades.levels));
        draw_mesh(figure, &patches, pen);
    });
    frame.draw(figure);
    if let Some(decades) = &decades {
        draw_colour_bar(figure, frame.inner, &decades.axis, ColourMap::Lajolla, &decades.edges());
    }
    below + frame.inner[3] + frame.bottom_margin() - top
}
