//! A figure as SVG, whose unit is a millimetre. Attributes stand in the order of the alphabet.

use crate::figure::Primitive;
use crate::text::{Style, Weight};
use crate::{Anchor, Figure, Label, Letters, POINT, Rectangle, Stroke, WHITE};

/// Typefaces, the first that the viewer has.
const TYPEFACES: &str = "Noto Sans, Helvetica, Arial, sans-serif";

impl Figure {
    /// The sheet as SVG.
    pub fn to_svg(&self) -> String {
        let [width, height] = self.size.map(length);
        let [title, description] = [&self.title, &self.description].map(|text| escaped(&Label::plain(text).text()));
        let mut body = String::new();
        append(&self.primitives, &format!("clip-{:08x}", self.key()), &mut 0, &mut body);
        format!(
            "<svg font-family=\"{TYPEFACES}\" height=\"{height}mm\" role=\"img\" viewBox=\"0 0 {width} {height}\" width=\"{width}mm\" \
             xmlns=\"http://www.w3.org/2000/svg\">\n<title>\n{title}\n</title>\n<desc>\n{description}\n</desc>\n\
             <rect fill=\"{}\" height=\"{height}\" width=\"{width}\"/>\n{body}</svg>\n",
            WHITE.hex()
        )
    }

    /// Tells the names within this sheet from those of others on the same page.
    fn key(&self) -> u32 {
        let letters = self.title.bytes().chain(self.description.bytes());
        letters.fold(0x811c_9dc5, |key, letter| (key ^ u32::from(letter)).wrapping_mul(0x0100_0193))
    }
}

/// Appends an element a line; `clips` counts the rectangles, which `key` and their number name.
fn append(primitives: &[Primitive], key: &str, clips: &mut u32, svg: &mut String) {
    for primitive in primitives {
        let element = match primitive {
            Primitive::Lines(lines, pen) => {
                let cap = match pen.stroke {
                    Stroke::Dotted => " stroke-linecap=\"round\"",
                    _ => "",
                };
                let dashes = pen.dashes().map(|dashes| dashes.map(length).join(" "));
                let dashes = dashes.map_or(String::new(), |dashes| format!(" stroke-dasharray=\"{dashes}\""));
                format!(
                    "<path d=\"{}\" fill=\"none\" stroke=\"{}\"{dashes}{cap} stroke-linejoin=\"round\" stroke-width=\"{}\"/>\n",
                    lines.to_svg(),
                    pen.colour.hex(),
                    length(pen.breadth())
                )
            }
            Primitive::Area(rims, colour) => format!("<path d=\"{}\" fill=\"{}\"/>\n", rims.to_svg(), colour.hex()),
            Primitive::Disc([x, y], radius, fill, rim) => {
                let [x, y, radius, width] = [*x, *y, *radius, rim.breadth()].map(length);
                let [fill, rim] = [fill, &rim.colour].map(|colour| colour.hex());
                format!(
                    "<circle cx=\"{x}\" cy=\"{y}\" fill=\"{fill}\" r=\"{radius}\" stroke=\"{rim}\" stroke-width=\"{width}\"/>\n"
                )
            }
            Primitive::Text(at, label, letters, anchor) => text(*at, label, *letters, *anchor),
            Primitive::Clipped(rectangle, within) => {
                *clips += 1;
                let name = format!("{key}-{clips}");
                *svg += &clip_path(&name, *rectangle);
                append(within, key, clips, svg);
                "</g>\n".to_owned()
            }
        };
        svg.push_str(&element);
    }
}

fn clip_path(name: &str, rectangle: Rectangle) -> String {
    let [x, y, width, height] = rectangle.map(length);
    format!(
        "<clipPath id=\"{name}\">\n<rect height=\"{height}\" width=\"{width}\" x=\"{x}\" y=\"{y}\"/>\n</clipPath>\n\
         <g clip-path=\"url(#{name})\">\n"
    )
}

