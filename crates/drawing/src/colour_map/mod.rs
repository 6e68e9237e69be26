//! Colour maps as data: tables of 33 colours, between which colours are mixed.
//!
//! Requirements, which tests check by CAM02-UCS and by Machado's model of colour-vision deficiencies: the lightness of
//! a map rises or falls throughout, for normal vision and for the three deficiencies; its steps are even; the diverging
//! map is white in its middle.

#[cfg(test)]
mod perception;
mod tables;

use crate::Colour;

/// A map from 0 to 1 to colours.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ColourMap {
    /// White to dark blue: a field of one sign that is zero at its low end.
    Batlow,
    /// Dark blue to white: a field whose least values matter.
    Davos,
    /// White to dark violet by blue.
    Devon,
    /// Light to dark violet by red.
    Acton,
    /// Light yellow to black by red.
    Lajolla,
    /// Blue, white in the middle, brown: a field of both signs.
    Vik,
}

impl ColourMap {
    /// All maps.
    pub const ALL: [ColourMap; 6] = [Self::Batlow, Self::Davos, Self::Devon, Self::Acton, Self::Lajolla, Self::Vik];

    /// The colours at equal steps from 0 to 1, six hexadecimal digits each.
    pub fn to_hex(self) -> String {
        self.table().iter().flatten().map(|part| format!("{part:02x}")).collect()
    }

    /// The colours at equal steps from 0 to 1.
    pub fn table(self) -> &'static [[u8; 3]; 33] {
        match self {
            Self::Batlow => &tables::BATLOW,
            Self::Davos => &tables::DAVOS,
            Self::Devon => &tables::DEVON,
            Self::Acton => &tables::ACTON,
            Self::Lajolla => &tables::LAJOLLA,
            Self::Vik => &tables::VIK,
        }
    }

    /// True for the map of fields of both signs, whose middle is zero.
    pub fn is_diverging(self) -> bool {
        self == Self::Vik
    }

    /// The colour of a share from 0 to 1; others count as the nearer of these, a share that is no number as 0.
    pub fn colour(self, share: f64) -> Colour {
        let table = self.table();
        let place = if share.is_nan() { 0.0 } else { share.clamp(0.0, 1.0) } * (table.len() - 1) as f64;
        let lower = (place as usize).min(table.len() - 2);
        Colour(table[lower]).towards(Colour(table[lower + 1]), place - lower as f64)
    }
}
