//! Broken meshes, derived from the shipped ones: exit status 2, nothing written, and a message that names file,
//! place or group, value and way out.

use oilwedge_tests::bench::Bench;
use oilwedge_tests::program::repository;

/// The shipped mesh `name` as text.
fn mesh(name: &str) -> String {
    std::fs::read_to_string(repository().join(format!("meshes/{name}.msh"))).expect("a shipped mesh in text form")
}

/// A scene with its mesh in the file `broken.msh` is refused in these words.
fn refused(scene: &str, broken: impl AsRef<[u8]>, edits: &[(&str, &str)], words: &[&str]) {
    let bench = Bench::new();
    bench.write("broken.msh", broken);
    let shipped = if scene == "01_plain_ring" { "ring" } else { "flexpde_shell" };
    let shipped = format!("../meshes/{shipped}.msh");
    let edits = [&[(shipped.as_str(), "broken.msh")], edits].concat();
    bench.scene(scene, &edits);
    for verb in ["solve", "check"] {
        let told = bench.refuses(&[verb, "scene.toml", "--json"], words);
        assert!(told.stderr.contains("broken.msh"), "{}", told.stderr);
    }
}

fn shell_refused(broken: impl AsRef<[u8]>, words: &[&str]) {
    refused("02_flexpde_shell", broken, &[], words);
}

/// The mesh with the line of coordinates of node `tag` changed.
fn with_node(text: &str, tag: usize, change: impl Fn([&str; 3]) -> String) -> String {
    let mut lines: Vec<String> = text.lines().map(str::to_owned).collect();
    let number = |line: &str, k: usize| line.split(' ').nth(k).and_then(|word| word.parse::<usize>().ok());
    let mut at = lines.iter().position(|line| line == "$Nodes").expect("$Nodes") + 2;
    // Blocks of `dim entity parametric count`, then count tags, then count lines of coordinates.
    while let Some(count) = number(&lines[at], 3) {
        if let Some(k) = (1..=count).find(|k| number(&lines[at + k], 0) == Some(tag)) {
            let words: Vec<&str> = lines[at + count + k].split(' ').collect();
            lines[at + count + k] = change([words[0], words[1], words[2]]);
            return lines.join("\n") + "\n";
        }
        at += 2 * count + 1;
    }
    panic!("no node {tag}");
}

/// The mesh with the corners and mid-side nodes of its triangle `index` in the other sense.
fn with_inverted_triangle(text: &str, index: usize) -> String {
    let mut lines: Vec<String> = text.lines().map(str::to_owned).collect();
    let is_block = |line: &String| {
        let words: Vec<&str> = line.split(' ').collect();
        words.len() == 4 && words[0] == "2" && words[2] == "9"
    };
    let elements = lines.iter().position(|line| line == "$Elements").expect("$Elements");
    let block = elements + lines[elements..].iter().position(is_block).expect("a block of 6-node triangles");
    let line = &mut lines[block + 1 + index];
    let words: Vec<&str> = line.split_whitespace().collect();
    let [tag, a, b, c, ab, bc, ca] = words[..] else { panic!("{line}") };
    *line = format!("{tag} {a} {c} {b} {ca} {bc} {ab}");
    lines.join("\n") + "\n"
}

#[test]
fn another_format_is_refused() {
    let words = ["the gmsh format 2.2, but 4.1 is needed", "gmsh -save -format msh41"];
    shell_refused(mesh("flexpde_shell").replacen("4.1 0 8", "2.2 0 8", 1), &words);
    shell_refused("", &["this is not a gmsh mesh file", "$MeshFormat", "gmsh -2 -format msh41"]);
    shell_refused("solid liner\nendsolid\n", &["this is not a gmsh mesh file"]);
}