/// A label, below it its halo.
fn text([x, y]: [f64; 2], label: &Label, letters: Letters, anchor: Anchor) -> String {
    let drop = 0.5 * letters.capital();
    let alignment = match anchor {
        Anchor::Left => "",
        Anchor::Centre | Anchor::Upright => " text-anchor=\"middle\"",
        Anchor::Right => " text-anchor=\"end\"",
    };
    let place = match anchor {
        Anchor::Upright => format!(" transform=\"translate({} {})rotate(-90)\"", length(x + drop), length(y)),
        _ => format!(" x=\"{}\" y=\"{}\"", length(x), length(y + drop)),
    };
    let weight = match letters.weight {
        Weight::Usual => "",
        Weight::Bold => " font-weight=\"bold\"",
    };
    let (fill, size) = (letters.colour.hex(), length(POINT * letters.size));
    let element = |hidden: &str, stroke: &str| {
        format!(
            "<text{hidden} fill=\"{fill}\" font-size=\"{size}\"{weight}{stroke}{alignment}{place}>\n{}\n</text>\n",
            content(label, letters)
        )
    };
    let halo = || {
        let (colour, width) = (WHITE.hex(), length(letters.halo));
        let stroke = format!(" stroke=\"{colour}\" stroke-linejoin=\"round\" stroke-width=\"{width}\"");
        element(" aria-hidden=\"true\"", &stroke)
    };
    (letters.halo > 0.0).then(halo).unwrap_or_default() + &element("", "")
}

/// The parts of a label.
fn content(label: &Label, letters: Letters) -> String {
    let mut svg = String::new();
    let mut raised = 0.0;
    for (style, text) in label.parts() {
        let mut attributes = String::new();
        let wanted = style.raised(letters);
        if wanted != raised {
            attributes += &format!(" dy=\"{:.2}\"", raised - wanted);
        }
        raised = wanted;
        match style {
            Style::Upright => {}
            Style::Italic => attributes += " font-style=\"italic\"",
            Style::Lowered | Style::Raised => attributes += &format!(" font-size=\"{:.3}\"", style.size(letters)),
        }
        svg += &match attributes.is_empty() {
            true => escaped(text),
            false => format!("<tspan{attributes}>{}</tspan>", escaped(text)),
        };
    }
    svg
}

fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;")
}

/// A length as an attribute, to a thousandth of a millimetre.
fn length(value: f64) -> String {
    let text = format!("{value:.3}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text == "-0" { "0".to_owned() } else { text.to_owned() }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{INK, Mark, Pen, SMALLEST_LETTERS};

    #[test]
    fn a_sheet_states_its_size_title_and_description() {
        let draw = || {
            let mut figure = Figure::new([85.0, 40.5], "A <title>", "what \"it\" & that show");
            figure.clipped([1.0, 1.0, 10.0, 10.0], |figure| {
                figure.line(&[[0.0, 0.0], [20.0, 20.0]], Pen::new(0.5, INK).stroked(Stroke::Dashed))
            });
            figure.mark([5.0, 5.0], Mark::Disc, INK);
            let letters = Letters::default().with_halo().bold();
            figure.text([3.0, 3.0], &"a".into(), letters, Anchor::Upright);
            figure.to_svg()
        };
        let svg = draw();
        for part in [
            "width=\"85mm\"",
            "height=\"40.5mm\"",
            "viewBox=\"0 0 85 40.5\"",
            "A &lt;title&gt;",
            "what \"it\" &amp; that show",
            "<g clip-path=\"url(#clip-",
            "stroke-dasharray=\"1.5 1\"",
            "<circle cx=\"5\"",
            "font-weight=\"bold\" stroke=\"#ffffff\"",
            "role=\"img\"",
        ] {
            assert!(svg.contains(part), "no {part} in\n{svg}");
        }
        assert_eq!(svg, draw());
    }

    #[test]
    fn marks_of_labels_become_styles() {
        let label = Label::marked("pressure *p*_{max}, 10^{3} Pa & a_b");
        assert_eq!(label.text(), "pressure pmax, 103 Pa & a_b");
        let svg = content(&label, Letters::default());
        for part in ["<tspan font-style=\"italic\">p</tspan>", ">max</tspan>", "&amp; a_b"] {
            assert!(svg.contains(part), "{svg}");
        }
        assert_eq!(content(&Label::plain("a *b* \u{1b}"), Letters::default()), "a *b* ");
        let small = content(&Label::marked("*p*_{max}"), Letters::sized(7.0));
        assert!(small.contains(&format!("font-size=\"{:.3}\"", SMALLEST_LETTERS * POINT)), "{small}");
    }

    #[test]
    fn lengths_are_short() {
        assert_eq!([1.0, -0.0001, 0.25].map(length), ["1", "0", "0.25"]);
    }
}
