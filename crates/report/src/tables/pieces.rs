//! Pieces of reports: headings, times, counts.

pub use oilwedge_scene::wording::printable;

use oilwedge_study::effects::Effects;
use oilwedge_study::result::{MeshFacts, ResultHead, Status};

use crate::digits::significant;

/// Title and status.
pub fn heading(title: &str, status: &str) -> String {
    format!("{}: {status}", printable(title))
}

/// The text of a whole run: title and status, the reason if there is one, its tables, and lines, of which the verdict
/// is the last.
pub fn whole_run(head: &ResultHead, tables: Vec<String>, lines: &[String]) -> String {
    let mut parts = vec![heading(&head.title, status(head.status))];
    parts.extend(head.reason.iter().map(|reason| format!("reason: {}", printable(reason))));
    parts.extend(tables);
    parts.push(lines.join("\n"));
    parts.join("\n\n") + "\n"
}

/// A status in words.
pub(super) fn status(status: Status) -> &'static str {
    match status {
        Status::Converged => "converged",
        Status::NoSolution => "there is no solution",
        Status::NotConverged => "not converged",
    }
}

/// Size and quality of a mesh.
pub fn mesh(mesh: &MeshFacts) -> String {
    format!(
        "{} triangles, {} nodes for a pressure of degree {}, smallest angle {} deg",
        mesh.cells,
        mesh.nodes,
        mesh.order,
        significant(mesh.min_angle_deg, 3)
    )
}

/// What is simulated, a line each, and what is not.
pub fn effects(effects: &Effects) -> String {
    let width = effects.simulated.iter().map(|effect| effect.name.len()).max().unwrap_or(0);
    let lines = effects.simulated.iter().map(|effect| format!("{:width$}  {}", effect.name, effect.sentence));
    let simulated: Vec<_> = lines.collect();
    format!(
        "simulated      {}\nnot simulated  {}",
        simulated.join("\n               "),
        effects.not_simulated.join(", ")
    )
}

/// Seconds, or milliseconds where they are few.
pub fn time(seconds: f64) -> String {
    match seconds < 1.0 {
        true => format!("{} ms", significant(1e3 * seconds, 3)),
        false => format!("{} s", significant(seconds, 3)),
    }
}

/// A number of things: `1 case`, `2 cases`.
pub fn counted(count: usize, what: &str) -> String {
    match count {
        1 => format!("1 {what}"),
        count => format!("{count} {what}s"),
    }
}

/// Seconds that are only estimated: `12 s`, `4 min`, `3.5 h`.
pub fn duration(seconds: f64) -> String {
    match seconds {
        short if short < 1.0 => "1 s".to_owned(),
        short if short < 100.0 => format!("{short:.0} s"),
        middle if middle < 6000.0 => format!("{:.0} min", middle / 60.0),
        long => format!("{:.1} h", long / 3600.0),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn estimated_times_are_short() {
        assert_eq!([0.2, 42.4, 700.0, 12_600.0].map(duration), ["1 s", "42 s", "12 min", "3.5 h"]);
        assert_eq!([counted(1, "case"), counted(0, "case")], ["1 case", "0 cases"]);
    }
}
