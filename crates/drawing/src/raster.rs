//! A figure as dots. The letters are those of Noto Sans, which the program carries, so the picture is the same on every
//! machine.

use tiny_skia::{
    Color, FillRule, LineCap, LineJoin, Mask, Paint, Path, PathBuilder, Pixmap, Rect, StrokeDash, Transform,
};
use ttf_parser::OutlineBuilder;

use crate::figure::Primitive;
use crate::path::{End, PARTS, Polylines};
use crate::{Anchor, Colour, DOTS_PER_INCH, Figure, Label, Letters, POINT, Pen, Stroke, WHITE};

/// Why a figure has no dots.
#[derive(Debug, thiserror::Error)]
#[error("{0}")]
pub struct Error(String);

impl Figure {
    /// The sheet as PNG at [`DOTS_PER_INCH`], which the file states.
    ///
    /// # Errors
    /// [`Error`]: the sheet is too large.
    pub fn to_png(&self) -> Result<Vec<u8>, Error> {
        encoded(&self.picture()?).map_err(|error| Error(error.to_string()))
    }

    fn picture(&self) -> Result<Pixmap, Error> {
        let scale = DOTS_PER_INCH / 25.4;
        let [width, height] = self.size.map(|length| (scale * length).round().max(1.0) as u32);
        let mut picture =
            Pixmap::new(width, height).ok_or_else(|| Error(format!("no picture of {width} by {height} dots")))?;
        picture.fill(Color::WHITE);
        let scale = Transform::from_scale(scale as f32, scale as f32);
        draw(&self.primitives, scale, None, &mut picture);
        Ok(picture)
    }
}

/// The PNG of a picture without transparent dots.
fn encoded(picture: &Pixmap) -> Result<Vec<u8>, png::EncodingError> {
    let colours: Vec<u8> = (picture.pixels().iter()).flat_map(|dot| [dot.red(), dot.green(), dot.blue()]).collect();
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, picture.width(), picture.height());
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_depth(png::BitDepth::Eight);
    let per_metre = (DOTS_PER_INCH / 0.0254).round() as u32;
    encoder.set_pixel_dims(Some(png::PixelDimensions { xppu: per_metre, yppu: per_metre, unit: png::Unit::Meter }));
    let mut writer = encoder.write_header()?;
    writer.write_image_data(&colours)?;
    writer.finish()?;
    Ok(bytes)
}

/// Draws within `clip`; `scale` makes dots of millimetres. What has no extent is left out.
fn draw(primitives: &[Primitive], scale: Transform, clip: Option<&Mask>, picture: &mut Pixmap) {
    for primitive in primitives {
        match primitive {
            Primitive::Lines(lines, pen) => {
                if let Some(path) = path(lines) {
                    picture.stroke_path(&path, &paint(pen.colour), &stroke(*pen), scale, clip);
                }
            }
            Primitive::Area(rims, colour) => {
                if let Some(path) = path(rims) {
                    picture.fill_path(&path, &paint(*colour), FillRule::Winding, scale, clip);
                }
            }
            Primitive::Disc([x, y], radius, fill, rim) => {
                if let Some(circle) = PathBuilder::from_circle(*x as f32, *y as f32, *radius as f32) {
                    picture.fill_path(&circle, &paint(*fill), FillRule::Winding, scale, clip);
                    picture.stroke_path(&circle, &paint(rim.colour), &stroke(*rim), scale, clip);
                }
            }
            Primitive::Text(at, label, letters, anchor) => {
                let to_dots = scale.pre_concat(placed(*at, *letters, *anchor));
                if let Some(outlines) = outlines(label, *letters, *anchor) {
                    if letters.halo > 0.0 {
                        let halo = stroke(Pen::new(letters.halo / POINT, WHITE));
                        picture.stroke_path(&outlines, &paint(WHITE), &halo, to_dots, clip);
                    }
                    picture.fill_path(&outlines, &paint(letters.colour), FillRule::Winding, to_dots, clip);
                }
            }
            Primitive::Clipped(rectangle, within) => {
                let [x, y, width, height] = rectangle.map(|part| part as f32);
                let area = Rect::from_xywh(x, y, width, height).map(PathBuilder::from_rect);
                let mask = clip.cloned().or_else(|| Mask::new(picture.width(), picture.height()));
                if let (Some(area), Some(mut mask)) = (area, mask) {
                    match clip {
                        Some(_) => mask.intersect_path(&area, FillRule::Winding, true, scale),
                        None => mask.fill_path(&area, FillRule::Winding, true, scale),
                    }
                    draw(within, scale, Some(&mask), picture);
                }
            }
        }
    }
}

fn paint(colour: Colour) -> Paint<'static> {
    let mut paint = Paint::default();
    let [red, green, blue] = colour.0;
    paint.set_color_rgba8(red, green, blue, 255);
    paint
}

