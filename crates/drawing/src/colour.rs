//! Colours.

/// A colour: red, green, blue, each from 0 to 255.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Colour(pub [u8; 3]);

/// Text, frames and marks.
pub const INK: Colour = Colour([38, 38, 38]);
/// Text of less weight.
pub const GREY: Colour = Colour([96, 96, 96]);
/// Lines of a grid.
pub const GRID: Colour = Colour([222, 222, 222]);
/// The sheet.
pub const WHITE: Colour = Colour([255, 255, 255]);
/// Lines that end what is drawn in colours.
pub const BLACK: Colour = Colour([0, 0, 0]);

// The palette of M. Okabe and K. Ito, Color Universal Design (2008), which the colour-blind can distinguish.
/// Okabe and Ito's blue.
pub const BLUE: Colour = Colour([0, 114, 178]);
/// Okabe and Ito's sky blue.
pub const SKY: Colour = Colour([86, 180, 233]);
/// Okabe and Ito's bluish green.
pub const GREEN: Colour = Colour([0, 158, 115]);
/// Okabe and Ito's orange.
pub const ORANGE: Colour = Colour([230, 159, 0]);
/// Okabe and Ito's vermilion.
pub const VERMILION: Colour = Colour([213, 94, 0]);
/// Okabe and Ito's reddish purple.
pub const PURPLE: Colour = Colour([204, 121, 167]);
/// Okabe and Ito's yellow.
pub const YELLOW: Colour = Colour([240, 228, 66]);

/// Colours of series in their order.
pub const SERIES: [Colour; 7] = [BLUE, VERMILION, GREEN, ORANGE, PURPLE, SKY, INK];

impl Colour {
    /// The colour as `#rrggbb`.
    pub fn hex(self) -> String {
        let [red, green, blue] = self.0;
        format!("#{red:02x}{green:02x}{blue:02x}")
    }

    /// Relative luminance from 0 (black) to 1 (white), of IEC 61966-2-1.
    pub fn luminance(self) -> f64 {
        let linear = |part: u8| {
            let part = f64::from(part) / 255.0;
            match part > 0.04045 {
                true => ((part + 0.055) / 1.055).powf(2.4),
                false => part / 12.92,
            }
        };
        let [red, green, blue] = self.0.map(linear);
        0.2126 * red + 0.7152 * green + 0.0722 * blue
    }

    /// Ink or white, whichever is easier to read on this colour.
    pub fn ink(self) -> Colour {
        let contrast = |other: f64| {
            let (low, high) = (self.luminance().min(other), self.luminance().max(other));
            (high + 0.05) / (low + 0.05)
        };
        match contrast(1.0) > contrast(INK.luminance()) {
            true => WHITE,
            false => INK,
        }
    }

    /// The colour between this one (0) and another (1).
    pub fn towards(self, other: Colour, part: f64) -> Colour {
        let part = part.clamp(0.0, 1.0);
        let mixed = |k: usize| f64::from(self.0[k]) + part * (f64::from(other.0[k]) - f64::from(self.0[k]));
        Colour([0, 1, 2].map(|k| mixed(k).round() as u8))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ink_can_be_read() {
        assert_eq!(WHITE.ink(), INK);
        assert_eq!(Colour([1, 25, 89]).ink(), WHITE);
        assert_eq!(BLUE.hex(), "#0072b2");
        assert_eq!(WHITE.towards(BLACK, 0.5), Colour([128, 128, 128]));
        assert!((WHITE.luminance() - 1.0).abs() < 1e-12 && BLACK.luminance() == 0.0);
    }
}