#[test]
fn a_truncated_file_is_refused_wherever_it_ends() {
    let text = mesh("flexpde_shell");
    for part in [0.001, 0.2, 0.5, 0.77, 0.99] {
        let length = (part * text.len() as f64) as usize;
        shell_refused(&text[..length], &["$", "line ", "the file is damaged or incomplete, write it again from gmsh"]);
    }
    let binary = std::fs::read(repository().join("meshes/flexpde_ring_straight.msh")).expect("a binary mesh");
    shell_refused(&binary[..binary.len() / 2], &["byte ", "write it again from gmsh"]);
}

#[test]
fn missing_groups_are_named_with_those_there_are() {
    let text = mesh("flexpde_shell");
    let renamed = |from: &str, to: &str| text.replacen(from, to, 1);
    let words =
        ["lacks curve \"arc_from\"", "it has surface \"film\"", "curve \"left\"", "name physical groups so in gmsh"];
    shell_refused(renamed("\"arc_from\"", "\"left\""), &words);
    shell_refused(renamed("\"film\"", "\"oil\""), &["lacks surface \"film\"", "surface \"oil\""]);
    let words = ["no group for feed \"feed_hole\"", "its groups are", "arc_to, hole", "correct the name in the scene"];
    shell_refused(renamed("\"feed_hole\"", "\"hole\""), &words);
    let names = text.find("$PhysicalNames").expect("names")..text.find("$Entities").expect("entities");
    shell_refused(text.replace(&text[names], ""), &["lacks surface \"film\"", "surface \"surface 1\""]);
}

#[test]
fn a_ring_is_no_arc_and_an_arc_is_no_ring() {
    let arc = [("arc       = {", "# {")];
    let words = ["lacks curve \"seam_low\", curve \"seam_high\"", "it is an arc: give [bearing] arc in the scene"];
    refused("02_flexpde_shell", mesh("flexpde_shell"), &arc, &words);
    let arc = "clearance = \"37.5 um\"\narc = { from = \"0 deg\", to = \"180 deg\" }";
    let words = ["lacks curve \"arc_from\"", "it is a full ring: leave [bearing] arc out"];
    refused("01_plain_ring", mesh("ring"), &[("clearance = \"37.5 um\"", arc)], &words);
}

#[test]
fn coordinates_must_be_numbers() {
    let text = mesh("flexpde_shell");
    let words = ["node 1000 has a coordinate that is not a number", "NaN", "export the mesh again"];
    shell_refused(with_node(&text, 1000, |[_, y, z]| format!("nan {y} {z}")), &words);
    shell_refused(with_node(&text, 1000, |[x, _, z]| format!("{x} -inf {z}")), &["node 1000", "inf"]);
    shell_refused(with_node(&text, 1000, |[_, y, z]| format!("left {y} {z}")), &["$Nodes, line 7599", "x coordinate"]);
}

#[test]
fn another_size_than_that_of_the_scene_is_told() {
    let wider = [("diameter  = \"75 mm\"", "diameter  = \"80 mm\"")];
    let words = [
        "bearing.diameter",
        "0.117809725 m in the mesh",
        "0.125663706 m in the scene",
        "correct the one that is wrong",
    ];
    refused("02_flexpde_shell", mesh("flexpde_shell"), &wider, &words);
    let wider = [("diameter = \"75 mm\"", "diameter = \"80 mm\"")];
    let words =
        ["the circumference (pi times bearing.diameter)", "0.235619449 m in the mesh", "0.251327412 m in the scene"];
    refused("01_plain_ring", mesh("ring"), &wider, &words);
    let longer = [("length = \"75 mm\"", "length = \"70 mm\"")];
    let words = ["the length (bearing.length)", "0.075000000 m in the mesh", "0.070000000 m in the scene"];
    refused("01_plain_ring", mesh("ring"), &longer, &words);
    let millimetres = [("[mesh]", "[mesh]\nunit = \"mm\"")];
    refused("01_plain_ring", mesh("ring"), &millimetres, &["as if the file were in m", "[mesh] unit = \"m\""]);
}

