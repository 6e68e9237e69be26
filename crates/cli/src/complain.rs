//! Complaints and warnings on stderr, with the place in the scene and the way out.

use crate::interrupt::INTERRUPTED;
use miette::{Diagnostic, LabeledSpan, MietteHandlerOpts, NamedSource, Report, SourceCode};
use oilwedge_report::Error;
use oilwedge_scene::{Complaint, SceneError};
use oilwedge_study::compile::CompileError;
use std::io::{IsTerminal, Write};
use std::ops::Range;
use std::path::{Path, PathBuf};

/// Why a command ends without success.
#[derive(Debug)]
pub(crate) enum Failure {
    /// The scene cannot be used.
    Scene(SceneError),
    /// The mesh cannot be used, or the results cannot be written.
    Run(Error),
    /// An argument cannot be followed.
    Argument {
        /// Which, and why.
        message: String,
    },
    /// stdout cannot be written to.
    Output {
        /// What the operating system says.
        error: std::io::Error,
        /// File or folder to which results were written before.
        written: Option<PathBuf>,
    },
}

impl From<SceneError> for Failure {
    fn from(error: SceneError) -> Self {
        Self::Scene(error)
    }
}

impl From<Error> for Failure {
    fn from(error: Error) -> Self {
        Self::Run(error)
    }
}

impl Failure {
    /// The exit status.
    pub(crate) fn status(&self) -> u8 {
        match self {
            Self::Run(Error::Interrupted { .. }) => INTERRUPTED,
            Self::Output { written: Some(_), .. } => 1,
            _ => 2,
        }
    }

    /// What a scene could not be run for: of a liner that was drawn the error names regions and keys, but not the file.
    pub(crate) fn of(scene: &Path) -> impl Fn(Error) -> Self {
        move |error| match &error {
            Error::Compile(CompileError::Drawing(_)) => Self::Argument {
                message: format!("the scene {}: {error}", scene.display()),
            },
            _ => Self::Run(error),
        }
    }

    /// Tells the failure on stderr.
    pub(crate) fn tell(self) {
        let told = match self {
            Self::Scene(SceneError::Syntax { path, text, complaints }) => {
                Told::about_text("is not valid TOML", &path, text, &complaints)
            }
            Self::Scene(SceneError::Complaints { path, text, complaints }) => {
                Told::about_text("cannot be used", &path, text, &complaints)
            }
            Self::Scene(other) => Told::plain(other.to_string()),
            Self::Run(error) => Told::plain(error.to_string()),
            Self::Argument { message } => Told::plain(message),
            Self::Output { error, written: None } => {
                Told::plain(format!("cannot write to the standard output: {error}"))
            }
            Self::Output {
                error,
                written: Some(path),
            } => Told::plain(format!(
                "the results were written to {}, but not to the standard output: {error}",
                path.display()
            )),
        };
        say(&format!("{:?}", Report::new(told)));
    }
}

/// A line on stderr. That nobody can read it changes nothing in how the run ends.
fn say(line: &str) {
    let written = writeln!(std::io::stderr().lock(), "{line}");
    drop(written);
}

/// Tells warnings on stderr.
pub(crate) fn warn(warnings: &[String]) {
    for warning in warnings {
        say(&format!("warning: {}", printable(warning)));
    }
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
struct Told {
    message: String,
    help: Option<String>,
    place: Option<Range<usize>>,
    source: Option<NamedSource<String>>,
    related: Vec<Told>,
}

/// Longer lines are not shown.
const LINE_LIMIT: usize = 400;

impl Told {
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

/// Without control characters, which could steer the terminal.
pub(crate) fn printable(text: &str) -> String {
    text.chars()
        .map(|letter| {
            if letter.is_control() && letter != '\n' {
                '\u{fffd}'
            } else {
                letter
            }
        })
        .collect()
}

impl std::fmt::Display for Told {
    fn fmt(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        formatter.write_str(&self.message)
    }
}

impl std::error::Error for Told {}

impl Diagnostic for Told {
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
            false => Some(Box::new(self.related.iter().map(|told| told as &dyn Diagnostic))),
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
        let told = Told::about_text("cannot be used", &path, text, &complaints);
        let mut drawn = String::new();
        let theme = miette::GraphicalTheme::unicode_nocolor();
        let handler = miette::GraphicalReportHandler::new_themed(theme).with_wrap_lines(false);
        handler.render_report(&mut drawn, &told).expect("drawing into a text");
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
