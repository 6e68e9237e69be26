//! A drawing as a picture of dots. The letters are those of Noto Sans, which the program carries, so the picture is the same
//! on every machine.

use std::sync::Arc;

use resvg::tiny_skia::{Pixmap, Transform};
use resvg::usvg::{Options, Tree, fontdb};

use crate::Error;

/// Dots in a point of the drawing.
const DOTS: f32 = 1.6;

/// The PNG of an SVG.
///
/// # Errors
/// [`Error::Format`]: the text is no drawing, or it is too large.
pub fn to_png(svg: &str) -> Result<Vec<u8>, Error> {
    let mut fonts = fontdb::Database::new();
    for font in [notosans::REGULAR_TTF, notosans::BOLD_TTF] {
        fonts.load_font_source(fontdb::Source::Binary(Arc::new(font)));
    }
    fonts.set_sans_serif_family("Noto Sans");
    let options = Options {
        fontdb: Arc::new(fonts),
        ..Options::default()
    };
    let tree = Tree::from_str(svg, &options).map_err(Error::format("PNG"))?;
    let size = tree.size();
    let dots = |points: f32| (DOTS * points).ceil() as u32;
    let mut picture = Pixmap::new(dots(size.width()), dots(size.height()))
        .ok_or_else(|| Error::format("PNG")(format!("no picture of {} by {} points", size.width(), size.height())))?;
    resvg::render(&tree, Transform::from_scale(DOTS, DOTS), &mut picture.as_mut());
    picture.encode_png().map_err(Error::format("PNG"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_drawing_becomes_dots_with_letters_but_no_fonts_of_the_system() {
        let svg =
            |inner: &str| format!("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"40\" height=\"20\">{inner}</svg>");
        let text = to_png(&svg(
            "<text x=\"2\" y=\"15\" font-family=\"Helvetica, sans-serif\">10\u{2212}3</text>",
        ));
        let (text, empty) = (text.expect("a drawing"), to_png(&svg("")).expect("a drawing"));
        assert!(text.starts_with(b"\x89PNG\r\n\x1a\n") && text.len() > empty.len());
        assert!(matches!(to_png("no drawing"), Err(Error::Format { .. })));
    }
}
