//! Curves with marks and error bars over two axes, and several such charts on one sheet with one legend.

use crate::{
    Anchor, Axis, Colour, Figure, GREY, GRID, LETTERS, Label, LegendEntry, Letters, Mark, Pen, PlotFrame, Rectangle,
    SMALLEST_LETTERS, Scale, Stroke, draw_legend, legend_height,
};

/// Height of a chart over its width, and between charts [mm].
const ASPECT: f64 = 0.68;
const GAP: f64 = 5.0;
/// Margin around the sheet [mm].
const MARGIN: f64 = 1.0;
/// Half of the cross-stroke of an error bar [mm].
const CROSS: f64 = 0.7;

/// Points that belong together.
#[derive(Debug, Clone, PartialEq)]
pub struct Series {
    /// What it is; empty: not in the legend. Series of one name share an entry.
    pub name: Label,
    /// Colour of the series.
    pub colour: Colour,
    /// The line through its points, where there is one. It breaks where a coordinate is no number.
    pub stroke: Option<Stroke>,
    /// The mark at each point, where there is one.
    pub mark: Option<Mark>,
    /// Points of the series, x and y.
    pub points: Vec<[f64; 2]>,
    /// Half lengths of the error bars in y, one for each point; none at all where it is empty, none of a point where it
    /// is no number.
    pub bars: Vec<f64>,
}

impl Series {
    /// A line without marks.
    pub fn line(name: &str, colour: Colour, points: Vec<[f64; 2]>) -> Self {
        Self { name: Label::plain(name), colour, stroke: Some(Stroke::Solid), mark: None, points, bars: Vec::new() }
    }

    /// Marks without a line.
    pub fn marks(name: &str, colour: Colour, mark: Mark, points: Vec<[f64; 2]>) -> Self {
        Self { stroke: None, mark: Some(mark), ..Self::line(name, colour, points) }
    }

    /// The series drawn with this stroke.
    #[must_use]
    pub fn stroked(self, stroke: Stroke) -> Self {
        Self { stroke: Some(stroke), ..self }
    }

    /// The series drawn with this mark at each point.
    #[must_use]
    pub fn marked(self, mark: Mark) -> Self {
        Self { mark: Some(mark), ..self }
    }

    fn entry(&self) -> LegendEntry {
        LegendEntry { name: self.name.clone(), colour: self.colour, stroke: self.stroke, mark: self.mark, area: None }
    }
}

/// A level band behind the curves, from one value upwards to another, and what it means.
#[derive(Debug, Clone, PartialEq)]
pub struct Band {
    /// The lower value; minus infinity: the end of the axis.
    pub low: f64,
    /// The upper value.
    pub high: f64,
    /// What it means.
    pub note: Label,
}

/// A label at a point.
#[derive(Debug, Clone, PartialEq)]
pub struct Note {
    /// The point.
    pub at: [f64; 2],
    /// The label.
    pub label: Label,
    /// Colour of the note.
    pub colour: Colour,
}

/// A filled rectangle behind the curves, between two values of each axis.
#[derive(Debug, Clone, PartialEq)]
pub struct FilledBlock {
    /// Both ends across.
    pub across: [f64; 2],
    /// Both ends upwards, the lower one first.
    pub upwards: [f64; 2],
    /// The colour that fills it.
    pub colour: Colour,
}

/// What kind of picture a chart is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ChartKind {
    /// Curves over axes.
    Curves,
    /// A drawing: no axes, and equal lengths both ways.
    Drawing,
}

/// Series over two axes.
#[derive(Debug, Clone, PartialEq)]
pub struct Chart {
    /// What is shown.
    pub title: Label,
    /// Name and scale of the axis across.
    pub x: (Label, Scale),
    /// Name and scale of the axis upwards.
    pub y: (Label, Scale),
    /// Names of the values 0, 1, 2 ... of the axis upwards, where it has rows instead of numbers.
    pub rows: Vec<Label>,
    /// Filled rectangles.
    pub blocks: Vec<FilledBlock>,
    /// What kind of picture it is.
    pub kind: ChartKind,
    /// Bands drawn behind the curves.
    pub bands: Vec<Band>,
    /// What is drawn, the uppermost last.
    pub series: Vec<Series>,
    /// Labels above the curves.
    pub notes: Vec<Note>,
}

impl Chart {
    /// An empty chart over linear axes.
    pub fn new(title: &str, x: Label, y: Label) -> Self {
        Self {
            title: Label::plain(title),
            x: (x, Scale::Linear),
            y: (y, Scale::Linear),
            rows: Vec::new(),
            blocks: Vec::new(),
            kind: ChartKind::Curves,
            bands: Vec::new(),
            series: Vec::new(),
            notes: Vec::new(),
        }
    }

    /// Entries of a legend: the first series of each name.
    pub fn entries(&self) -> Vec<LegendEntry> {
        entries(std::slice::from_ref(self))
    }

