use std::f64::consts::TAU;

use super::*;

const GOOD: &str = "# a comment\n\nangle [deg], Fx [kN], Fy [N]\n0, 1, -20\n90, 2, 0\n180, 3, 1e1\n270, 2, 5\n";

/// What is wrong with a table of loads over one turn.
fn wrong(text: &str) -> String {
    let fault = loads(text, TAU).expect_err(text);
    fault.in_file(Path::new("a.csv")).to_string()
}

#[test]
fn a_table_is_read_in_si() {
    let rows = loads(GOOD, TAU).expect("a table");
    assert_eq!(rows.len(), 4);
    let last = rows[3];
    assert!((last.angle - 0.75 * TAU).abs() < 1e-15);
    assert_eq!((last.force, last.moment), ([2000.0, 5.0], [0.0; 2]));
    let windows = format!("\u{feff}{}", GOOD.replace('\n', "\r\n"));
    assert_eq!(loads(&windows, TAU).expect("a table"), rows);
    let closed = format!("{GOOD}360, 1.0000001, -20\n");
    assert_eq!(loads(&closed, TAU).expect("a table"), rows);
    let shifted = "My [N m], angle [rad], Fy [lbf], Fx [N], Mx [N.mm]\n1, -1, 0, 7, 3\n2, 0, 0, 8, 3\n3, 2, 0, 8, 3\n4, 4, 0, 9, 3\n";
    let rows = loads(shifted, TAU).expect("a table");
    assert_eq!((rows[0].angle, rows[0].force, rows[0].moment), (-1.0, [7.0, 0.0], [0.003, 1.0]));
    let gas = pressures("p [bar], angle [deg]\n1, 0\n2, 100\n3, 200\n1, 300\n", TAU).expect("a table");
    assert!((gas[1][0] - TAU / 3.6).abs() < 1e-15 && gas[1][1] == 2e5);
}

#[test]
fn what_is_no_table_is_refused_with_its_line() {
    let edit = |from: &str, to: &str| wrong(&GOOD.replacen(from, to, 1));
    for (text, words) in [
        (
            edit("180, 3", "90, 3"),
            "the table a.csv, line 6: the angle 90 deg is not beyond that of the row before, 90 deg; sort",
        ),
        (edit("180, 3", "nan, 3"), "line 6: \"nan\" is not a finite number"),
        (edit("180, 3", "180, 3 kN"), "line 6: \"3 kN\" is not a finite number"),
        (edit("180, 3", "180, 1e999"), "line 6: \"1e999\" is not a finite number"),
        (edit("180, 3,", "180, 3,5,"), "line 6: there are 4 cells, and the header has 3"),
        (edit("[kN]", "[mm]"), "line 3: the unit of \"Fx\": \"mm\" is a unit of length, but a force is wanted"),
        (
            edit(" [kN]", ""),
            "line 3: \"Fx\" is not a name with its unit in brackets; write the header as angle [deg], Fx [kN], Fy [kN] and, if wanted, Mx [N.m], My [N.m]",
        ),
        (edit("Fx", "fx"), "line 3: the column \"fx\" is not known, did you mean \"Fx\"?"),
        (edit("Fy", "Fx"), "line 3: the column \"Fx\" stands there twice"),
        (edit(", Fy [N]", ""), "line 3: there is no column \"Fy\""),
        (
            edit("270, 2, 5\n", "270, 2, 5\n361, 2, 5\n"),
            "line 8: the angle 361 deg is more than load.period = 360 deg beyond the first one, 0 deg",
        ),
        (
            edit("270, 2, 5\n", "270, 2, 5\n360, 1.1, -20\n"),
            "line 8: the row stands a period after that of line 4, but differs from it by 3.3e-2",
        ),
        (
            edit("270, 2, 5\n", "200, 2, 5\n"),
            "line 7: the table ends at 200 deg, 160 deg before it begins again with load.period = 360 deg, and its longest step is 90 deg",
        ),
        (wrong(""), "the table a.csv: is empty; write the header as"),
        (wrong("angle [deg], Fx [N], Fy [N]\n"), "has 0 rows"),
        (wrong("angle [deg], Fx [N], Fy [N]\n0, 0, 0\n120, 0, 0\n240, 0, 0\n360, 0, 0\n"), "has 3 rows"),
        (wrong("angle; Fx; Fy\n"), "line 1: \"angle; Fx; Fy\" is not a name"),
    ] {
        assert!(text.contains(words), "{text}\n{words}");
    }
}

#[test]
fn files_that_cannot_be_read_are_refused() {
    let folder = tempfile::tempdir().expect("a folder");
    let of = |path: &Path| read_loads(path, TAU).expect_err("no table").to_string();
    assert!(of(folder.path()).contains("it is not a plain file"));
    assert!(of(&folder.path().join("none.csv")).contains("none.csv: it cannot be read: "));
    let path = folder.path().join("bytes.csv");
    std::fs::write(&path, [b'a', 0xff]).expect("written");
    assert!(of(&path).contains("it is not UTF-8 text (first wrong byte: 1)"));
    std::fs::write(&path, GOOD).expect("written");
    assert_eq!(read_loads(&path, TAU).map(|rows| rows.len()), Ok(4));
}
