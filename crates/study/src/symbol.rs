//! Symbols of quantities and fields: a letter and its index.

/// A symbol in its parts: `phi_W`, `Q_s*`, `mu0`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Symbol<'a> {
    /// Letter of the symbol, a Greek one by its name.
    pub letter: &'a str,
    /// Index of the symbol; empty where it has none.
    pub index: &'a str,
    /// Mark of the symbol: a star where the quantity has no dimension by scaling, else empty.
    pub mark: &'a str,
}

impl<'a> Symbol<'a> {
    /// The parts of a symbol as tables write it.
    pub fn of(text: &'a str) -> Self {
        let (plain, mark) = match text.strip_suffix('*') {
            Some(plain) => (plain, &text[plain.len()..]),
            None => (text, ""),
        };
        let letters = plain.trim_end_matches(|letter: char| letter.is_ascii_digit()).len();
        let (letter, index) = plain.split_once('_').unwrap_or(plain.split_at(letters));
        Self { letter, index, mark }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fields::file_fields;
    use crate::quantities::CATALOGUE;

    #[test]
    fn symbols_have_letter_index_and_mark() {
        let parts = |text| {
            let Symbol { letter, index, mark } = Symbol::of(text);
            [letter, index, mark]
        };
        assert_eq!(parts("phi_W"), ["phi", "W", ""]);
        assert_eq!(parts("Q_s*"), ["Q", "s", "*"]);
        assert_eq!(parts("mu0"), ["mu", "0", ""]);
        assert_eq!(parts("phi_1"), ["phi", "1", ""]);
        assert_eq!(parts("h"), ["h", "", ""]);
    }

    /// One Latin letter, a Greek one, or a number of Sommerfeld or Reynolds; two symbols in a ratio; an integral.
    #[test]
    fn every_symbol_of_the_catalogue_is_one() {
        let names = ["beta", "delta", "Delta", "eps", "eta", "mu", "nu", "phi", "sigma", "tau", "theta", "So", "Re"];
        let symbols = CATALOGUE.iter().map(|row| row.symbol);
        for text in symbols.chain(file_fields().map(|row| row.symbol)) {
            for part in text.split(['/', ' ']).filter(|part| !["Int", "dA"].contains(part)) {
                let Symbol { letter, index, .. } = Symbol::of(part);
                assert!(letter.len() == 1 || names.contains(&letter), "{text}: {letter}");
                assert!(index.chars().all(char::is_alphanumeric), "{text}: {index}");
            }
        }
    }
}
