//! The supply chain: licences, duplicates and sources of all dependencies are those that `deny.toml` allows.
//!
//! The same file is that of `cargo deny`, which is asked too where it is installed. Advisories are a matter of the day
//! and need a database from the network: `docs/maintaining.md` tells how they are looked up.

use std::collections::{BTreeMap, BTreeSet};
use std::process::Command;

use oilwedge_tests::program::{cargo, repository};
use serde_json::Value;
use spdx::{Expression, ParseMode};

fn toml_file(name: &str) -> toml::Table {
    let text = std::fs::read_to_string(repository().join(name)).unwrap_or_else(|error| panic!("{name}: {error}"));
    text.parse().unwrap_or_else(|error| panic!("{name}: {error}"))
}

/// The texts of a list.
fn texts(list: &toml::Value) -> BTreeSet<String> {
    let list = list.as_array().expect("a list");
    list.iter().map(|text| text.as_str().expect("a text").to_owned()).collect()
}

/// The packages of `Cargo.lock`, for all platforms.
fn locked() -> Vec<toml::Table> {
    let lock = toml_file("Cargo.lock");
    let packages = lock["package"].as_array().expect("packages").iter();
    packages.map(|package| package.as_table().expect("a table").clone()).collect()
}

/// What cargo prints.
fn told_by_cargo(arguments: &[&str]) -> String {
    let output = cargo().args(arguments).current_dir(repository()).output();
    let output = output.expect("cargo starts");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8(output.stdout).expect("UTF-8")
}

/// Name and licence of the packages that are built on this platform, those of the workspace left out.
fn licences() -> Vec<(String, Option<String>)> {
    let version = told_by_cargo(&["--version", "--verbose"]);
    let host = version.lines().find_map(|line| line.strip_prefix("host: ")).expect("a host");
    let metadata = ["metadata", "--offline", "--format-version", "1", "--filter-platform", host];
    let metadata: Value = serde_json::from_str(&told_by_cargo(&metadata)).expect("JSON");
    let packages = metadata["packages"].as_array().expect("packages").iter();
    let foreign = packages.filter(|package| !package["source"].is_null());
    let text = |value: &Value| value.as_str().map(str::to_owned);
    foreign.map(|package| (text(&package["name"]).expect("a name"), text(&package["license"]))).collect()
}

#[test]
fn licences_are_allowed() {
    let allowed = texts(&toml_file("deny.toml")["licenses"]["allow"]);
    let mut needed = BTreeSet::new();
    let packages = licences();
    assert!(packages.len() > 100, "only {} packages", packages.len());
    for (name, licence) in packages {
        let licence = licence.unwrap_or_else(|| panic!("{name} names no licence"));
        let expression =
            Expression::parse_mode(&licence, ParseMode::LAX).unwrap_or_else(|error| panic!("{name}: {error}"));
        let is_allowed = expression.evaluate(|asked| {
            // With its exception, if it has one.
            let licence = asked.to_string();
            let is_known = allowed.contains(&licence);
            needed.extend(is_known.then_some(licence));
            is_known
        });
        assert!(is_allowed, "{name} has the licence {licence}, which deny.toml does not allow");
    }
    let idle: Vec<_> = allowed.iter().filter(|licence| !needed.contains(*licence)).collect();
    assert!(idle.is_empty(), "no package has {idle:?}: take it out of deny.toml");
}

/// The program and the Python package are built alone: with other features than those of the workspace, `cargo test`
/// would compile again what they are made of.
#[test]
fn program_and_python_package_have_the_features_of_the_workspace() {
    let packages = |of: &[&str]| {
        let tree = "tree --offline --edges normal,build --prefix none --no-dedupe --format {p}#{f}";
        let arguments: Vec<&str> = tree.split(' ').chain(of.iter().copied()).collect();
        told_by_cargo(&arguments).lines().map(str::to_owned).collect::<BTreeSet<String>>()
    };
    let all = packages(&["--workspace"]);
    for package in ["oilwedge", "oilwedge-python"] {
        let own = packages(&["--package", package]);
        let other: Vec<_> = own.difference(&all).collect();
        assert!(other.is_empty() && own.len() > 100, "name these features in the manifest of {package}: {other:?}");
    }
}

#[test]
fn duplicates_are_those_named() {
    let bans = &toml_file("deny.toml")["bans"];
    let named: BTreeSet<String> = bans["skip"]
        .as_array()
        .expect("a list")
        .iter()
        .map(|skip| {
            assert!(skip["reason"].as_str().is_some_and(|reason| !reason.is_empty()), "{skip} has no reason");
            skip["crate"].as_str().expect("a crate").to_owned()
        })
        .collect();
    let mut versions: BTreeMap<String, Vec<String>> = BTreeMap::new();
    for package in locked() {
        let text = |key: &str| package[key].as_str().expect("a text").to_owned();
        versions.entry(text("name")).or_default().push(text("version"));
    }
    let mut found = BTreeSet::new();
    for (name, versions) in versions.iter().filter(|(_, versions)| versions.len() > 1) {
        let marked: Vec<_> = versions.iter().map(|version| format!("{name}@{version}")).collect();
        let (known, other): (Vec<_>, Vec<_>) = marked.into_iter().partition(|version| named.contains(version));
        assert_eq!(other.len(), 1, "{name} is there in several versions: {other:?} beside those named in deny.toml");
        found.extend(known);
    }
    assert_eq!(found, named, "deny.toml names duplicates that are none");
}

#[test]
fn sources_are_those_allowed() {
    let allowed = texts(&toml_file("deny.toml")["sources"]["allow-registry"]);
    let mut own = Vec::new();
    for package in locked() {
        let name = package["name"].as_str().expect("a name").to_owned();
        let Some(source) = package.get("source") else {
            own.push(name);
            continue;
        };
        let source = source.as_str().expect("a text");
        let registry = source.strip_prefix("registry+").unwrap_or_else(|| panic!("{name} comes from {source}"));
        assert!(allowed.contains(registry), "{name} comes from {registry}");
        assert!(package.contains_key("checksum"), "{name} has no checksum");
    }
    assert!(own.iter().all(|name| name.starts_with("oilwedge")), "{own:?}");
}

/// What can be checked without the network, by the tool itself.
#[test]
fn cargo_deny_agrees_where_it_is_installed() {
    let deny = |arguments: &[&str]| Command::new("cargo-deny").args(arguments).current_dir(repository()).output();
    if deny(&["--version"]).is_err() {
        println!("cargo-deny is not installed");
        return;
    }
    let output = deny(&["--offline", "check", "bans", "licenses", "sources"]).expect("it starts");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
}
