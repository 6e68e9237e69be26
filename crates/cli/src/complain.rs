//! Errors and warnings on stderr, with the place in the scene and what to do.

use miette::{Diagnostic, LabeledSpan, MietteHandlerOpts, NamedSource, Report, SourceCode};
use oilwedge_campaign::sweep::Part;
use oilwedge_report::Error;
use oilwedge_report::sweep::SweepError;
use oilwedge_report::tables::printable;
use oilwedge_scene::{Complaint, SceneError};
use oilwedge_study::compile_error::CompileError;
use oilwedge_verification::SuiteError;
use std::io::{IsTerminal, Write};
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
    /// stdout cannot be written to.
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
            SweepError::NoParts { dir } => Some(format!(
                "compute them with --part 1/N to N/N and --out {}",
                dir.display()
            )),
            SweepError::Gaps {
                dir,
                missing,
                unfinished,
                of,
            } => (missing.iter().chain(unfinished).min())
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

    /// A failure of the scene at `path`: errors of a liner that was meshed here name regions and keys, but not the file.
    pub(crate) fn of<E: Into<Self>>(path: &Path) -> impl Fn(E) -> Self {
        move |error| match error.into() {
            Self::Message(message) => Self::Message(format!("the scene {}: {message}", path.display())),
            other => other,
        }
    }

    /// Reports the failure on stderr.
    pub(crate) fn report(self) {
        let drawn = match self {
            Self::Scene(SceneError::Syntax { path, text, complaints }) => {
                Drawn::about_text("is not valid TOML", &path, text, &complaints)
            }
            Self::Scene(SceneError::Complaints { path, text, complaints }) => {
                Drawn::about_text("cannot be used", &path, text, &complaints)
            }
            Self::Scene(other) => Drawn::plain(other.to_string()),
            Self::Message(message) | Self::Interrupted(message) => Drawn::plain(message),
            Self::Output { error, written } => Drawn::plain(match written {
                None => format!("cannot write to the standard output: {error}"),
                Some(path) => {
                    let path = path.display();
                    format!("the results were written to {path}, but not to the standard output: {error}")
                }
            }),
        };
        say(&format!("{:?}", Report::new(drawn)));
    }
}

/// A line on stderr. That it cannot be written does not change how the run ends.
pub(crate) fn say(line: &str) {
    let written = writeln!(std::io::stderr().lock(), "{line}");
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

/// Lines are wrapped for people only: a script may look for a sentence.
pub(crate) fn set_up() {
    let people = std::io::stderr().is_terminal();
    let hook = miette::set_hook(Box::new(move |_| {
        let options = MietteHandlerOpts::new().wrap_lines(people).terminal_links(false);
        Box::new(options.context_lines(1).build())
    }));
    // It fails only if a handler was set before, and then that one does.
    drop(hook);
}

/// A text as miette draws it.
#[derive(Debug)]
struct Drawn {
    message: String,
    help: Option<String>,
    place: Option<Range<usize>>,
    source: Option<NamedSource<String>>,
    related: Vec<Drawn>,
}

/// Longer lines are not shown.
const LINE_LIMIT: usize = 400;

impl Drawn {
    fn plain(message: String) -> Self {
        Self {
            message: printable(&message),
            help: None,
            place: None,
            source: None,
            related: Vec::new(),
        }
    }

    fn about_text(what: &str, path: &Path, text: String, complaints: &[Complaint]) -> Self {
        let related = complaints.iter().map(|complaint| Self {
            help: Some(printable(&complaint.help)),
            place: complaint.span.clone().filter(|span| can_be_shown(&text, span)),
            ..Self::plain(complaint.to_string())
        });
        let related = related.collect();
        let message = match complaints.len() {
            1 => format!("the scene {} {what}", path.display()),
            count => format!("the scene {} {what}, for {count} reasons", path.display()),
        };
        let source = Some(NamedSource::new(path.display().to_string(), text));
        Self {
            source,
            related,
            ..Self::plain(message)
        }
    }
}

fn can_be_shown(text: &str, span: &Range<usize>) -> bool {
    let (Some(before), Some(after)) = (text.get(..span.start), text.get(span.end..)) else {
        return false;
    };
    let start = before.rfind('\n').map_or(0, |place| place + 1);
    let end = span.end + after.find('\n').unwrap_or(after.len());
    text[start..end].lines().all(|line| line.len() <= LINE_LIMIT)
}

impl std::fmt::Display for Drawn {
    fn fmt(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        formatter.write_str(&self.message)
    }
}

impl std::error::Error for Drawn {}

impl Diagnostic for Drawn {
    fn help(&self) -> Option<Box<dyn std::fmt::Display + '_>> {
        self.help.as_ref().map(|help| Box::new(help) as _)
    }

    fn source_code(&self) -> Option<&dyn SourceCode> {
        self.source.as_ref().map(|source| source as _)
    }

    fn labels(&self) -> Option<Box<dyn Iterator<Item = LabeledSpan> + '_>> {
        let place = self.place.clone()?;
        Some(Box::new(std::iter::once(LabeledSpan::underline(place))))
    }

    fn related(&self) -> Option<Box<dyn Iterator<Item = &dyn Diagnostic> + '_>> {
        match self.related.is_empty() {
            true => None,
            false => Some(Box::new(self.related.iter().map(|drawn| drawn as &dyn Diagnostic))),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_complaint_shows_the_line_and_the_way_out() {
        let text = "title = \"x\"\n[bearing]\nclearance = 37.5\n";
        let Err(error) = oilwedge_study::parse(text, Path::new("bearing.toml")) else {
            panic!("must be refused")
        };
        let SceneError::Complaints { path, text, complaints } = error else {
            panic!("must be complaints")
        };
        let drawn_complaint = Drawn::about_text("cannot be used", &path, text, &complaints);
        let mut drawn = String::new();
        let theme = miette::GraphicalTheme::unicode_nocolor();
        let handler = miette::GraphicalReportHandler::new_themed(theme).with_wrap_lines(false);
        handler
            .render_report(&mut drawn, &drawn_complaint)
            .expect("drawing into a text");
        for part in [
            "bearing.toml:3:13",
            "bearing.clearance: a bare number",
            "write clearance = \"37.5 um\"",
            "[oil]",
        ] {
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
