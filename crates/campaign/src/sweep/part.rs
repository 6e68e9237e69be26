//! Parts of a sweep, for machines that share it: neighbouring chains, whole, so that each case has the numbers that it
//! has in the sweep by itself.

use std::ops::Range;

/// One of so many parts of a sweep.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, serde::Serialize, serde::Deserialize)]
pub struct Part {
    /// Number of the part, from 1.
    number: u32,
    /// How many parts there are.
    of: u32,
}

impl Part {
    /// Most parts of a sweep.
    pub const MOST: u32 = 1_000_000;

    /// The part of this number of so many; `None` where there is none of this number, or there are more than
    /// [`Part::MOST`].
    pub fn new(number: u32, of: u32) -> Option<Self> {
        ((1..=of).contains(&number) && of <= Self::MOST).then_some(Self { number, of })
    }

    /// Number of the part, from 1.
    pub fn number(self) -> u32 {
        self.number
    }

    /// How many parts there are.
    pub fn of(self) -> u32 {
        self.of
    }

    /// Cases of the part, where `chains` are the chains of the sweep in the order of their cases. Where there are more
    /// parts than chains some are empty.
    pub(super) fn cases(self, chains: &[Range<usize>]) -> Range<usize> {
        let place = |number: u32| (u64::from(number) * chains.len() as u64 / u64::from(self.of)) as usize;
        let first = |place: usize| match chains.get(place) {
            Some(chain) => chain.start,
            None => chains.last().map_or(0, |chain| chain.end),
        };
        first(place(self.number - 1))..first(place(self.number))
    }
}

impl std::fmt::Display for Part {
    fn fmt(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(formatter, "{}/{}", self.number, self.of)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn parts_hold_every_chain_once() {
        let chains: Vec<Range<usize>> = (0..17).map(|k| 5 * k..5 * (k + 1)).collect();
        for of in [1, 2, 16, 17, 18, 40, Part::MOST] {
            let parts = (1..=of).map(|number| Part::new(number, of).expect("a part").cases(&chains));
            let parts: Vec<Range<usize>> = parts.collect();
            assert!(parts.iter().all(|cases| cases.start % 5 == 0 && cases.end % 5 == 0), "{of}");
            assert!(parts.iter().cloned().flatten().eq(0..85), "{of}");
            let counts = parts.iter().map(|cases| cases.len() / 5);
            let (least, most) = counts.fold((usize::MAX, 0), |(least, most), n| (least.min(n), most.max(n)));
            assert!(most - least <= 1, "{of} parts of {least} to {most} chains");
        }
        assert_eq!(Part::new(1, 1).expect("a part").cases(&[]), 0..0);
    }

    #[test]
    fn there_is_no_part_beyond_the_last() {
        for (number, of) in [(0, 4), (5, 4), (0, 0), (1, 0), (1, Part::MOST + 1)] {
            assert_eq!(Part::new(number, of), None);
        }
        assert_eq!(Part::new(4, 4).map(|part| part.to_string()), Some("4/4".to_owned()));
    }
}
