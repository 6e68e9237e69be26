//! `converge.csv`: one line a level.

use std::fmt::Write;

use oilwedge_campaign::convergence::{ConvergenceReport, TIME_PARTS};

/// The table of levels with a line of headings. What is not known is empty; seconds end in `_s`.
pub(super) fn to_csv(report: &ConvergenceReport) -> String {
    let mut text =
        "strategy,degree,level,cells,unknowns,value,unit,relative_bar,relative_error,runs,total_s,least_s,greatest_s"
            .to_owned();
    for part in TIME_PARTS {
        text += &format!(",{part}_s");
    }
    text.push('\n');
    let known = |number: Option<f64>| number.map_or(String::new(), |number| number.to_string());
    for (course, level) in report.levels() {
        let (strategy, seconds) = (course.strategy, &level.seconds);
        let fields = [
            strategy.key().to_owned(),
            strategy.degree().to_string(),
            level.level.to_string(),
            level.cells.to_string(),
            level.unknowns.to_string(),
            level.value.to_string(),
            report.goal.unit.clone(),
            known(level.relative_bar),
            known(level.relative_error),
            seconds.runs.to_string(),
            seconds.total.to_string(),
            seconds.least.to_string(),
            seconds.greatest.to_string(),
        ];
        text += &fields.join(",");
        for part in TIME_PARTS {
            // Writing into a text cannot fail.
            let _ = write!(text, ",{}", seconds.part(part));
        }
        text.push('\n');
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::convergence::tests::example;

    #[test]
    fn every_level_is_a_line_of_as_many_fields() {
        let text = to_csv(&example());
        let lines: Vec<Vec<&str>> = text.lines().map(|line| line.split(',').collect()).collect();
        assert_eq!(lines.len(), 3);
        assert!(lines.iter().all(|line| line.len() == lines[0].len()));
        let field = |line: usize, name: &str| {
            let place = lines[0].iter().position(|heading| *heading == name);
            lines[line][place.expect(name)]
        };
        assert_eq!((field(1, "strategy"), field(1, "value")), ("p2_uniform", "1010"));
        assert_eq!((field(1, "relative_error"), field(2, "relative_error")), ("0.01", ""));
        assert_eq!((field(2, "mesh_s"), field(2, "bars_s")), ("0.125", "0"));
        assert!(text.ends_with('\n') && field(2, "total_s") == "0.5");
    }
}
