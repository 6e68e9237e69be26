//! The known word that looks most like an unknown one.

/// The candidate nearest to `word`, if one is near enough to be meant: a difference in letter case alone counts
/// least; otherwise at most a third of the letters (one in two letters, none in one) may differ.
pub fn nearest<'a>(word: &str, candidates: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    let lower = word.to_lowercase();
    candidates
        .into_iter()
        .map(|candidate| {
            let folded = edits(&lower, &candidate.to_lowercase());
            (folded, edits(word, candidate), candidate)
        })
        .filter(|(folded, _, candidate)| *folded <= allowed(word.chars().count().max(candidate.chars().count())))
        .min_by_key(|(folded, exact, candidate)| (*folded, *exact, candidate.len().abs_diff(word.len())))
        .map(|(_, _, candidate)| candidate)
}

fn allowed(letters: usize) -> usize {
    (letters / 3).max(usize::from(letters > 1))
}

/// Levenshtein distance, with two swapped neighbours counted once (optimal string alignment).
fn edits(from: &str, to: &str) -> usize {
    let from: Vec<char> = from.chars().take(100).collect();
    let to: Vec<char> = to.chars().take(100).collect();
    let mut rows = vec![vec![0; to.len() + 1]; from.len() + 1];
    for i in 0..=from.len() {
        for j in 0..=to.len() {
            if i == 0 || j == 0 {
                rows[i][j] = i + j;
                continue;
            }
            let same = from[i - 1] == to[j - 1];
            let mut best = (rows[i - 1][j] + 1)
                .min(rows[i][j - 1] + 1)
                .min(rows[i - 1][j - 1] + usize::from(!same));
            if i > 1 && j > 1 && from[i - 1] == to[j - 2] && from[i - 2] == to[j - 1] {
                best = best.min(rows[i - 2][j - 2] + 1);
            }
            rows[i][j] = best;
        }
    }
    rows[from.len()][to.len()]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn edits_are_counted() {
        assert_eq!(edits("clearance", "clearence"), 1);
        assert_eq!(edits("speed", "spede"), 1);
        assert_eq!(edits("", "abc"), 3);
        assert_eq!(edits("same", "same"), 0);
    }

    #[test]
    fn only_a_word_that_looks_alike_is_offered() {
        let keys = ["diameter", "length", "clearance", "arc"];
        assert_eq!(nearest("diametre", keys), Some("diameter"));
        assert_eq!(nearest("Length", keys), Some("length"));
        assert_eq!(nearest("colour", keys), None);
        assert_eq!(nearest("MM", ["m", "mm"]), Some("mm"));
        assert_eq!(nearest("mn", ["m", "mm"]), Some("mm"));
    }
}
