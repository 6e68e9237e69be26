#!/usr/bin/env bash
# Builds what is handed out of a release, into one folder. It needs Rust, Python with venv and binutils; maturin is
# installed below target/.
set -euo pipefail

usage="usage: tools/release.sh [--out DIR]

Builds into DIR (dist/ beside Cargo.toml if it is not given), in the target folder and profile of \`cargo build --release\`:
  oilwedge-VERSION-PLATFORM.tar.gz  the program, stripped, with manual pages, completions of shells and licences
  oilwedge-VERSION-*.whl            the Python package, compiled
  oilwedge-VERSION.tar.gz           the Python package as source
  oilwedge-VERSION.cdx.json         the bill of materials (CycloneDX)
  SHA256SUMS                        checksums of all of these
DIR is emptied of files of these names first."

fail() {
    echo "tools/release.sh: $1" >&2
    exit 2
}

# The program of this name, or what installs it.
need() {
    command -v "$1" >/dev/null || fail "$1 is missing: $2"
}

out=
while [ $# -gt 0 ]; do
    case "$1" in
        -h | --help) echo "$usage" && exit ;;
        --out) [ $# -gt 1 ] || fail "--out needs a folder" && out=$2 && shift 2 ;;
        *) fail "$1 is unknown; tools/release.sh --help lists what there is" ;;
    esac
done
here=$(cd "$(dirname "$0")/.." && pwd)
out=${out:-$here/dist}

system=$(uname -s)
need cargo "install Rust 1.95 or later"
need tar "apt-get install tar"
python=$(command -v python3 || command -v python) || fail "python3 is missing: apt-get install python3 python3-venv"
"$python" -c "import ensurepip, venv" || fail "the venv of Python is missing: apt-get install python3-venv"
[ "$system" != Linux ] || need strip "apt-get install binutils"
[ "$system" != Linux ] || need ldd "apt-get install libc-bin"

mkdir -p "$out" "${CARGO_TARGET_DIR:=$here/target}"
out=$(cd "$out" && pwd)
CARGO_TARGET_DIR=$(cd "$CARGO_TARGET_DIR" && pwd)
export CARGO_TARGET_DIR
cd "$here"

version=$(cargo pkgid --package oilwedge)
version=${version##*[#@]}
platform=$(rustc -vV | sed -n 's/^host: //p')
ending=
case "$platform" in *windows*) ending=.exe ;; esac
name=oilwedge-$version-$platform
# What an earlier run has left.
rm -f "$out"/oilwedge-*.tar.gz "$out"/oilwedge-*.whl "$out"/oilwedge-*.cdx.json "$out/SHA256SUMS"

# The program. All crates are named, for features then are those of the tests too, and no dependency is compiled twice.
cargo build --release --locked --workspace --bin oilwedge
stage=$CARGO_TARGET_DIR/handout
rm -rf "$stage"
mkdir -p "$stage/$name/completions" "$stage/$name/licences"
program=$stage/$name/oilwedge$ending
cp "$CARGO_TARGET_DIR/release/oilwedge$ending" "$program"
# Programs of Windows hold no symbols.
[ -n "$ending" ] || strip "$program"
if [ "$system" = Linux ]; then
    # Every machine has glibc and the library of GCC that unwinds.
    others=$(ldd "$program" | grep -vE '^\s*(linux-vdso|libgcc_s|libc|libm|/\S*/ld-linux\S*)\.so' || true)
    [ -z "$others" ] || fail "the program needs more libraries than glibc and libgcc_s:
$others"
fi
"$program" man --out "$stage/$name/man/man1"
for shell in bash elvish fish powershell zsh; do
    "$program" completions "$shell" >"$stage/$name/completions/oilwedge.$shell"
done
cp LICENSE-MIT LICENSE-APACHE "$stage/$name/licences"
"$python" tools/dependencies.py --target "$platform" --sbom "$out/oilwedge-$version.cdx.json" \
    --licences "$stage/$name/licences/dependencies.txt"
tar -czf "$out/$name.tar.gz" -C "$stage" "$name"

# The Python package, by the maturin that the tests use.
maturin=$(grep '^maturin==' tests/crosscheck/requirements.txt)
tools=$CARGO_TARGET_DIR/release-venv
programs=$tools/bin
[ -x "$programs/python" ] || "$python" -m venv "$tools"
[ -d "$programs" ] || programs=$tools/Scripts
"$programs/python" -m pip install --quiet --disable-pip-version-check "$maturin"
# It carries the licences and the bill of materials too: pyproject.toml takes what lies in this folder.
licences=crates/python/licences
trap 'rm -rf "$here/$licences"' EXIT
mkdir -p "$licences"
cp LICENSE-MIT LICENSE-APACHE "$licences"
"$programs/maturin" sdist --manifest-path crates/python/Cargo.toml --out "$out"
cp "$stage/$name/licences/dependencies.txt" "$licences"
"$programs/maturin" build --release --locked --interpreter "$programs/python" --manifest-path crates/python/Cargo.toml \
    --sbom-include "$out/oilwedge-$version.cdx.json" --out "$out"

cd "$out"
sum=$(command -v sha256sum || echo "shasum -a 256")
$sum oilwedge-* >SHA256SUMS
wc -c oilwedge-* SHA256SUMS | awk '$2 != "total" { printf "%9.1f kB  %s\n", $1 / 1000, $2 }'
