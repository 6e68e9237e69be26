//! The known word that looks most like an unknown one.

use strsim::osa_distance;

/// The candidate nearest to `word`, if it is near enough to be meant: a difference in letter case alone counts
/// least; otherwise at most a third of the letters (one in two letters, none in one) may differ.
pub fn nearest<'a>(word: &str, candidates: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    let lower = word.to_lowercase();
    let letters = word.chars().count();
    let meant = candidates.into_iter().filter_map(|candidate| {
        let own = candidate.chars().count();
        let allowed = (letters.max(own) / 3).max(usize::from(letters.max(own) > 1));
        // Lengths bound the distance from below, and long words are slow to compare.
        let folded = (letters.abs_diff(own) <= allowed).then(|| osa_distance(&lower, &candidate.to_lowercase()))?;
        (folded <= allowed).then(|| {
            let difference = candidate.len().abs_diff(word.len());
            ((folded, osa_distance(word, candidate), difference), candidate)
        })
    });
    meant.min_by_key(|(distance, _)| *distance).map(|(_, candidate)| candidate)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_a_word_that_looks_alike_is_offered() {
        let keys = ["diameter", "length", "clearance", "arc"];
        assert_eq!(nearest("diametre", keys), Some("diameter"));
        assert_eq!(nearest("Length", keys), Some("length"));
        assert_eq!(nearest("colour", keys), None);
        assert_eq!(nearest("MM", ["m", "mm"]), Some("mm"));
        assert_eq!(nearest("mn", ["m", "mm"]), Some("mm"));
        assert_eq!(nearest(&"diameter".repeat(100_000), keys), None);
    }
}
