//! `oilwedge verify`.

use std::path::Path;

use oilwedge_tests::program::oilwedge;

#[test]
fn known_values_are_met() {
    let output = oilwedge(Path::new("."), &["verify"]);
    let text = String::from_utf8_lossy(&output.stdout);
    assert_eq!(output.status.code(), Some(0), "{text}");
    assert!(
        text.contains("all as expected") && text.contains("known sommerfeld_number"),
        "{text}"
    );
}

#[test]
fn what_cannot_be_followed_is_refused() {
    let told = |arguments: &[&str]| {
        let output = oilwedge(Path::new("."), arguments);
        assert_eq!(output.status.code(), Some(2), "{arguments:?}");
        assert!(output.stdout.is_empty());
        String::from_utf8_lossy(&output.stderr).into_owned()
    };
    let family = told(&["verify", "--family", "moon"]);
    assert!(family.contains("moon") && family.contains("slenderness"), "{family}");
    assert!(told(&["verify", "--out", "x"]).contains("--hard"));
}
