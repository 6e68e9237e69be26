//! The page `docs/validation/thermal_films.md`: films whose temperature is found across them, beside two other codes.

use oilwedge_tests::thermal_films::{NUMBERS, ThermalFilm, reference};

use crate::tables::replace;

/// Digits behind the point of each number.
const DIGITS: [usize; 8] = [4, 3, 3, 1, 3, 2, 2, 2];

/// The page with its table computed anew.
pub fn page(page: &str) -> String {
    let mut head = vec!["film".to_owned(), "by".to_owned()];
    head.extend(NUMBERS.map(|(name, _)| name.to_owned()));
    let mut rows = vec![head];
    for row in reference() {
        let film = ThermalFilm::of(&row.text).numbers();
        let mut reference = vec![format!("{}: {}", row.name, row.what), "two codes".to_owned()];
        let mut own = vec![String::new(), "oilwedge".to_owned()];
        for ((number, film), digits) in row.numbers.iter().zip(film).zip(DIGITS) {
            let [value, uncertainty] =
                number.map_or([String::new(), String::new()], |number| number.map(|part| format!("{part:.digits$}")));
            reference.push(if value.is_empty() { value } else { format!("{value} +- {uncertainty}") });
            own.push(film.filter(|_| number.is_some()).map_or(String::new(), |film| format!("{film:.digits$}")));
        }
        rows.extend([reference, own]);
    }
    replace(page, "films", &rows)
}
