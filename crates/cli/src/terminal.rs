//! What goes to stdout, and how a run exits.

use crate::complain::Failure;
use oilwedge_study::result::Status;
use std::io::{ErrorKind, Write};
use std::path::Path;
use std::process::ExitCode;

/// Prints a text to stdout, after results were `written` to a file or folder, if any; that its reader has gone away
/// already (`| head`) is no fault.
///
/// # Errors
/// [`Failure::Output`] where stdout cannot be written to.
pub(crate) fn print(text: &str, written: Option<&Path>) -> Result<(), Failure> {
    let mut out = std::io::stdout().lock();
    match out.write_all(text.as_bytes()).and_then(|()| out.flush()) {
        Err(error) if error.kind() != ErrorKind::BrokenPipe => {
            Err(Failure::Output { error, written: written.map(Path::to_owned) })
        }
        _ => Ok(()),
    }
}

/// Prints JSON where `--json` is given, else the text for people.
///
/// # Errors
/// A number is not finite, or stdout cannot be written to.
pub(crate) fn output(
    is_json: bool,
    json: impl FnOnce() -> Result<String, oilwedge_report::Error>,
    text: impl FnOnce() -> String,
    written: Option<&Path>,
) -> Result<(), Failure> {
    match is_json {
        true => print(&json()?, written),
        false => print(&text(), written),
    }
}

/// The exit status of a run that has written its results.
pub(crate) fn exit_code(status: Status) -> ExitCode {
    match status {
        Status::Converged => ExitCode::SUCCESS,
        Status::NoSolution | Status::NotConverged => ExitCode::from(1),
    }
}