    fn values(&self, axis: usize) -> impl Iterator<Item = f64> {
        let ends = move |series: &Series| -> Vec<f64> {
            let bar = |k: usize| series.bars.get(k).copied().filter(|bar| axis == 1 && bar.is_finite()).unwrap_or(0.0);
            let points = series.points.iter().enumerate();
            points.flat_map(|(k, point)| [point[axis] - bar(k), point[axis] + bar(k)]).collect()
        };
        let notes = self.notes.iter().map(move |note| note.at[axis]);
        self.series
            .iter()
            .flat_map(ends)
            .chain(notes.filter(|_| self.kind == ChartKind::Drawing))
            .chain(self.blocks.iter().flat_map(|block| if axis == 0 { block.across } else { block.upwards }))
            .collect::<Vec<_>>()
            .into_iter()
    }

    /// The axis on which all points find room.
    pub fn axis(&self, axis: usize) -> Axis {
        if axis == 1 && !self.rows.is_empty() {
            return Axis::of_rows(&self.rows);
        }
        let (name, scale) = if axis == 0 { &self.x } else { &self.y };
        Axis::around(self.values(axis), *scale, name.clone())
    }

    /// Draws the chart, its title above it, into a rectangle, over its own axes.
    pub fn draw(&self, figure: &mut Figure, outer: Rectangle) {
        self.draw_over(figure, outer, self.axis(0), self.axis(1));
    }

    /// Draws the chart over given axes.
    pub fn draw_over(&self, figure: &mut Figure, [left, top, width, height]: Rectangle, x: Axis, y: Axis) {
        let line = if self.title.is_empty() {
            0.5 * Letters::sized(SMALLEST_LETTERS).capital()
        } else {
            1.3 * Letters::default().line()
        };
        let outer = [left, top + line, width, height - line];
        let frame = match self.kind {
            ChartKind::Curves => PlotFrame::within(outer, x, y),
            ChartKind::Drawing => {
                let scale = f64::max(x.extent() / outer[2], y.extent() / outer[3]);
                let (x, y) = (x.widened(scale * outer[2]), y.widened(scale * outer[3]));
                PlotFrame { inner: outer, x, y }
            }
        };
        figure.text([frame.inner[0], top + 0.45 * line], &self.title, Letters::default().bold(), Anchor::Left);
        if self.kind == ChartKind::Curves {
            self.bands.iter().for_each(|band| draw_band(figure, &frame, band));
            frame.draw_grid(figure);
            self.bands.iter().for_each(|band| draw_note_of(figure, &frame, band));
        }
        figure.clipped(with_room(frame.inner), |figure| {
            self.blocks.iter().for_each(|block| draw_block(figure, &frame, block));
            self.series.iter().for_each(|series| draw_series(figure, &frame, series));
        });
        for note in &self.notes {
            let letters = Letters::sized(SMALLEST_LETTERS).coloured(note.colour).with_halo();
            figure.text(frame.at(note.at), &note.label, letters, Anchor::Centre);
        }
        if self.kind == ChartKind::Curves {
            frame.draw(figure);
        }
    }
}

/// Marks at the frame are whole.
fn with_room([left, top, width, height]: Rectangle) -> Rectangle {
    [left - 1.3, top - 1.3, width + 2.6, height + 2.6]
}

fn draw_band(figure: &mut Figure, frame: &PlotFrame, band: &Band) {
    if let Some([high, low]) = extent(frame, band) {
        let [left, _, width, _] = frame.inner;
        figure.rectangle([left, high, width, low - high], GRID);
    }
}

fn draw_block(figure: &mut Figure, frame: &PlotFrame, block: &FilledBlock) {
    let [one, other] = [0, 1].map(|end| frame.at([block.across[end], block.upwards[end]]));
    let (left, width) = (one[0].min(other[0]), (other[0] - one[0]).abs());
    figure.rectangle([left, other[1], width, one[1] - other[1]], block.colour);
}

/// What a band means, where it has room for that.
fn draw_note_of(figure: &mut Figure, frame: &PlotFrame, band: &Band) {
    let letters = Letters::sized(SMALLEST_LETTERS).coloured(GREY);
    let fits =
        |[high, low]: &[f64; 2]| low - high > 1.2 * letters.line() && band.note.width(letters) < frame.inner[2] - 3.0;
    if let Some([high, low]) = extent(frame, band).filter(fits) {
        let width = band.note.width(letters);
        let y = low - 0.7 * letters.line();
        // Above the lines of the grid.
        figure.rectangle(
            [frame.inner[0] + 1.0, f64::max(y - 0.5 * letters.line(), high), width + 1.0, 0.9 * letters.line()],
            GRID,
        );
        figure.text([frame.inner[0] + 1.5, y], &band.note, letters, Anchor::Left);
    }
}

/// The upper and the lower end of a band on the sheet [mm], where it is within the frame.
fn extent(frame: &PlotFrame, band: &Band) -> Option<[f64; 2]> {
    let [_, top, _, height] = frame.inner;
    let place = |value: f64| frame.at([1.0, value])[1].clamp(top, top + height);
    let high = place(band.high);
    let low = if band.low.is_finite() { place(band.low) } else { top + height };
    (low > high).then_some([high, low])
}

