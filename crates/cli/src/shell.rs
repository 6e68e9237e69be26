//! `oilwedge completions` and `oilwedge man`: what shells and `man` read, made of the arguments of the program.

use crate::complain::Failure;
use crate::terminal::print;
use clap::Command;
use clap_complete::Shell;
use std::path::PathBuf;
use std::process::ExitCode;

/// Name of the program.
const PROGRAM: &str = "oilwedge";

/// Arguments of `oilwedge completions`.
#[derive(Debug, clap::Args)]
#[command(after_help = "Example:\n  oilwedge completions bash > ~/.local/share/bash-completion/completions/oilwedge")]
pub(crate) struct Completions {
    /// The shell.
    #[arg(value_enum, value_name = "SHELL")]
    shell: Shell,
}

/// Arguments of `oilwedge man`.
#[derive(Debug, clap::Args)]
#[command(after_help = "Example:\n  oilwedge man --out ~/.local/share/man/man1")]
pub(crate) struct Man {
    /// Folder of the pages, one for each verb; it is made if it is absent.
    #[arg(long, value_name = "DIR")]
    out: PathBuf,
}

impl Completions {
    /// Prints the script that completes `command`.
    ///
    /// # Errors
    /// [`Failure`]: stdout cannot be written to.
    pub(crate) fn run(&self, mut command: Command) -> Result<ExitCode, Failure> {
        let mut script = Vec::new();
        clap_complete::generate(self.shell, &mut command, PROGRAM, &mut script);
        print(&String::from_utf8_lossy(&script), None)?;
        Ok(ExitCode::SUCCESS)
    }
}

impl Man {
    /// Writes the pages of `command`.
    ///
    /// # Errors
    /// [`Failure`]: they cannot be written.
    pub(crate) fn run(&self, command: Command) -> Result<ExitCode, Failure> {
        let written = std::fs::create_dir_all(&self.out).and_then(|()| clap_mangen::generate_to(command, &self.out));
        written.map_err(|error| {
            Failure::Message(format!(
                "cannot write the manual pages to {}: {error}; choose another folder with --out",
                self.out.display()
            ))
        })?;
        Ok(ExitCode::SUCCESS)
    }
}
