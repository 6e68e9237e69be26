//! Figures for print: the one way in which this program draws. It knows nothing of oil, and depends on no other crate
//! of the house.
//!
//! All lengths on a sheet are millimetres, `x` to the right and `y` downwards. Letters are at least
//! [`SMALLEST_LETTERS`] points high. Every figure has a title and a description for those who cannot see it. The same
//! input gives the same bytes.
//!
//! Reading order: `colour.rs`, [`colour_map`] (tables of colours), `text.rs` (labels and their widths), `figure.rs`
//! (the sheet), `axis.rs` and `frame.rs` (axes), `chart.rs` (curves with error bars), `legend.rs`, `polar.rs`,
//! `cells.rs` (grids of coloured cells), `contour.rs` (filled contours of quadratic fields; `outline.rs` joins their
//! edges), `wires.rs` (meshes); a figure is a list of primitives, which `svg.rs` writes and `raster.rs` draws (PNG).

mod axis;
mod cells;
mod chart;
mod colour;
pub mod colour_map;
mod contour;
mod figure;
mod frame;
mod legend;
mod levels;
mod outline;
mod patch;
mod path;
mod polar;
mod raster;
mod svg;
mod text;
mod wires;

pub use axis::{Axis, Scale, least_and_greatest, linear_steps, number};
pub use cells::{CELL_HEIGHT, CellGrid, ColouredCell};
pub use chart::{Band, Chart, ChartKind, FilledBlock, Note, Series, charts_figure};
pub use colour::{BLACK, BLUE, Colour, GREEN, GREY, GRID, INK, ORANGE, PURPLE, SERIES, SKY, VERMILION, WHITE, YELLOW};
pub use colour_map::ColourMap;
pub use contour::draw_bands;
pub use figure::{Anchor, Figure, Mark, Pen, Rectangle, Stroke};
pub use frame::{PlotFrame, draw_colour_bar};
pub use legend::{LegendEntry, draw_legend, legend_height};
pub use levels::Levels;
pub use patch::Patch;
pub use polar::Polar;
pub use raster::Error;
pub use text::{Label, Letters};
pub use wires::{draw_mesh, joined};

/// A typographic point [mm].
pub const POINT: f64 = 25.4 / 72.0;
/// Height of the smallest letters [points].
pub const SMALLEST_LETTERS: f64 = 7.0;
/// Height of usual letters [points].
pub const LETTERS: f64 = 8.0;
/// Width of a figure over the whole text of a page [mm].
pub const PAGE_WIDTH: f64 = 170.0;
/// Width of a figure in one of two columns [mm].
pub const COLUMN_WIDTH: f64 = 85.0;
/// Dots per inch of a PNG.
pub const DOTS_PER_INCH: f64 = 300.0;
