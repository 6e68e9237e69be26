//! `[cap]`: masses, crank drive, bolts and shell of a connecting rod's cap. Nothing of the film depends on it.

use std::f64::consts::PI;

use crate::reader::TableReader;

keys! {
    "cap" = Table; "", "no cap", "",
        "the cap of a connecting rod: the load that its bolts must hold. The film does not depend on it";
    "cap.angle" = Quantity(Angle); "270 deg", "required", "",
        "where the middle of the cap lies";
    "cap.reciprocating_mass" = Quantity(Mass); "0.7 kg", "required", "> 0",
        "mass of the piston with ring and pin, and of the rod's share at its small end";
    "cap.rotating_mass" = Quantity(Mass); "0.5 kg", "required", "> 0",
        "mass of the rod's share at its big end, the cap included";
    "cap.cap_mass" = Quantity(Mass); "0.15 kg", "required", "> 0, < `rotating_mass`",
        "mass of the cap";
    "cap.crank_radius" = Quantity(Length); "45 mm", "required", "> 0, < `rod_length`",
        "radius of the crank, half the stroke";
    "cap.rod_length" = Quantity(Length); "145 mm", "required", "> 0",
        "length of the rod between its eyes";
    "cap.bolts" = Table; "", "required", "",
        "the bolts of the cap";
    "cap.bolts.count" = Number; "2", "required", "2, 4, ... 16",
        "number of bolts, both sides together";
    "cap.bolts.diameter" = Quantity(Length); "10 mm", "required", "> 0",
        "outer diameter d of the thread";
    "cap.bolts.stress_area" = Quantity(Area); "58 mm2", "required", "> 0, at most pi d^2/4",
        "section at the core of the thread";
    "cap.bolts.load_share" = Number; "0.2", "required", "between 0 and 1",
        "share chi of a pull at the joint that stretches the bolts; the rest relieves what they clamp";
    "cap.bolts.tightness" = Number; "2.5", "required", ">= 1",
        "safety nu of the joint against opening";
    "cap.bolts.torque_coefficient" = Number; "0.15", "required", "> 0",
        "k of the tightening torque k Q d";
    "cap.shell" = Table; "", "no shell", "",
        "the half of the shell that the cap presses into its seat";
    "cap.shell.protrusion" = Quantity(Length); "25 um", "required", "> 0",
        "how far a half of the shell stands out of its seat before it is clamped";
    "cap.shell.modulus" = Quantity(Pressure); "200 GPa", "required", "> 0",
        "modulus of elasticity of the back of the shell";
    "cap.shell.section" = Quantity(Area); "60 mm2", "required", "> 0",
        "section across the wall of the shell";
    "cap.shell.radius" = Quantity(Length); "26 mm", "required", "> 0",
        "mean radius of the shell";
}

/// No cap has more bolts.
const MOST_BOLTS: f64 = 16.0;

/// The cap of a connecting rod.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Cap {
    /// Mass m_j [kg] of the piston with what belongs to it, and of the rod at its small end.
    pub reciprocating_mass: f64,
    /// Mass m_r [kg] of the rod at its big end, the cap included.
    pub rotating_mass: f64,
    /// Mass m_c [kg] of the cap.
    pub cap_mass: f64,
    /// Crank radius r [m].
    pub crank_radius: f64,
    /// Length l [m] of the rod from eye to eye.
    pub rod_length: f64,
    /// Angle [rad] of the middle of the cap.
    pub angle: f64,
    /// Bolts of the cap.
    pub bolts: Bolts,
    /// The shell, if its halves stand out.
    pub shell: Option<ShellTable>,
}

/// The bolts of a cap.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bolts {
    /// Number i of bolts, half of them on each side.
    pub count: u32,
    /// Outer diameter d [m] of their thread.
    pub diameter: f64,
    /// Section F_1 [m2] that counts for their stress.
    pub stress_area: f64,
    /// Share chi in (0, 1) of a pull at the joint that the bolts bear.
    pub load_share: f64,
    /// Safety nu > 1 of the closed joint.
    pub tightness: f64,
    /// Coefficient k of the tightening torque.
    pub torque_coefficient: f64,
}

/// A half of the bearing shell before it is clamped.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ShellTable {
    /// How far Delta [m] it stands out of its seat.
    pub protrusion: f64,
    /// Modulus of elasticity E [Pa] of its back.
    pub modulus: f64,
    /// Section F [m2] across its wall.
    pub section: f64,
    /// Mean radius rho [m].
    pub radius: f64,
}

pub(crate) fn read(mut table: TableReader<'_>) -> Cap {
    let example = "bolts = { count = 2, diameter = \"10 mm\", stress_area = \"58 mm2\", load_share = 0.2, tightness = 2.5, torque_coefficient = 0.15 }";
    let cap = Cap {
        reciprocating_mass: table.required("reciprocating_mass"),
        rotating_mass: table.required("rotating_mass"),
        cap_mass: table.required("cap_mass"),
        crank_radius: table.required("crank_radius"),
        rod_length: table.required("rod_length"),
        angle: table.required("angle"),
        bolts: bolts(table.table("bolts", example)),
        shell: table.table_if_given("shell").map(shell),
    };
    table.refuse_if(
        cap.cap_mass >= cap.rotating_mass,
        "cap_mass",
        "is not less than rotating_mass, of which the cap is a part",
        "give the mass of the rod at its big end as rotating_mass, the cap included",
    );
    table.refuse_if(
        cap.crank_radius >= cap.rod_length,
        "crank_radius",
        "is not less than rod_length, so the crank could not turn",
        "give half the stroke as crank_radius, and the distance of the rod's eyes as rod_length",
    );
    cap
}

