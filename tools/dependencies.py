"""Writes the bill of materials (CycloneDX) of a release, and the licence texts of what is compiled into it.

Packages are those of the registry that the program and the Python module reach by normal dependencies on one platform,
as `cargo metadata` resolves them; macros and what runs while compiling are left out, for nothing of them is in a
binary.
"""

import argparse
import json
import re
import subprocess
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
PROGRAMS = ("oilwedge", "oilwedge-python")
"""What is handed out."""
LICENCE_FILES = re.compile(r"(LICEN[CS]E|COPYING|COPYRIGHT|NOTICE|UNLICENSE|OFL)", re.IGNORECASE)
STANDARD_LIBRARY = "The standard library of Rust: MIT OR Apache-2.0, copyright The Rust Project contributors."


def metadata(target):
    """What cargo knows of the workspace on a platform, packages and edges of the graph by their id."""
    command = ["cargo", "metadata", "--locked", "--format-version", "1", "--filter-platform", target]
    found = json.loads(subprocess.run(command, cwd=ROOT, check=True, stdout=subprocess.PIPE).stdout)
    edges = {
        node["id"]: [d["pkg"] for d in node["deps"] if any(kind["kind"] is None for kind in d["dep_kinds"])]
        for node in found["resolve"]["nodes"]
    }
    return {package["id"]: package for package in found["packages"]}, edges


def linked(packages, edges):
    """Ids of the packages that are in the programs, in the order of name and version."""
    open_ids = [identity for identity, package in packages.items() if package["name"] in PROGRAMS]
    reached = set()
    while open_ids:
        identity = open_ids.pop()
        is_macro = any("proc-macro" in target["kind"] for target in packages[identity]["targets"])
        if identity not in reached and not is_macro:
            reached.add(identity)
            open_ids += edges[identity]
    return sorted(reached, key=lambda identity: (packages[identity]["name"], packages[identity]["version"]))


def checksums():
    """SHA-256 of the packages of the registry, by name and version."""
    entry = re.compile(r'name = "(.*)"\nversion = "(.*)"\nsource = ".*"\nchecksum = "(.*)"')
    return {(name, version): digest for name, version, digest in entry.findall((ROOT / "Cargo.lock").read_text("utf-8"))}


def expression(package):
    """The licence as SPDX writes it; some old packages have a slash for OR."""
    return package["license"].replace("/", " OR ")


def component(package, digests):
    """A package in the words of CycloneDX."""
    name, version = package["name"], package["version"]
    place = f"pkg:cargo/{name}@{version}"
    entry = {"type": "library", "bom-ref": place, "name": name, "version": version, "purl": place}
    if (name, version) in digests:
        entry["hashes"] = [{"alg": "SHA-256", "content": digests[name, version]}]
    return entry | {"licenses": [{"expression": expression(package)}]}


def bill(packages, edges, ids):
    """The bill of materials: the program, what it is made of, and who asks for what. Equal sources give equal bytes."""
    digests = checksums()
    parts = {identity: component(packages[identity], digests) for identity in ids}
    program = next(part for part in parts.values() if part["name"] == PROGRAMS[0])
    graph = [
        {"ref": parts[identity]["bom-ref"], "dependsOn": sorted(parts[it]["bom-ref"] for it in edges[identity] if it in parts)}
        for identity in ids
    ]
    return {
        "bomFormat": "CycloneDX",
        "specVersion": "1.5",
        "version": 1,
        "metadata": {"component": program | {"type": "application"}},
        "components": [part for part in parts.values() if part is not program],
        "dependencies": graph,
    }


def licences(packages, ids):
    """All licence texts, each once, below the names of the packages that carry it."""
    carriers, without = {}, []
    for package in (packages[identity] for identity in ids if packages[identity]["source"]):
        title = f"{package['name']} {package['version']}: {expression(package)}"
        folder = Path(package["manifest_path"]).parent
        files = [file for file in sorted(folder.rglob("*")) if file.is_file() and LICENCE_FILES.match(file.name)]
        # Sources are named for what they do, as `license.rs`.
        texts = {file.read_text("utf-8", "replace").strip() for file in files if file.suffix in ("", ".md", ".txt")}
        for text in sorted(texts):
            carriers.setdefault(text, []).append(title)
        if not texts:
            without.append(f"{title}, by {', '.join(package['authors'])}")
    rule = "\n\n" + "=" * 80 + "\n"
    parts = ["Packages that are compiled into oilwedge, and their licences.\n\n" + STANDARD_LIBRARY]
    parts += ["\n".join(titles) + "\n\n" + text for text, titles in carriers.items()]
    parts.append("Packages that come without the text of their licence:\n" + "\n".join(without))
    return rule.join(parts) + "\n"


def main():
    asked = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    asked.add_argument("--target", required=True, help="platform, as rustc -vV names it")
    asked.add_argument("--sbom", required=True, type=Path, help="file of the bill of materials")
    asked.add_argument("--licences", required=True, type=Path, help="file of the licence texts")
    arguments = asked.parse_args()
    packages, edges = metadata(arguments.target)
    ids = linked(packages, edges)
    bom = json.dumps(bill(packages, edges, ids), indent=1, ensure_ascii=False)
    arguments.sbom.write_text(bom + "\n", "utf-8")
    arguments.licences.write_text(licences(packages, ids), "utf-8")


if __name__ == "__main__":
    main()
