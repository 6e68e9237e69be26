#[test]
fn zz_exhibit() {
    let (name, picture) = *oilwedge_tests::gallery::SCENES.last().unwrap();
    let exhibit = oilwedge_tests::gallery::exhibit(name, picture);
    std::fs::write("/tmp/ct/exhibit.md", exhibit.text).unwrap();
    std::fs::write("/tmp/ct/exhibit.svg", exhibit.svg).unwrap();
}
