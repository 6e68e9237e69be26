//! Files that are no files, texts that are no scenes, and what costs time or memory: refused soon, in a few words.

use std::path::Path;
use std::process::{Command, Stdio};
use std::time::Duration;

use oilwedge_tests::bench::{Bench, edited};
use oilwedge_tests::program::{oilwedge_command, repository};
use wait4::Wait4;

/// Nothing is refused later than this: it would hang.
const SOON: Duration = Duration::from_secs(60);
/// Most memory [B] of the program beside what a file takes: 14 MiB by itself. This test, which starts it, is counted
/// with it.
const PROGRAM: u64 = 64 << 20;

/// Ends with exit status 2 and these words on stderr before long; the most memory held [B].
fn refused_soon(bench: &Bench, file: &str, words: &[&str]) -> u64 {
    let before = bench.files_named();
    let told = bench.path().join("told.txt");
    let stderr = std::fs::File::create(&told).expect("a file");
    let mut child = oilwedge_command()
        .args(["check", file])
        .current_dir(bench.path())
        .stdin(Stdio::null())
        .stdout(Stdio::null())
        .stderr(stderr)
        .spawn()
        .expect("the program starts");
    let id = child.id().to_string();
    let (ended, wait) = std::sync::mpsc::channel::<()>();
    let watch = std::thread::spawn(move || {
        if wait.recv_timeout(SOON).is_err() {
            let _ = Command::new("kill").args(["-KILL", &id]).status();
        }
    });
    let used = child.wait4().expect("the program ends");
    let _ = ended.send(());
    watch.join().expect("the watch ends");
    let text = std::fs::read_to_string(&told).expect("UTF-8");
    std::fs::remove_file(&told).expect("the file goes");
    assert_eq!(used.status.code(), Some(2), "{file}: {text}");
    for word in words {
        assert!(text.contains(word), "{file}: no {word:?} in\n{text}");
    }
    assert!(!text.contains("panicked") && text.len() < 100_000, "{file}: {text}");
    assert_eq!(bench.files_named(), before, "{file}");
    used.rusage.maxrss
}

#[cfg(unix)]
#[test]
fn what_is_no_plain_file_is_refused() {
    let bench = Bench::new();
    let link = |to: &str, name: &str| std::os::unix::fs::symlink(to, bench.path().join(name)).expect("a link");
    std::fs::create_dir(bench.path().join("folder.msh")).expect("a folder");
    for (device, name) in
        [("/dev/null", "null"), ("/dev/zero", "zero"), ("/dev/full", "full"), ("/dev/random", "random")]
    {
        link(device, &format!("{name}.msh"));
        link(device, &format!("{name}.toml"));
    }
    for name in ["pipe.msh", "pipe.toml"] {
        // No one writes to it: to open it would wait for ever.
        let made = Command::new("mkfifo").arg(name).current_dir(bench.path()).status();
        assert!(made.expect("mkfifo starts").success());
        link(name, &format!("to_{name}"));
    }
    for name in ["folder", "null", "zero", "full", "random", "pipe", "to_pipe"] {
        refused_soon(&bench, &format!("{name}.msh"), &[name, "is not a plain file", "give the path of a .msh file"]);
    }
    for name in ["null", "zero", "full", "random", "pipe", "to_pipe"] {
        refused_soon(&bench, &format!("{name}.toml"), &[name, "is not a plain file", "give the path of a scene"]);
    }
    for name in ["round.msh", "round.toml"] {
        link(name, name);
        refused_soon(&bench, name, &[name, "symbolic links"]);
    }
    for device in ["zero.msh", "pipe.msh"] {
        let mesh = ("../meshes/flexpde_shell.msh", device);
        bench.scene("02_flexpde_shell", &[mesh]);
        refused_soon(&bench, "scene.toml", &["mesh.file", device, "is not a plain file"]);
    }
}

#[cfg(unix)]
#[test]
fn what_may_not_be_read_is_told() {
    use std::os::unix::fs::PermissionsExt;
    let bench = Bench::new();
    for name in ["closed.msh", "closed.toml"] {
        bench.write(name, "$MeshFormat\n");
        let path = bench.path().join(name);
        std::fs::set_permissions(&path, std::fs::Permissions::from_mode(0o000)).expect("chmod");
        // The superuser may read it all the same.
        if std::fs::read(&path).is_err() {
            refused_soon(&bench, name, &[name, "ermission denied"]);
        }
        std::fs::remove_file(&path).expect("the file goes");
    }
}

