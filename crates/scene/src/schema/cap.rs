//! The keys of `[cap]`: masses, crank drive, bolts and shell of a connecting rod's cap.

use oilwedge_bearing::{CapJoint, Shell};

use crate::reader::TableReader;
use crate::scene::Cap;
use crate::unit::Dimension;

/// More bolts has no cap.
const MOST_BOLTS: f64 = 16.0;

pub(super) fn read(mut table: TableReader<'_>) -> Cap {
    let example = "bolts = { count = 2, diameter = \"10 mm\", stress_area = \"58 mm2\", load_share = 0.2, tightness = 2.5, torque_coefficient = 0.15 }";
    let mut bolts = table.table("bolts", example);
    let joint = CapJoint {
        reciprocating_mass: table.quantity("reciprocating_mass", Dimension::Mass, "0.7 kg"),
        rotating_mass: table.quantity("rotating_mass", Dimension::Mass, "0.5 kg"),
        cap_mass: table.quantity("cap_mass", Dimension::Mass, "0.15 kg"),
        crank_radius: table.quantity("crank_radius", Dimension::Length, "45 mm"),
        rod_length: table.quantity("rod_length", Dimension::Length, "145 mm"),
        bolts: count(&mut bolts),
        diameter: bolts.quantity("diameter", Dimension::Length, "10 mm"),
        stress_area: bolts.quantity("stress_area", Dimension::Area, "58 mm2"),
        load_share: number(&mut bolts, "load_share", "0.2"),
        tightness: number(&mut bolts, "tightness", "2.5"),
        torque_coefficient: number(&mut bolts, "torque_coefficient", "0.15"),
        shell: table.table_if_given("shell").map(shell),
    };
    bolts.finish();
    let angle = table.quantity("angle", Dimension::Angle, "270 deg");
    table.finish();
    Cap { joint, angle }
}

fn shell(mut table: TableReader<'_>) -> Shell {
    let shell = Shell {
        protrusion: table.quantity("protrusion", Dimension::Length, "25 um"),
        modulus: table.quantity("modulus", Dimension::Pressure, "200 GPa"),
        section: table.quantity("section", Dimension::Area, "60 mm2"),
        radius: table.quantity("radius", Dimension::Length, "26 mm"),
    };
    table.finish();
    shell
}

fn number(table: &mut TableReader<'_>, key: &'static str, example: &str) -> f64 {
    table.require(key, example);
    table.number_if_given(key, example).unwrap_or(f64::NAN)
}

/// An even number of bolts; none where it was complained about.
fn count(table: &mut TableReader<'_>) -> u32 {
    let count = number(table, "count", "2");
    let is_even = count % 2.0 == 0.0 && (2.0..=MOST_BOLTS).contains(&count);
    if !is_even && !count.is_nan() {
        let help = format!("give 2, 4 or so, {MOST_BOLTS} at most: the bolts of both sides together");
        table.complain("count", "is no even number of bolts", help);
    }
    if is_even { count as u32 } else { 0 }
}

#[cfg(test)]
mod tests {
    use crate::schema::tests::{STUDY, read, told};

    const CAP: &str = r#"[cap]
reciprocating_mass = "3.43 kg"
rotating_mass = "2.025 kg"
cap_mass = "405 g"
crank_radius = "62.5 mm"
rod_length = "230 mm"
angle = "270 deg"
bolts = { count = 2, diameter = "10 mm", stress_area = "56.7 mm2", load_share = 0.18, tightness = 3, torque_coefficient = 0.15 }
shell = { protrusion = "25 um", modulus = "190 GPa", section = "1.32 cm2", radius = "33.5 mm" }
"#;

    /// The study with a cap in which `from` is replaced by `to`.
    fn with_cap(from: &str, to: &str) -> String {
        assert!(CAP.contains(from), "{from}");
        STUDY.to_owned() + &CAP.replacen(from, to, 1)
    }

    #[test]
    fn a_cap_is_read_in_si() {
        let cap = read(&with_cap("[cap]", "[cap]")).expect("a scene").cap.expect("a cap");
        let joint = cap.joint;
        assert_eq!((joint.bolts, joint.load_share, joint.tightness), (2, 0.18, 3.0));
        assert!((joint.cap_mass - 0.405).abs() < 1e-15 && (joint.stress_area - 56.7e-6).abs() < 1e-18);
        assert_eq!(joint.shell.map(|shell| shell.section), Some(1.32 * 1e-4));
        assert_eq!(read(STUDY).expect("a scene").cap, None);
        let shell = CAP.lines().last().expect("a shell");
        let without = read(&with_cap(shell, "")).expect("a scene");
        assert_eq!(without.cap.and_then(|cap| cap.joint.shell), None);
    }

    #[test]
    fn what_a_cap_lacks_is_told() {
        let one = |from: &str, to: &str, wanted: &str| {
            let error = read(&with_cap(from, to)).expect_err(wanted).to_string();
            assert!(error.contains(wanted) && error.lines().count() == 2, "{to}: {error}");
        };
        one("count = 2, ", "", "cap.bolts.count: is missing");
        for count in ["3", "0", "-2", "2.5", "1e9"] {
            one(
                "count = 2",
                &format!("count = {count}"),
                "cap.bolts.count: is no even number",
            );
        }
        one(
            "count = 2",
            "count = \"2\"",
            "cap.bolts.count: a plain number is wanted",
        );
        one("angle = \"270 deg\"\n", "", "cap.angle: is missing");
        one(
            "\"3.43 kg\"",
            "3.43",
            "cap.reciprocating_mass: a bare number has no unit; a mass is wanted",
        );
        one(
            "\"56.7 mm2\"",
            "\"56.7 mm\"",
            "cap.bolts.stress_area: \"mm\" is a unit of length, but an area is wanted",
        );
        one("protrusion", "protusion", "cap.shell.protusion: this key is not known");
        let told = told("title = ", "cap = {}\ntitle = ");
        assert!(
            told.iter()
                .any(|it| it.key == "cap.bolts" && it.help.contains("count = 2")),
            "{told:?}"
        );
    }
}