fn draw_series(figure: &mut Figure, frame: &PlotFrame, series: &Series) {
    let points: Vec<[f64; 2]> = series.points.iter().map(|point| frame.at(*point)).collect();
    let is_finite = |point: &[f64; 2]| point.iter().all(|part| part.is_finite());
    let bars = series
        .points
        .iter()
        .zip(&series.bars)
        .filter(|(point, bar)| is_finite(point) && bar.is_finite() && **bar > 0.0);
    let bars: Vec<_> = bars
        .map(|([x, y], bar)| [frame.at([*x, y - bar]), frame.at([*x, y + bar])])
        .filter(|[low, high]| is_finite(high) && is_finite(low))
        .flat_map(|[low, high]| {
            let cross = |[x, y]: [f64; 2]| [[x - CROSS, y], [x + CROSS, y]];
            [[low, high], cross(low), cross(high)]
        })
        .collect();
    if !bars.is_empty() {
        figure.lines(bars, Pen::new(0.7, series.colour));
    }
    if let Some(stroke) = series.stroke {
        let lines = points.split(|point| !is_finite(point)).filter(|line| line.len() > 1);
        let lines: Vec<Vec<[f64; 2]>> = lines.map(<[_]>::to_vec).collect();
        if !lines.is_empty() {
            figure.lines(lines, Pen::new(1.0, series.colour).stroked(stroke));
        }
    }
    if let Some(mark) = series.mark {
        points.iter().filter(|point| is_finite(point)).for_each(|&point| figure.mark(point, mark, series.colour));
    }
}

/// The first series of each name.
fn entries(charts: &[Chart]) -> Vec<LegendEntry> {
    let mut entries: Vec<LegendEntry> = Vec::new();
    for series in charts.iter().flat_map(|chart| &chart.series) {
        if !series.name.is_empty() && entries.iter().all(|entry| entry.name != series.name) {
            entries.push(series.entry());
        }
    }
    entries
}

/// Charts beside and below each other on a sheet of that width [mm], `columns` in a row, with a title and one legend.
pub fn charts_figure(title: &str, charts: &[Chart], columns: usize, width: f64) -> Figure {
    let columns = columns.clamp(1, charts.len().max(1));
    let inner = width - 2.0 * MARGIN;
    let each = (inner - GAP * (columns - 1) as f64) / columns as f64;
    let height = ASPECT * each + 8.0;
    let rows = charts.len().div_ceil(columns);
    let bold = Letters::sized(LETTERS + 1.0).bold();
    let head = MARGIN + bold.line() + 1.0;
    let below = head + (height + GAP) * rows as f64;
    let legend = entries(charts);
    let names: Vec<String> = charts.iter().map(|chart| chart.title.text()).collect();
    let size = [width, below + legend_height(&legend, inner) + MARGIN];
    let mut figure = Figure::new(size, title, &names.join("; "));
    figure.text([MARGIN, MARGIN + 0.5 * bold.line()], &Label::fitted(title, bold, inner), bold, Anchor::Left);
    for (k, chart) in charts.iter().enumerate() {
        let left = MARGIN + (each + GAP) * (k % columns) as f64;
        let top = head + (height + GAP) * (k / columns) as f64;
        chart.draw(&mut figure, [left, top, each, height]);
    }
    draw_legend(&mut figure, &legend, [MARGIN, below - 0.4 * GAP], inner);
    figure
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{BLUE, PAGE_WIDTH};

    #[test]
    fn charts_have_titles_axes_numbers_bars_and_one_legend() {
        let points = vec![[1100.0, 0.05], [f64::NAN, 0.0], [1500.0, 0.1], [3200.0, 0.32]];
        let mut chart = Chart::new("flow & power", Label::marked("speed *n*, 1/min"), "q".into());
        chart.series = vec![
            Series {
                bars: vec![0.02, 0.01, f64::NAN, 0.05],
                ..Series::line("right", BLUE, points.clone()).marked(Mark::Disc)
            },
            Series::marks("printed", BLUE, Mark::Ring, points),
        ];
        chart.bands = vec![Band { low: f64::NEG_INFINITY, high: 0.1, note: "noise".into() }];
        let circle = (0..=36).map(|k| f64::from(10 * k).to_radians()).map(|phi| [10.0 * phi.cos(), 30.0 * phi.sin()]);
        let mut drawing = Chart::new("liner", Label::default(), Label::default());
        drawing.kind = ChartKind::Drawing;
        drawing.series = vec![Series::line("right", BLUE, circle.collect()).stroked(Stroke::Dashed)];
        drawing.notes = vec![Note { at: [0.0, 0.0], label: "O".into(), colour: BLUE }];
        let figure = charts_figure("Two charts", &[chart, drawing], 2, PAGE_WIDTH);
        let svg = figure.to_svg();
        for part in ["flow &amp; power", "3000", "0.3", ">\nprinted\n<", "noise", "liner", "width=\"170mm\""] {
            assert!(svg.contains(part), "no {part} in\n{svg}");
        }
        assert_eq!(svg.matches("\nright\n").count(), 1);
        assert!(figure.to_png().is_ok());
        assert!(charts_figure("none", &[], 3, PAGE_WIDTH).to_png().is_ok());
    }
}
