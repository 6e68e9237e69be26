//! Colours that the colour-blind can distinguish.

use plotters::style::RGBColor;

use oilwedge_campaign::convergence::Strategy;

/// Text and frames.
pub(super) const INK: RGBColor = RGBColor(38, 38, 38);
/// Lesser text.
pub(super) const GREY: RGBColor = RGBColor(110, 110, 110);
/// Lines of the grid.
pub(super) const GRID: RGBColor = RGBColor(222, 222, 222);
/// Lines of the grid within decades.
pub(super) const FINE_GRID: RGBColor = RGBColor(241, 241, 241);
/// Where errors mean nothing.
pub(super) const BAND: RGBColor = RGBColor(232, 232, 232);
/// Edges of triangles.
pub(super) const EDGE: RGBColor = RGBColor(90, 100, 110);

/// Colour of a strategy, of the palette of M. Okabe and K. Ito, Color Universal Design (2008).
pub(super) fn of_strategy(strategy: Strategy) -> RGBColor {
    match strategy {
        Strategy::P1Uniform => RGBColor(213, 94, 0),
        Strategy::P2Uniform => RGBColor(0, 114, 178),
        Strategy::P2Adaptive => RGBColor(0, 158, 115),
    }
}

/// YlGnBu of C. Brewer (colorbrewer2.org), from light to dark.
const SEQUENCE: [[f64; 3]; 9] = [
    [255.0, 255.0, 217.0],
    [237.0, 248.0, 177.0],
    [199.0, 233.0, 180.0],
    [127.0, 205.0, 187.0],
    [65.0, 182.0, 196.0],
    [29.0, 145.0, 192.0],
    [34.0, 94.0, 168.0],
    [37.0, 52.0, 148.0],
    [8.0, 29.0, 88.0],
];

/// Colour of a share from 0 (light) to 1 (dark); others count as the nearer of these, what is no number as 0.
pub(super) fn of_share(share: f64) -> RGBColor {
    let place = if share.is_nan() { 0.0 } else { share.clamp(0.0, 1.0) } * (SEQUENCE.len() - 1) as f64;
    let lower = (place as usize).min(SEQUENCE.len() - 2);
    let part = place - lower as f64;
    let [r, g, b] = [0, 1, 2].map(|k| {
        let mixed = SEQUENCE[lower][k] + part * (SEQUENCE[lower + 1][k] - SEQUENCE[lower][k]);
        mixed.round() as u8
    });
    RGBColor(r, g, b)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shares_run_from_light_to_dark() {
        let light = |share: f64| {
            let RGBColor(r, g, b) = of_share(share);
            u32::from(r) + u32::from(g) + u32::from(b)
        };
        assert!((0..20).all(|k| light(f64::from(k) / 20.0) > light(f64::from(k + 1) / 20.0)));
        assert_eq!(light(f64::NAN), light(0.0));
        assert_eq!(light(7.0), light(1.0));
    }
}
