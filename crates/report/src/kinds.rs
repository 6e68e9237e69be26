//! Scenes with comments to begin with, one for each kind of bearing.

/// The scenes by the name of their kind, without the line that names their schema. The first sentence of each says what
/// it describes.
pub const KINDS: [(&str, &str); 6] = [
    ("plain", include_str!("kinds/plain.toml")),
    ("hole", include_str!("kinds/hole.toml")),
    ("groove", include_str!("kinds/groove.toml")),
    ("engine-main", include_str!("kinds/engine_main.toml")),
    ("heat", include_str!("kinds/heat.toml")),
    ("pad", include_str!("kinds/pad.toml")),
];

/// The scene of a kind; `None` where there is no such kind.
pub fn kind(name: &str) -> Option<&'static str> {
    let found = KINDS.iter().find(|(other, _)| *other == name);
    found.map(|(_, text)| *text)
}

#[cfg(test)]
mod tests {
    use super::*;
    use oilwedge_scene::Scene;
    use std::path::Path;

    #[test]
    fn every_kind_is_a_scene_with_comments() {
        for (kind, text) in KINDS {
            let scene = Scene::parse(text, Path::new("scene.toml"), &[]);
            assert!(scene.is_ok(), "{kind}: {}", scene.map(|_| ()).unwrap_err());
            let explained = text.lines().filter(|line| line.contains(" = ") && !line.starts_with('#'));
            assert!(explained.clone().all(|line| line.contains("# ")), "{kind}: {text}");
            assert!(explained.count() > 6, "{kind}");
        }
    }
}
