//! `validation`: writes the tables of `docs/validation` anew.

use oilwedge_tests::flexpde_study;
use oilwedge_tests::program::repository;

fn main() -> std::io::Result<()> {
    let path = repository().join("docs/validation/flexpde_study.md");
    let page = std::fs::read_to_string(&path)?;
    std::fs::write(&path, flexpde_study::page(&page))
}
