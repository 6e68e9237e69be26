//! Errors and warnings on stderr, with the place in the scene and what to do.

use annotate_snippets::renderer::DecorStyle;
use annotate_snippets::{AnnotationKind, Group, Level, Renderer, Snippet};
use oilwedge_campaign::sweep::Part;
use oilwedge_report::Error;
use oilwedge_report::sweep::SweepError;
use oilwedge_report::tables::printable;
use oilwedge_scene::{Complaint, SceneError};
use oilwedge_study::compile_error::CompileError;
use oilwedge_verification::SuiteError;
use std::io::Write;
use std::ops::Range;
use std::path::{Path, PathBuf};

/// Exit status of a run that was interrupted and has no answer: that of a program ended by Ctrl-C.
pub(crate) const INTERRUPTED: u8 = 130;

/// Why a command ends without results.
#[derive(Debug)]
pub(crate) enum Failure {
    /// The scene cannot be used.
    Scene(SceneError),
    /// What failed, and what to do about it.
    Message(String),
    /// The run was interrupted.
    Interrupted(String),
    /// The program cannot write to stdout.
    Output {
        /// The operating system's message.
        error: std::io::Error,
        /// File or folder to which results were written before.
        written: Option<PathBuf>,
    },
}

/// What to do where results cannot be written.
const ELSEWHERE: &str = "choose another folder with --out";

impl From<SceneError> for Failure {
    fn from(error: SceneError) -> Self {
        Self::Scene(error)
    }
}

impl From<CompileError> for Failure {
    fn from(error: CompileError) -> Self {
        Self::Message(error.to_string())
    }
}

impl From<Error> for Failure {
    fn from(error: Error) -> Self {
        Self::Message(match &error {
            Error::System { .. } => format!("{error}; {ELSEWHERE}"),
            Error::Busy { .. } => format!("{error}; wait for it, or {ELSEWHERE}"),
            Error::Folder { .. } => format!("{error}; move it away, or {ELSEWHERE}"),
            _ => error.to_string(),
        })
    }
}

impl From<SweepError> for Failure {
    fn from(error: SweepError) -> Self {
        let again = |part: &Part, dir: &Path| format!("--part {part} --out {}", dir.display());
        let help = match &error {
            SweepError::Report(_) | SweepError::Campaign(_) | SweepError::NoCases => None,
            SweepError::Interrupted { .. } => Some("the same command goes on with the missing cases".to_owned()),
            SweepError::Other { .. } | SweepError::Earlier { .. } => {
                Some(format!("{ELSEWHERE}, or replace it with --fresh"))
            }
            SweepError::Busy { .. } => Some(format!("wait until it ends, end it, or {ELSEWHERE}")),
            SweepError::NoParts { dir } => {
                Some(format!("compute them with --part 1/N to N/N and --out {}", dir.display()))
            }
            SweepError::Gaps { dir, missing, unfinished, of } => (missing.iter().chain(unfinished).min())
                .and_then(|number| Part::new(*number, *of))
                .map(|part| format!("compute each as with {}", again(&part, dir))),
            SweepError::Divisions { .. } => Some("move those of one division away".to_owned()),
            SweepError::NotAPart { .. } => Some("move it away".to_owned()),
            SweepError::Part { part, dir, .. } | SweepError::Rows { part, dir, .. } => Some(format!(
                "join with the scene and the --bars of its run, or compute it again with {} --fresh",
                again(part, dir)
            )),
            _ => None,
        };
        let words = help.map_or(error.to_string(), |help| format!("{error}; {help}"));
        match error {
            SweepError::Report(error) => error.into(),
            SweepError::Campaign(error) => error.into(),
            SweepError::Interrupted { .. } => Self::Interrupted(words),
            _ => Self::Message(words),
        }
    }
}

impl From<oilwedge_campaign::Error> for Failure {
    fn from(error: oilwedge_campaign::Error) -> Self {
        use oilwedge_campaign::Error;
        Self::Message(match &error {
            Error::Threads(_) => format!("{error}; give fewer with --threads"),
            Error::NothingToConverge { .. } => {
                format!("{error}; give an eccentricity, a feed or a load that is not zero")
            }
            _ => error.to_string(),
        })
    }
}

impl From<SuiteError> for Failure {
    fn from(error: SuiteError) -> Self {
        Self::Message(match &error {
            SuiteError::Threads(_) => format!("{error}; give fewer with --threads"),
            _ => error.to_string(),
        })
    }
}

impl Failure {
    /// The exit status.
    pub(crate) fn status(&self) -> u8 {
        match self {
            Self::Interrupted(_) => INTERRUPTED,
            Self::Output { written: Some(_), .. } => 1,
            _ => 2,
        }
    }

    /// A failure of the scene at `path`: errors of a liner that was meshed here name regions and keys, but not the
    /// file.
    pub(crate) fn of<E: Into<Self>>(path: &Path) -> impl Fn(E) -> Self {
        move |error| match error.into() {
            Self::Message(message) => Self::Message(format!("the scene {}: {message}", path.display())),
            other => other,
        }
    }