fn stroke(pen: Pen) -> tiny_skia::Stroke {
    let dashes = pen.dashes().map(|dashes| dashes.map(|length| length as f32).to_vec());
    tiny_skia::Stroke {
        width: pen.breadth() as f32,
        line_cap: match pen.stroke {
            Stroke::Dotted => LineCap::Round,
            _ => LineCap::Butt,
        },
        line_join: LineJoin::Round,
        dash: dashes.and_then(|dashes| StrokeDash::new(dashes, 0.0)),
        ..tiny_skia::Stroke::default()
    }
}

fn path(lines: &Polylines) -> Option<Path> {
    let mut path = PathBuilder::new();
    for line in &lines.lines {
        let mut points = line.iter().map(|place| place.map(|part| (f64::from(part) / PARTS) as f32));
        if let Some([x, y]) = points.next() {
            path.move_to(x, y);
        }
        points.for_each(|[x, y]| path.line_to(x, y));
        if lines.end == End::Closed {
            path.close();
        }
    }
    path.finish()
}

/// Transform from the line of a label to the sheet.
fn placed([x, y]: [f64; 2], letters: Letters, anchor: Anchor) -> Transform {
    let drop = 0.5 * letters.capital();
    match anchor {
        Anchor::Upright => Transform::from_translate((x + drop) as f32, y as f32).pre_rotate(-90.0),
        _ => Transform::from_translate(x as f32, (y + drop) as f32),
    }
}

/// The outlines of a label that stands at the origin.
fn outlines(label: &Label, letters: Letters, anchor: Anchor) -> Option<Path> {
    let part = match anchor {
        Anchor::Left => 0.0,
        Anchor::Centre | Anchor::Upright => 0.5,
        Anchor::Right => 1.0,
    };
    let start = -part * label.set(letters, |_, _, _, _| {});
    let mut outlines = PathBuilder::new();
    label.set(letters, |glyph, face, unit, [along, above]| {
        let mut outline = GlyphOutline(PathBuilder::new());
        face.outline_glyph(glyph, &mut outline);
        // The units of a typeface run upwards.
        let [unit, along, above] = [unit, start + along, above].map(|length| length as f32);
        let to_line = Transform::from_row(unit, 0.0, 0.0, -unit, along, -above);
        if let Some(path) = outline.0.finish().and_then(|path| path.transform(to_line)) {
            outlines.push_path(&path);
        }
    });
    outlines.finish()
}

/// The outline of a glyph in the units of its typeface.
struct GlyphOutline(PathBuilder);

impl OutlineBuilder for GlyphOutline {
    fn move_to(&mut self, x: f32, y: f32) {
        self.0.move_to(x, y);
    }

    fn line_to(&mut self, x: f32, y: f32) {
        self.0.line_to(x, y);
    }

    fn quad_to(&mut self, x1: f32, y1: f32, x: f32, y: f32) {
        self.0.quad_to(x1, y1, x, y);
    }

    fn curve_to(&mut self, x1: f32, y1: f32, x2: f32, y2: f32, x: f32, y: f32) {
        self.0.cubic_to(x1, y1, x2, y2, x, y);
    }