#[test]
fn other_encodings_are_read_or_told() {
    let bench = Bench::new();
    let scene = edited("01_plain_ring", &[]);
    let utf16 = |text: &str| -> Vec<u8> { text.encode_utf16().flat_map(u16::to_le_bytes).collect() };
    bench.write("wide.toml", [vec![0xff, 0xfe], utf16(&scene)].concat());
    refused_soon(&bench, "wide.toml", &["wide.toml", "not UTF-8", "first wrong byte: 0"]);
    for (name, text) in [("marked", format!("\u{feff}{scene}")), ("windows", scene.replace('\n', "\r\n"))] {
        bench.write(&format!("{name}.toml"), text);
        let told = bench.run(&["check", &format!("{name}.toml")]);
        assert_eq!(told.status, 0, "{name}: {}", told.stderr);
    }
    let mesh = std::fs::read_to_string(repository().join("meshes/ring.msh")).expect("a text mesh");
    bench.write("wide.msh", [vec![0xff, 0xfe], utf16(&mesh)].concat());
    refused_soon(&bench, "wide.msh", &["wide.msh", "UTF-16"]);
    bench.write("marked.msh", format!("\u{feff}{mesh}"));
    assert_eq!(bench.run(&["check", "marked.msh"]).status, 0);
    bench.write("windows.msh", mesh.replace('\n', "\r\n"));
    assert_eq!(bench.run(&["check", "windows.msh"]).status, 0);
}

#[test]
fn other_forms_of_meshes_are_told_with_the_way_out() {
    let bench = Bench::new();
    let data = |name: &str| std::fs::read(repository().join("crates/mesh/tests/data").join(name)).expect("a mesh");
    for (name, word) in [
        ("old_1", "not a gmsh mesh file"),
        ("old_2.2", "the gmsh format 2.2"),
        ("old_4", "the gmsh format 4"),
        ("partitioned", "the mesh is partitioned"),
        ("cubic", "elements of order 3"),
        ("quads", "quadrangles"),
        ("volume", "volume elements"),
    ] {
        bench.write(&format!("{name}.msh"), data(&format!("{name}.msh")));
        refused_soon(&bench, &format!("{name}.msh"), &[name, word, "gmsh"]);
    }
    bench.write("great.msh", b"$MeshFormat\n4.1 1 8\n\0\0\0\x01\n$EndMeshFormat\n");
    refused_soon(&bench, "great.msh", &["big-endian", "Mesh.Binary = 0"]);
}

#[test]
fn a_scene_of_the_greatest_size_is_read_and_no_larger_one() {
    let bench = Bench::new();
    let scene = edited("01_plain_ring", &[]);
    let limit = oilwedge_scene::SCENE_LIMIT as usize;
    let padded = |length: usize| format!("{scene}\n#{}", "x".repeat(length - scene.len() - 2));
    bench.write("great.toml", padded(limit));
    let told = bench.run(&["check", "great.toml"]);
    assert_eq!(told.status, 0, "{}", told.stderr);
    bench.write("greater.toml", padded(limit + 1));
    refused_soon(&bench, "greater.toml", &["larger than 1048576 bytes"]);
}

#[test]
fn a_scene_of_a_megabyte_of_faults_is_refused_in_a_few_words() {
    let bench = Bench::new();
    let scene = edited("01_plain_ring", &[]);
    let many = |count: usize, line: &dyn Fn(usize) -> String| (0..count).map(line).collect::<String>();
    let hole = |k: usize| {
        format!("[[feed]]\ngroup=\"a{k}\"\npressure=\"{k} bar\"\nhole={{diameter=\"1 mm\",angle=\"0 deg\"}}\n")
    };
    let texts = [
        ("brackets", format!("a = {}", "[".repeat(100_000)), "not valid TOML"),
        ("braces", format!("a = {}", "{a = ".repeat(100_000)), "not valid TOML"),
        ("dotted", format!("{}a = 1", "a.".repeat(400_000)), "dotted.toml"),
        ("keys", many(80_000, &|k| format!("k{k} = 1\n")), "these are the first 100"),
        ("tables", many(80_000, &|k| format!("[k{k}]\n")), "these are the first 100"),
        ("feeds", scene.clone() + &"[[feed]]\n".repeat(100_000), "more than 1000"),
        ("holes", scene.clone() + &many(900, &hole), "overlaps \"a0\""),
        ("axes", format!("{scene}[sweep]\n{}", many(50_000, &|k| format!("oil.k{k} = [1]\n"))), "no sweep has more"),
        ("values", format!("{scene}[sweep]\nspeed = [{}]\n", "\"1 rpm\",".repeat(110_000)), "more than 100000"),
        ("word", format!("{scene}[cavitation]\nmodel = \"{}\"\n", "x".repeat(1_000_000)), "is not known"),
        ("text", scene.replacen("75 mm", &"x".repeat(1_000_000), 1), "does not begin with a number"),
        ("zeros", "\0".repeat(1_000_000), "zeros.toml"),
    ];
    for (name, text, word) in texts {
        let name = format!("{name}.toml");
        bench.write(&name, &text);
        let peak = refused_soon(&bench, &name, &[word]);
        assert!(peak < PROGRAM + 256 * text.len() as u64, "{name}: {peak}");
    }
}

