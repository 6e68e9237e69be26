//! The files that a scene names, which a page carries, so that the scene is saved with them.

use std::path::{Path, PathBuf};

use base64_simd::STANDARD;
use oilwedge_scene::{Scene, ShaftScene};
use serde::Serialize;

/// Most bytes of a file that a page carries.
const LARGEST: u64 = 2_000_000;
/// What a page calls the file of its scene.
const SCENE: &str = "scene.toml";

/// A file that a scene names.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct SceneFile {
    /// Path of the file as the scene writes it, counted from the folder of the scene.
    name: String,
    bytes: Vec<u8>,
}

impl SceneFile {
    /// The files that the scene `text` in the file `path` names, and those that these name in turn, as far as they can
    /// be read and a page can carry them.
    pub fn all(text: &str, path: &Path) -> Vec<Self> {
        let mut found: Vec<Self> = Vec::new();
        let mut left = vec![(text.to_owned(), PathBuf::from(SCENE), path.to_owned())];
        while let Some((text, name, path)) = left.pop() {
            for (name, path) in named(&text, &name).into_iter().zip(named(&text, &path)) {
                let written = name.display().to_string();
                let is_small = std::fs::metadata(&path).is_ok_and(|about| about.is_file() && about.len() <= LARGEST);
                if !is_small || found.iter().any(|file| file.name == written) {
                    continue;
                }
                let Ok(bytes) = std::fs::read(&path) else { continue };
                if let (Some("toml"), Ok(text)) =
                    (path.extension().and_then(|ending| ending.to_str()), String::from_utf8(bytes.clone()))
                {
                    left.push((text, name, path));
                }
                found.push(Self { name: written, bytes });
            }
        }
        found
    }
}

/// The files that a scene of a bearing or a crankshaft names, counted from the folder of `path`; nothing of a text that
/// is none.
fn named(text: &str, path: &Path) -> Vec<PathBuf> {
    let of_bearing = Scene::parse(text, path, &[]).map(|scene| {
        let files = scene.files().map(|(_, file, _)| file.to_owned());
        files.collect::<Vec<_>>()
    });
    let of_shaft = || {
        let scene = ShaftScene::parse(text, path).ok()?;
        Some(scene.files().into_iter().map(|(_, file, _)| file).collect())
    };
    of_bearing.ok().or_else(of_shaft).unwrap_or_default()
}

/// The files as the page shows them.
#[derive(Debug, Default, Serialize)]
pub(super) struct SavedFiles {
    links: Vec<Link>,
    /// Files that the page does not carry.
    missing: Vec<String>,
}

/// A file that the page carries.
#[derive(Debug, Serialize)]
struct Link {
    path: String,
    /// Last part of the path.
    name: String,
    /// Content of the file as an address.
    address: String,
}

/// What the page carries of the files that the scene `text` names.
pub(super) fn saved(text: &str, files: &[SceneFile]) -> SavedFiles {
    let link = |path: &str, bytes: &[u8]| Link {
        path: path.to_owned(),
        name: path.rsplit(['/', '\\']).next().unwrap_or_default().to_owned(),
        address: format!("data:application/octet-stream;base64,{}", STANDARD.encode_to_string(bytes)),
    };
    let own = (!text.is_empty()).then(|| link(SCENE, text.as_bytes()));
    let links = own.into_iter().chain(files.iter().map(|file| link(&file.name, &file.bytes)));
    let mut missing: Vec<String> = Vec::new();
    for path in named(text, Path::new(SCENE)) {
        let path = path.display().to_string();
        if files.iter().all(|file| file.name != path) && !missing.contains(&path) {
            missing.push(path);
        }
    }
    SavedFiles { links: links.collect(), missing }
}