    /// Reports the failure on stderr.
    pub(crate) fn report(self) {
        say(&self.drawn());
    }

    /// The failure as it is shown, in colours.
    fn drawn(&self) -> String {
        match self {
            Self::Scene(SceneError::Syntax { path, text, complaints }) => {
                about_text("is not valid TOML", path, text, complaints)
            }
            Self::Scene(SceneError::Complaints { path, text, complaints }) => {
                about_text("cannot be used", path, text, complaints)
            }
            Self::Scene(other) => plain(&other.to_string()),
            Self::Message(message) | Self::Interrupted(message) => plain(message),
            Self::Output { error, written } => plain(&match written {
                None => format!("cannot write to the standard output: {error}"),
                Some(path) => {
                    let path = path.display();
                    format!("the results were written to {path}, but not to the standard output: {error}")
                }
            }),
        }
    }
}

/// A line on stderr, with its colours where that is a terminal that shows them. That it cannot be written does not
/// change how the run ends.
pub(crate) fn say(line: &str) {
    let written = writeln!(anstream::stderr().lock(), "{line}");
    drop(written);
}

/// Writes warnings to stderr.
pub(crate) fn warn(warnings: &[impl AsRef<str>]) {
    for warning in warnings {
        say(&format!("warning: {}", printable(warning.as_ref())));
    }
}

/// Warns that the cases of the sweep of a scene that is solved, if it has one, are not computed.
pub(crate) fn warn_of_sweep(cases: Option<usize>) {
    let words = cases.map(|cases| {
        format!(
            "[sweep] is ignored: the scene was solved as it is without it; its {cases} cases are run by oilwedge sweep"
        )
    });
    warn(words.as_slice());
}

/// Longer lines are not shown.
const LINE_LIMIT: usize = 400;

fn plain(message: &str) -> String {
    render(title(message))
}

/// What is wrong with the text of the scene at `path`: one place, message and way out for each complaint.
fn about_text(what: &str, path: &Path, text: &str, complaints: &[Complaint]) -> String {
    let path = path.display().to_string();
    let message = match complaints.len() {
        1 => format!("the scene {path} {what}"),
        count => format!("the scene {path} {what}, for {count} reasons"),
    };
    let each = complaints.iter().map(|complaint| {
        let place = complaint.span.clone().filter(|span| can_be_shown(text, span));
        let marked = place.map(|span| {
            let mark = AnnotationKind::Primary.span(span);
            Snippet::source(text).path(path.as_str()).annotation(mark)
        });
        let group = marked.into_iter().fold(title(&complaint.to_string()), Group::element);
        render(group.element(Level::HELP.message(printable(&complaint.help))))
    });
    let parts: Vec<String> = std::iter::once(plain(&message)).chain(each).collect();
    parts.join("\n\n")
}

fn title<'a>(message: &str) -> Group<'a> {
    Group::with_title(Level::ERROR.primary_title(printable(message)))
}

fn render(group: Group<'_>) -> String {
    let style = match is_unicode(|name| std::env::var(name).ok()) {
        true => DecorStyle::Unicode,
        false => DecorStyle::Ascii,
    };
    Renderer::styled().decor_style(style).render(&[group])
}

/// Whether the `environment` names a character set with lines for frames.
fn is_unicode(environment: impl Fn(&str) -> Option<String>) -> bool {
    let set = ["LC_ALL", "LC_CTYPE", "LANG"].map(environment);
    let set = set.into_iter().flatten().find(|set| !set.is_empty());
    set.is_some_and(|set| set.to_uppercase().replace('-', "").ends_with("UTF8"))
}

fn can_be_shown(text: &str, span: &Range<usize>) -> bool {
    let (Some(before), Some(after)) = (text.get(..span.start), text.get(span.end..)) else {
        return false;
    };
    let start = before.rfind('\n').map_or(0, |place| place + 1);
    let end = span.end + after.find('\n').unwrap_or(after.len());
    text[start..end].lines().all(|line| line.len() <= LINE_LIMIT)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_complaint_shows_the_line_and_the_way_out() {
        let text = "title = \"x\"\n[bearing]\nclearance = 37.5\n";
        let Err(error) = oilwedge_study::parse(text, Path::new("bearing.toml")) else { panic!("must be refused") };
        let drawn = Failure::Scene(error).drawn();
        let drawn = anstream::adapter::strip_str(&drawn).to_string();
        for part in ["bearing.toml:3:13", "bearing.clearance: a bare number", "write clearance = \"37.5 um\"", "[oil]"]
        {
            assert!(drawn.contains(part), "{part}:\n{drawn}");
        }
    }

    #[test]
    fn long_lines_and_control_characters_stay_away() {
        assert!(!can_be_shown(&"x".repeat(1000), &(5..6)));
        assert!(can_be_shown("a\nb\nc", &(2..3)));
        assert!(!can_be_shown("a", &(2..3)));
        assert_eq!(printable("a\u{1b}[31m\nb"), "a\u{fffd}[31m\nb");
    }
}
