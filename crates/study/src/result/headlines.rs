//! Quantities that short tables show.

use crate::effects::{Effects, Socket};
use crate::quantities::{Headline, Row};

/// Most rows of the first table of a run.
pub const MOST_HEADLINES: usize = 14;

/// What short tables show of `all`, the most important first; `row` gives the row of the catalogue of each.
pub fn headlines<'a, T>(
    all: impl IntoIterator<Item = &'a T>,
    row: impl Fn(&T) -> &'static Row,
    effects: &Effects,
) -> Vec<&'a T> {
    let is_loaded = effects.fill(Socket::Position);
    let place = |it: &T| match row(it).headline {
        Headline::Always(place) => Some(place),
        Headline::AtPosition(place) => Some(place).filter(|_| !is_loaded),
        Headline::Never => None,
    };
    let mut shown: Vec<(u8, &T)> = (all.into_iter()).filter_map(|it| Some((place(it)?, it))).collect();
    shown.sort_by_key(|(place, _)| *place);
    shown.into_iter().take(MOST_HEADLINES).map(|(_, it)| it).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::effects::EFFECTS;
    use crate::quantities::{ECCENTRICITY, FEED_FLOW, LOAD, LOAD_X, Quantity};

    #[test]
    fn a_given_load_is_no_headline_and_the_table_is_short() {
        let mut all = vec![Quantity::new(&LOAD, 1.0), Quantity::new(&LOAD_X, 1.0), Quantity::new(&ECCENTRICITY, 0.5)];
        all.extend((0..20).map(|feed| Quantity::of_region(&FEED_FLOW, &format!("hole{feed}"), 1.0)));
        let mut effects = Effects::default();
        let names = |effects: &Effects| -> Vec<String> {
            let shown = headlines(&all, |it| it.row, effects);
            shown.iter().map(|it| it.name.to_string()).collect()
        };
        assert_eq!(names(&effects)[..3], ["load", "eccentricity", "feed_flow.hole0"]);
        effects.simulated = (EFFECTS.iter().copied()).filter(|effect| effect.socket == Socket::Position).collect();
        assert_eq!(names(&effects)[..2], ["eccentricity", "feed_flow.hole0"]);
        assert_eq!(names(&effects).len(), MOST_HEADLINES);
    }
}