/// Counts of a quintillion wherever a mesh file has a count: refused before anything is kept for them.
#[test]
fn a_count_of_a_quintillion_costs_nothing() {
    let bench = Bench::new();
    let text = std::fs::read_to_string(repository().join("crates/mesh/tests/data/plane_ring.msh")).expect("a mesh");
    let mut spoiled = 0;
    for section in ["$Entities\n", "$Nodes\n", "$Elements\n", "$Periodic\n"] {
        let start = text.find(section).expect(section) + section.len();
        let line = text[start..].lines().next().expect("counts");
        let words: Vec<&str> = line.split(' ').collect();
        for place in 0..words.len().min(2) {
            let mut words = words.clone();
            words[place] = "1000000000000000000";
            let file = [&text[..start], &words.join(" "), &text[start + line.len()..]].concat();
            bench.write("many.msh", file);
            let peak = refused_soon(&bench, "many.msh", &[section[1..].trim(), "line ", "1000000000000000000"]);
            assert!(peak < PROGRAM, "{section} {place}: {peak}");
            spoiled += 1;
        }
    }
    assert_eq!(spoiled, 7);
}

/// What reading and checking a mesh takes, over the size of its file. `docs/reference/mesh_files.md` states the bound.
#[test]
fn memory_is_a_small_multiple_of_the_file() {
    const HONEST: u64 = 6;
    const HOSTILE: u64 = 16;
    let bench = Bench::new();
    let header = "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n";
    let surface = "$Entities\n0 0 1 0\n1 0 0 0 1 1 0 1 1 0\n$EndEntities\n";
    let numbers = |count: usize, line: &str| line.repeat(count);
    let nodes = |count: usize, place: &str| {
        let tags: String = (1..=count).map(|tag| format!("{tag}\n")).collect();
        let places = numbers(count, place);
        format!("$Nodes\n1 {count} 1 {count}\n2 1 0 {count}\n{tags}{places}$EndNodes\n")
    };
    let elements = |count: usize, line: &str| {
        let lines = numbers(count, line);
        format!("$Elements\n1 {count} 1 {count}\n2 1 2 {count}\n{lines}$EndElements\n")
    };
    let names = |count: usize| {
        let lines: String = (1..=count).map(|tag| format!("2 {tag} \"\"\n")).collect();
        format!("$PhysicalNames\n{count}\n{lines}$EndPhysicalNames\n")
    };
    let some = nodes(3, "0 0 0\n");
    let files = [
        ("nodes", format!("{header}{surface}{}{}", nodes(300_000, "1 1 0\n"), elements(1, "1 1 2 3\n"))),
        ("not_numbers", format!("{header}{surface}{}{}", nodes(300_000, "nan 1 0\n"), elements(1, "1 1 2 3\n"))),
        ("repeated", format!("{header}{surface}{some}{}", elements(500_000, "1 1 1 1\n"))),
        ("crowded", format!("{header}{surface}{some}{}", elements(500_000, "1 1 2 3\n"))),
        ("names", format!("{header}{}{surface}{some}{}", names(300_000), elements(1, "1 1 2 3\n"))),
        ("blocks", format!("{header}{surface}{some}$Elements\n400000 1 1 1\n{}", numbers(400_000, "2 1 2 0\n"))),
        ("section", format!("{header}${}\n", "x".repeat(4_000_000))),
    ];
    for (name, text) in files {
        let name = format!("{name}.msh");
        bench.write(&name, &text);
        let peak = refused_soon(&bench, &name, &[&name]);
        assert!(peak < PROGRAM + HOSTILE * text.len() as u64, "{name}: {peak} of {}", text.len());
    }
    // Scene 09, drawn finer: the second makes 73 MB.
    for size in ["0.7 mm", "0.3 mm"] {
        bench.write(
            "fine.toml",
            edited("09_drawn_ring", &[]).replace("[journal]", &format!("[mesh]\nsize = \"{size}\"\n[journal]")),
        );
        let told = bench.run(&["mesh", "fine.toml", "-o", "fine.msh"]);
        assert_eq!(told.status, 0, "{}", told.stderr);
        let length = Path::metadata(&bench.path().join("fine.msh")).expect("a mesh").len();
        let mut child = oilwedge_command();
        let child = child.args(["check", "fine.msh"]).current_dir(bench.path()).stdout(Stdio::null());
        let used = child.spawn().and_then(|mut child| child.wait4()).expect("the program runs");
        assert!(used.status.success());
        let peak = used.rusage.maxrss;
        assert!(peak < PROGRAM + HONEST * length, "{peak} of {length}");
        std::fs::remove_file(bench.path().join("fine.msh")).expect("the file goes");
    }
}
