//! A folder to run the program in.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use crate::program::{oilwedge, repository};
use serde_json::Value;
use tempfile::TempDir;

/// An empty folder outside of the repository, and the program run in it.
pub struct Bench {
    folder: TempDir,
}

/// The output of a run.
pub struct Told {
    /// Exit status.
    pub status: i32,
    /// What is for people or scripts.
    pub stdout: String,
    /// Complaints and warnings.
    pub stderr: String,
}

impl Default for Bench {
    fn default() -> Self {
        Self::new()
    }
}

impl Bench {
    /// An empty one.
    pub fn new() -> Self {
        let folder = tempfile::tempdir().expect("a temporary folder");
        Self { folder }
    }

    /// The folder.
    pub fn path(&self) -> &Path {
        self.folder.path()
    }

    /// Writes a file into it.
    pub fn write(&self, name: &str, content: impl AsRef<[u8]>) {
        std::fs::write(self.path().join(name), content).expect("writing into a temporary folder");
    }

    /// Writes `scene.toml`: the shipped scene `name` with the first `from` of each edit replaced by its `to`.
    /// Meshes that are not edited stay those of the repository.
    pub fn scene(&self, name: &str, edits: &[(&str, &str)]) {
        self.write("scene.toml", edited(name, edits));
    }

    /// Runs the program there until it ends.
    pub fn run(&self, arguments: &[&str]) -> Told {
        let output = oilwedge(self.path(), arguments);
        let text = |bytes: Vec<u8>| String::from_utf8(bytes).expect("UTF-8");
        Told {
            status: output.status.code().expect("an exit status"),
            stdout: text(output.stdout),
            stderr: text(output.stderr),
        }
    }

    /// Every file below the folder with its content, links with where they lead; folders end in `/`.
    pub fn files(&self) -> BTreeMap<PathBuf, Vec<u8>> {
        let mut found = BTreeMap::new();
        let mut folders = vec![self.path().to_path_buf()];
        while let Some(folder) = folders.pop() {
            for entry in std::fs::read_dir(&folder).expect("a folder") {
                let path = entry.expect("an entry").path();
                if path.is_symlink() {
                    let target = std::fs::read_link(&path).expect("a link");
                    found.insert(path, target.into_os_string().into_encoded_bytes());
                } else if path.is_dir() {
                    found.insert(path.join(""), Vec::new());
                    folders.push(path);
                } else {
                    let content = std::fs::read(&path).expect("a file");
                    found.insert(path, content);
                }
            }
        }
        found
    }

    /// Names of what stands in the folder. Nothing is opened, as a pipe would be to read it.
    pub fn files_named(&self) -> Vec<std::ffi::OsString> {
        let entries = std::fs::read_dir(self.path()).expect("a folder");
        let mut names: Vec<_> = entries.map(|entry| entry.expect("an entry").file_name()).collect();
        names.sort();
        names
    }

    /// Runs the program, which must refuse with exit status 2, write nothing, and name all `words` on stderr.
    pub fn refuses(&self, arguments: &[&str], words: &[&str]) -> Told {
        let before = self.files();
        let told = self.run(arguments);
        assert_eq!(told.status, 2, "{arguments:?}: {}{}", told.stdout, told.stderr);
        assert_eq!(told.stdout, "", "{arguments:?}");
        for word in words {
            assert!(told.stderr.contains(word), "{arguments:?}: no {word:?} in\n{}", told.stderr);
        }
        for panicked in ["panicked", "RUST_BACKTRACE", "fault of the program"] {
            assert!(!told.stderr.contains(panicked), "{arguments:?}: {}", told.stderr);
        }
        assert!(self.files() == before, "{arguments:?}: files were written");
        told
    }
}

/// The text of a shipped scene with edits; its mesh by an absolute path.
pub fn edited(name: &str, edits: &[(&str, &str)]) -> String {
    let path = repository().join(format!("scenes/{name}.toml"));
    let mut text = std::fs::read_to_string(path).expect("a shipped scene");
    for (from, to) in edits {
        assert!(text.contains(from), "{name} has no {from:?}");
        text = text.replacen(from, to, 1);
    }
    text.replace("../meshes/", &format!("{}/", repository().join("meshes").display()))
}

/// The one JSON object that a text is.
pub fn object(text: &str) -> Value {
    let value: Value = serde_json::from_str(text).unwrap_or_else(|error| panic!("{error}:\n{text}"));
    assert!(value.is_object(), "{text}");
    value
}

/// A result without its timings.
pub fn timeless(mut result: Value) -> Value {
    let timings = result.as_object_mut().and_then(|object| object.remove("timing_s"));
    assert!(timings.is_some_and(|timings| timings.is_object()));
    result
}

/// The lines of a `result.json` but for its times: `timing_s`, and `seconds` of levels.
pub fn lines_without_times(text: &str) -> Vec<&str> {
    let mut in_times = false;
    let lines = text.lines().filter(|line| {
        let line = line.trim_start();
        let is_time = in_times || line.starts_with("\"timing_s\"") || line.starts_with("\"seconds\"");
        in_times = (in_times || line.starts_with("\"timing_s\"")) && !line.starts_with('}');
        !is_time
    });
    lines.collect()
}
