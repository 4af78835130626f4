# SPDX-License-Identifier: MIT
"""Rust with the crate hrbfnpr-sys: a picture, a callback and an error (rust.rs), and the example of its README."""

import os
import re
import shutil

import run

NAME = "Rust"
BY_STEPS = True  # tests more of the raw declarations than hrbfnpr_picture_create needs
CRATE = run.ROOT / "bindings" / "rust" / "hrbfnpr-sys"
OLDEST = 63  # the minor version of rust-version in Cargo.toml
EXAMPLE_SAYS = "1 of 2 points lie inside\n"


def version():
    said = run.run([run.need("rustc", "rustc"), "--version"]).split()[1]
    if int(said.split(".")[1]) < OLDEST:
        raise run.Missing(f"rustc is {said}, and the crate needs 1.{OLDEST} (Debian: rustc)")
    return said


def build_script(work, library):
    """The options that build.rs gives cargo, for rustc. Also checks that it refuses a folder without the library."""
    script = work / "build-script"
    run.run(["rustc", "--edition", "2021", CRATE / "build.rs", "-o", script])
    try:
        run.run([script], env={**os.environ, "HRBFNPR_LIB_DIR": str(work)})
    except run.Failed as refused:
        if "where there is none of libhrbfnpr.so" not in str(refused):
            raise
    else:
        raise run.Failed("build.rs takes a folder without the library")
    options = {"rustc-link-search": "-L", "rustc-link-lib": "-l",
               "rustc-cfg": "--cfg", "rustc-check-cfg": "--check-cfg"}
    said = run.run([script], env={**os.environ, "HRBFNPR_LIB_DIR": str(library.parent)})
    found = [re.match(r"cargo:([\w-]+)=(.*)$", line).groups() for line in said.splitlines()]
    return [part for key, value in found if key in options for part in (options[key], value)]


def example(work):
    """Writes the program of README.md to a file."""
    text = (CRATE / "README.md").read_text(encoding="utf-8")
    program = work / "example.rs"
    program.write_text(re.search(r"^```rust\n(.*?)^```$", text, re.DOTALL | re.MULTILINE).group(1), encoding="utf-8")
    return program


def with_cargo(work, library, program):
    """Builds the program as a package that depends on the crate, without a network."""
    if shutil.which("cargo") is None:
        print("there is no cargo here: Cargo.toml is not tested")
        return
    package = work / "package"
    shutil.copytree(CRATE, work / "hrbfnpr-sys")
    (package / "src").mkdir(parents=True)
    shutil.copy(program, package / "src" / "main.rs")
    (package / "Cargo.toml").write_text(
        '[package]\nname = "example"\nversion = "0.0.0"\nedition = "2021"\n\n'
        '[dependencies]\nhrbfnpr-sys = { path = "../hrbfnpr-sys" }\n')
    values = {**os.environ, "HRBFNPR_LIB_DIR": str(library.parent), "LD_LIBRARY_PATH": str(library.parent)}
    said = run.run(["cargo", "run", "--offline", "--quiet"], cwd=package, env=values)
    if said != EXAMPLE_SAYS:
        raise run.Failed(f"cargo run said:\n{said}")


def draw(work, library, examples):
    options = ["--edition", "2021", "-D", "warnings"]
    crate = ["rustc", *options, "--crate-type", "rlib", "--crate-name", "hrbfnpr_sys", CRATE / "src" / "lib.rs"]
    run.run([*crate, *build_script(work, library), "--out-dir", work])
    picture, loaded = work / "picture.rgba", {**os.environ, "LD_LIBRARY_PATH": str(library.parent)}
    said = {}
    client = run.ROOT / "tests" / "clients" / "rust.rs"
    for source, arguments in ((client, [run.SAMPLES, picture]), (example(work), [])):
        program = work / f"{source.stem}-program"
        run.run(["rustc", *options, source, "--crate-name", "program", "--extern",
                 f"hrbfnpr_sys={work / 'libhrbfnpr_sys.rlib'}", "-L", library.parent, "-o", program])
        said[source.stem] = run.run([program, *arguments], env=loaded)
    if said["example"] != EXAMPLE_SAYS:
        raise run.Failed(f"the example of README.md said:\n{said['example']}")
    with_cargo(work, library, work / "example.rs")
    return picture