fn bolts(mut table: TableReader<'_>) -> Bolts {
    let count = table.number("count").which(
        |count| count % 2.0 == 0.0 && (2.0..=MOST_BOLTS).contains(&count),
        "is no even number of bolts",
        "give 2, 4 or so, 16 at most: the bolts of both sides together",
    );
    // One that was refused is NaN, which becomes zero.
    let count = count.required() as u32;
    let diameter = table.required("diameter");
    let stress_area = table.required("stress_area");
    let section = 0.25 * PI * diameter * diameter;
    table.refuse_if(
        stress_area > section,
        "stress_area",
        format!("is more than the whole section of the bolt, {:.4} mm2", 1e6 * section),
        "give the section at the core of the thread, some 0.75 of the whole",
    );
    let load_share = table.number("load_share").within(
        "is not between 0 and 1",
        "give the share of a pull at the joint that the bolts bear, about 0.15 to 0.25",
    );
    let load_share = load_share.required();
    let tightness = table
        .number("tightness")
        .within("is below 1, so the joint would open", "give the safety against opening, about 2 to 4");
    Bolts {
        count,
        diameter,
        stress_area,
        load_share,
        tightness: tightness.required(),
        torque_coefficient: table.number("torque_coefficient").required(),
    }
}

fn shell(mut table: TableReader<'_>) -> ShellTable {
    ShellTable {
        protrusion: table.required("protrusion"),
        modulus: table.required("modulus"),
        section: table.required("section"),
        radius: table.required("radius"),
    }
}

#[cfg(test)]
mod tests {
    use crate::scene::tests::{STUDY, read, told};

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
        assert_eq!((cap.bolts.count, cap.bolts.load_share, cap.bolts.tightness), (2, 0.18, 3.0));
        assert!((cap.cap_mass - 0.405).abs() < 1e-15 && (cap.bolts.stress_area - 56.7e-6).abs() < 1e-18);
        assert_eq!(cap.shell.map(|shell| shell.section), Some(1.32 * 1e-4));
        assert_eq!(read(STUDY).expect("a scene").cap, None);
        let shell = CAP.lines().last().expect("a shell");
        let without = read(&with_cap(shell, "")).expect("a scene");
        assert_eq!(without.cap.and_then(|cap| cap.shell), None);
    }

    #[test]
    fn what_a_cap_lacks_is_told() {
        let one = |from: &str, to: &str, wanted: &str| {
            let error = read(&with_cap(from, to)).expect_err(wanted).to_string();
            assert!(error.contains(wanted) && error.lines().count() == 2, "{to}: {error}");
        };
        one("count = 2, ", "", "cap.bolts.count: is missing");
        for count in ["3", "0", "-2", "2.5", "1e9"] {
            one("count = 2", &format!("count = {count}"), "cap.bolts.count: is no even number");
        }
        one("count = 2", "count = \"2\"", "cap.bolts.count: a plain number is wanted");
        one("angle = \"270 deg\"\n", "", "cap.angle: is missing");
        one("\"3.43 kg\"", "3.43", "cap.reciprocating_mass: a bare number has no unit; a mass is wanted");
        one("\"56.7 mm2\"", "\"56.7 mm\"", "cap.bolts.stress_area: \"mm\" is a unit of length, but an area is wanted");
        one("protrusion", "protusion", "cap.shell.protusion: this key is not known");
        let told = told("title = ", "cap = {}\ntitle = ");
        assert!(told.iter().any(|it| it.key == "cap.bolts" && it.help.contains("count = 2")), "{told:?}");
    }

    #[test]
    fn caps_are_checked() {
        for (from, to, wanted) in [
            ("\"3.43 kg\"", "\"0 kg\"", "cap.reciprocating_mass: is not positive"),
            ("\"405 g\"", "\"2.1 kg\"", "cap.cap_mass: is not less than rotating_mass"),
            ("\"62.5 mm\"", "\"230 mm\"", "cap.crank_radius: is not less than rod_length"),
            (
                "\"56.7 mm2\"",
                "\"80 mm2\"",
                "cap.bolts.stress_area: is more than the whole section of the bolt, 78.5398 mm2",
            ),
            ("0.18", "0", "cap.bolts.load_share: is not between 0 and 1"),
            ("0.18", "1.0", "cap.bolts.load_share: is not between 0 and 1"),
            ("tightness = 3", "tightness = 0.9", "cap.bolts.tightness: is below 1"),
            ("\"25 um\"", "\"-25 um\"", "cap.shell.protrusion: is not positive"),
            ("\"33.5 mm\"", "\"0 mm\"", "cap.shell.radius: is not positive"),
        ] {
            let told = with_cap(from, to);
            let error = read(&told).expect_err(wanted).to_string();
            assert!(error.contains(wanted) && error.lines().count() == 2, "{to}: {error}");
        }
    }
}