#[test]
fn a_cylinder_of_another_radius_is_told() {
    let bench = Bench::new();
    bench.scene("07_grooved_liner", &[("diameter  = \"75 mm\"", "diameter  = \"80 mm\"")]);
    let words = [
        "grooved_liner.msh",
        "the radius (half of bearing.diameter)",
        "0.037500000 m in the mesh",
        "0.040000000 m in the scene",
    ];
    bench.refuses(&["solve", "scene.toml"], &words);
}

#[test]
fn another_arc_than_that_of_the_scene_is_told() {
    let shorter = [("to = \"220 deg\"", "to = \"200 deg\"")];
    let words = ["bearing.arc", "0.117809725 m in the mesh", "0.104719755 m in the scene"];
    refused("02_flexpde_shell", mesh("flexpde_shell"), &shorter, &words);
    let turned = [("from = \"40 deg\", to = \"220 deg\"", "from = \"50 deg\", to = \"230 deg\"")];
    let words = ["runs from 0.026179939", "shift the mesh by 0.006544985 m, or correct bearing.arc"];
    refused("02_flexpde_shell", mesh("flexpde_shell"), &turned, &words);
}

#[test]
fn another_hole_than_that_of_the_scene_is_told() {
    let shell = || mesh("flexpde_shell");
    let moved = [("angle = \"130 deg\"", "angle = \"131 deg\"")];
    let words = [
        "the rim of \"feed_hole\"",
        "x = 0.085739300 m",
        "through its nodes goes the circle x = 0.085084801 m",
        "correct the hole",
    ];
    refused("02_flexpde_shell", shell(), &moved, &words);
    let smaller = [("\"17 mm\"", "\"16 mm\"")];
    refused("02_flexpde_shell", shell(), &smaller, &["radius 0.008000000 m", "radius 0.008500000 m"]);
}

#[test]
fn a_boundary_without_a_pressure_is_told() {
    // Scene 02 without its feed: nothing is said about the rim of the hole.
    let bench = Bench::new();
    let text = oilwedge_tests::bench::edited("02_flexpde_shell", &[]);
    let feed = text.find("[[feed]]").expect("feed")..text.find("[journal]").expect("journal");
    bench.write("scene.toml", text.replace(&text[feed], ""));
    let words = ["flexpde_shell.msh", "56 boundary edges belong to no group with a pressure", "group of a [[feed]]"];
    bench.refuses(&["solve", "scene.toml"], &words);
}

#[test]
fn seams_that_do_not_fit_are_told_by_node() {
    // Node 89 stands in the middle of the high seam.
    let raised = |[x, y, z]: [&str; 3]| format!("{x} {} {z}", y.parse::<f64>().expect("a number") + 1e-3);
    let words = [
        "the seams do not fit: 2 nodes",
        "of \"seam_low\"",
        "node 89 at (0.235619449, 0.026000000) m",
        "Periodic Curve",
    ];
    refused("01_plain_ring", with_node(&mesh("ring"), 89, raised), &[], &words);
}

#[test]
fn an_inverted_triangle_is_told() {
    let broken = with_inverted_triangle(&mesh("flexpde_shell"), 19);
    let words = ["the triangle of nodes [", "near (0.07", "is inverted", "orient all surfaces alike"];
    shell_refused(broken, &words);
}

#[test]
fn a_mesh_alone_is_refused_for_the_same_reasons() {
    let bench = Bench::new();
    let text = mesh("flexpde_shell");
    bench.write("broken.msh", text.replacen("\"arc_to\"", "\"right\"", 1));
    bench.refuses(&["check", "broken.msh"], &["broken.msh", "lacks curve \"arc_to\""]);
    bench.write("broken.msh", with_inverted_triangle(&text, 5));
    bench.refuses(&["check", "broken.msh", "--json"], &["broken.msh", "is inverted"]);
    bench.refuses(&["check", "nowhere.msh"], &["nowhere.msh", "check the path"]);
}
