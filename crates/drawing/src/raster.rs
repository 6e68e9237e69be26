//! A figure as dots. The letters are those of Noto Sans, which the program carries, so the picture is the same on every machine.

use std::sync::{Arc, OnceLock};

use resvg::tiny_skia::{Color, Pixmap, Transform};
use resvg::usvg::{Options, Tree, fontdb};

use crate::DOTS_PER_INCH;

/// Why a figure has no dots.
#[derive(Debug, thiserror::Error)]
#[error("{0}")]
pub struct Error(String);

fn fonts() -> Arc<fontdb::Database> {
    static FONTS: OnceLock<Arc<fontdb::Database>> = OnceLock::new();
    FONTS
        .get_or_init(|| {
            let mut fonts = fontdb::Database::new();
            for font in [notosans::REGULAR_TTF, notosans::BOLD_TTF, notosans::ITALIC_TTF] {
                fonts.load_font_source(fontdb::Source::Binary(Arc::new(font)));
            }
            fonts.set_sans_serif_family("Noto Sans");
            Arc::new(fonts)
        })
        .clone()
}

/// The tree of a figure, whose lengths are points of 1/96 of an inch.
fn tree(svg: &str) -> Result<Tree, Error> {
    let options = Options {
        fontdb: fonts(),
        ..Options::default()
    };
    Tree::from_str(svg, &options).map_err(|error| Error(error.to_string()))
}

/// The PNG of an SVG at [`DOTS_PER_INCH`], which the file states.
///
/// # Errors
/// [`Error`]: the text is no drawing, or it is too large.
pub fn to_png(svg: &str) -> Result<Vec<u8>, Error> {
    let tree = tree(svg)?;
    let scale = (DOTS_PER_INCH / 96.0) as f32;
    let [width, height] =
        [tree.size().width(), tree.size().height()].map(|length| (scale * length).round().max(1.0) as u32);
    let mut picture =
        Pixmap::new(width, height).ok_or_else(|| Error(format!("no picture of {width} by {height} dots")))?;
    picture.fill(Color::WHITE);
    resvg::render(&tree, Transform::from_scale(scale, scale), &mut picture.as_mut());
    let colours: Vec<u8> = picture
        .pixels()
        .iter()
        .flat_map(|dot| [dot.red(), dot.green(), dot.blue()])
        .collect();
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, width, height);
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_depth(png::BitDepth::Eight);
    let per_metre = (DOTS_PER_INCH / 0.0254).round() as u32;
    encoder.set_pixel_dims(Some(png::PixelDimensions {
        xppu: per_metre,
        yppu: per_metre,
        unit: png::Unit::Meter,
    }));
    let failed = |error: png::EncodingError| Error(error.to_string());
    let mut writer = encoder.write_header().map_err(failed)?;
    writer.write_image_data(&colours).map_err(failed)?;
    writer.finish().map_err(failed)?;
    Ok(bytes)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Anchor, Figure, Label, Letters};

    #[test]
    fn a_figure_becomes_dots_of_its_size() {
        let mut figure = Figure::new([25.4, 12.7], "t", "d");
        let empty = to_png(&figure.to_svg()).expect("a drawing");
        figure.text(
            [3.0, 5.0],
            &Label::marked("10^{\u{2212}3} *p*"),
            Letters::default(),
            Anchor::Left,
        );
        let text = to_png(&figure.to_svg()).expect("a drawing");
        assert!(text.starts_with(b"\x89PNG\r\n\x1a\n") && text.len() > empty.len());
        let number = |place: usize| u32::from_be_bytes([0, 1, 2, 3].map(|k| text[place + k]));
        assert_eq!([number(16), number(20)], [300, 150]);
        let place = text.windows(4).position(|part| part == b"pHYs").expect("a size");
        assert_eq!(number(place + 4), 11811);
        assert!(to_png("no drawing").is_err());
    }

    /// The box of the first text, without the transformation of the sheet into points.
    fn text_in(group: &resvg::usvg::Group) -> Option<resvg::tiny_skia::Rect> {
        use resvg::usvg::Node;
        group.children().iter().find_map(|node| match node {
            Node::Group(inner) => text_in(inner),
            Node::Text(text) => Some(text.abs_bounding_box()),
            _ => None,
        })
    }

    #[test]
    fn widths_of_labels_are_those_of_the_typeface() {
        for words in ["film thickness h, um", "Pressure 0.25", "WWWW iiii"] {
            let mut figure = Figure::new([100.0, 10.0], "t", "d");
            figure.text([10.0, 5.0], &words.into(), Letters::default(), Anchor::Left);
            let tree = tree(&figure.to_svg()).expect("a drawing");
            let width = f64::from(text_in(tree.root()).expect("a text").width()) * 25.4 / 96.0;
            let told = Label::from(words).width(Letters::default());
            assert!((width / told - 1.0).abs() < 0.08, "{words}: {width} {told}");
        }
    }
}
