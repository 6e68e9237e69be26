//! `validation`: writes the computed tables of the pages in `docs` anew.

use oilwedge_tests::program::repository;
use oilwedge_tests::{cavitation_page, flexpde_study, mesh_page};

fn main() -> std::io::Result<()> {
    let write = |name: &str, page: fn(&str) -> String| {
        let path = repository().join("docs").join(name);
        let written = std::fs::read_to_string(&path)?;
        std::fs::write(&path, page(&written))
    };
    write("validation/flexpde_study.md", flexpde_study::page)?;
    write("theory/cavitation.md", cavitation_page::page)?;
    write("howto/mesh.md", mesh_page::page)
}