    fn close(&mut self) {
        self.0.close();
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{BLUE, INK};

    /// Left, top, right and bottom [mm] of the dots that are not white, and their share of a sheet of 20 by 10 mm.
    fn ink(draw: impl FnOnce(&mut Figure)) -> ([f64; 4], f64) {
        let mut figure = Figure::new([20.0, 10.0], "t", "d");
        draw(&mut figure);
        let picture = figure.picture().expect("dots");
        let (width, all) = (picture.width() as usize, picture.pixels());
        let dark = all.iter().enumerate().filter(|(_, dot)| dot.red() < 128);
        let places = dark.map(|(k, _)| [k % width, k / width].map(|place| place as f64 * 25.4 / DOTS_PER_INCH));
        let bounds = places.fold([f64::MAX, f64::MAX, f64::MIN, f64::MIN], |[left, top, right, bottom], [x, y]| {
            [left.min(x), top.min(y), right.max(x), bottom.max(y)]
        });
        let share = all.iter().map(|dot| 1.0 - f64::from(dot.red()) / 255.0).sum::<f64>() / all.len() as f64;
        (bounds, share * 255.0 / f64::from(255 - INK.0[0]))
    }

    fn text(label: &str, anchor: Anchor) -> [f64; 4] {
        ink(|figure| figure.text([10.0, 5.0], &Label::marked(label), Letters::default(), anchor)).0
    }

    #[test]
    fn a_figure_becomes_dots_of_its_size() {
        let png = Figure::new([25.4, 12.7], "t", "d").to_png().expect("a picture");
        assert!(png.starts_with(b"\x89PNG\r\n\x1a\n"));
        let number = |place: usize| u32::from_be_bytes([0, 1, 2, 3].map(|k| png[place + k]));
        assert_eq!([number(16), number(20)], [300, 150]);
        let place = png.windows(4).position(|part| part == b"pHYs").expect("a size");
        assert_eq!(number(place + 4), 11811);
        assert!(Figure::new([1e9, 1e9], "t", "d").to_png().is_err());
    }

    #[test]
    fn strokes_areas_and_clips_have_their_ink() {
        let line = |stroke: Stroke| {
            let pen = Pen::new(1.0, INK).stroked(stroke);
            ink(|figure| figure.line(&[[0.0, 5.0], [20.0, 5.0]], pen)).1 * 10.0 / pen.breadth()
        };
        // Against the solid line: its width is rounded to quarters of a dot.
        let dot = std::f64::consts::PI / 4.0 / 2.2;
        for (stroke, share) in [(Stroke::Solid, 1.0), (Stroke::Dashed, 0.6), (Stroke::Dotted, dot)] {
            let drawn = line(stroke) / line(Stroke::Solid);
            assert!((drawn - share).abs() < 0.02, "{stroke:?}: {drawn}");
        }
        assert!((line(Stroke::Solid) - 1.0).abs() < 0.05);
        let square = |side: f64| [[5.0, 2.0], [5.0 + side, 2.0], [5.0 + side, 2.0 + side], [5.0, 2.0 + side]];
        let hole = square(3.0).into_iter().rev().collect::<Vec<_>>();
        let (_, share) = ink(|figure| figure.area([square(5.0).to_vec(), hole], INK));
        assert!((share - 16.0 / 200.0).abs() < 1e-3, "{share}");
        let (bounds, share) = ink(|figure| {
            figure.clipped([2.0, 3.0, 6.0, 5.0], |figure| {
                figure.clipped([4.0, 0.0, 9.0, 9.0], |figure| figure.rectangle([0.0, 0.0, 20.0, 10.0], INK));
            });
        });
        assert!((share - 0.1).abs() < 1e-3 && bounds[0] > 3.9 && bounds[3] < 8.1, "{share} {bounds:?}");
        let (_, share) = ink(|figure| figure.disc([10.0, 5.0], 4.0, WHITE, Pen::new(72.0 / 25.4, INK)));
        assert!((share - std::f64::consts::TAU * 4.0 / 200.0).abs() < 2e-3, "{share}");
    }

    #[test]
    fn letters_stand_where_their_anchor_says() {
        let [left, top, right, bottom] = text("HHHH", Anchor::Left);
        let (width, high) = (right - left, Letters::default().capital());
        assert!((left - 10.2).abs() < 0.2 && (top + 0.5 * high - 5.0).abs() < 0.1 && (bottom - top - high).abs() < 0.2);
        let [left, _, right, _] = text("HHHH", Anchor::Centre);
        assert!((left + right - 20.0).abs() < 0.2 && (right - left - width).abs() < 0.1);
        let [_, _, right, _] = text("HHHH", Anchor::Right);
        assert!((right - 9.8).abs() < 0.2, "{right}");
        let [left, top, right, bottom] = text("HHHH", Anchor::Upright);
        assert!((top + bottom - 10.0).abs() < 0.2 && (bottom - top - width).abs() < 0.1);
        assert!((right - left - high).abs() < 0.2 && (left + right - 20.0).abs() < 0.2);
        let [raised, usual, lowered] = ["^{2}", "2", "_{2}"].map(|label| text(label, Anchor::Left));
        assert!(raised[3] < usual[3] - 0.5 && lowered[3] > usual[3] + 0.3);
        assert!((text("*H*", Anchor::Left)[2] - text("H", Anchor::Left)[2]).abs() > 0.05);
    }

    #[test]
    fn letters_without_a_glyph_are_boxes_and_others_have_their_own() {
        let mut seen: Vec<_> =
            ["\u{2212}", "\u{3b5}", "\u{f6}", "\u{b0}", "o"].map(|letter| text(letter, Anchor::Left)).into();
        let [a, b] = ["\u{4e2d}", "\u{1f600}"].map(|letter| text(letter, Anchor::Left));
        assert!(a == b && a[2] > 10.5, "{a:?} {b:?}");
        seen.push(a);
        assert!((1..seen.len()).all(|k| !seen[..k].contains(&seen[k])), "{seen:?}");
    }

    #[test]
    fn a_halo_parts_letters_from_what_is_below() {
        let blue = |halo: bool| {
            let letters = if halo { Letters::default().with_halo() } else { Letters::default() };
            let mut figure = Figure::new([20.0, 10.0], "t", "d");
            figure.rectangle([0.0, 0.0, 20.0, 10.0], BLUE);
            figure.text([10.0, 5.0], &"H".into(), letters, Anchor::Centre);
            let picture = figure.picture().expect("dots");
            picture.pixels().iter().filter(|dot| [dot.red(), dot.green(), dot.blue()] == BLUE.0).count()
        };
        assert!(blue(true) < blue(false) - 100 && blue(true) > 20_000, "{} {}", blue(true), blue(false));
    }
}
