# SPDX-License-Identifier: MIT
"""Runs one part of the tests of bindings/js and examples/web:  run.py PART WORK

PART is readers, types, package, threads or page. WORK is a folder for temporary files. The status is 77 if a needed
program or build is missing; the output names it.
"""
import json
import os
import shutil
import subprocess
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]
SKIPPED = 77  # CTest's SKIP_RETURN_CODE
BUILDS = {"one thread": ROOT / "build" / "wasm", "threads": ROOT / "build" / "wasm-threads"}
PLAYWRIGHT = ROOT / ".cache" / "node_modules" / "playwright-core"


def skip(why):
    print(f"skipped: {why}")
    sys.exit(SKIPPED)


def need(program, package):
    path = shutil.which(program)
    return path or skip(f"there is no {program} here (Debian: {package})")


def need_module(name):
    if not (BUILDS[name] / "bindings" / "js" / "hrbfnpr.wasm").is_file():
        skip(f"there is no module with {name} in {BUILDS[name].relative_to(ROOT)}: scripts/web builds it")


def run(*command, **options):
    result = subprocess.run([str(part) for part in command], **options)
    if result.returncode != 0:
        sys.exit(result.returncode)


def node_version(node):
    return int(subprocess.check_output([node, "-p", "process.versions.node.split('.')[0]"], text=True))


def need_node(least):
    node = need("node", "nodejs")
    if node_version(node) < least:
        skip(f"node is older than {least}")
    return node


def readers(work):
    run(need_node(18), "--test", HERE / "readers.test.mjs", HERE / "settings.test.mjs")


def types(work):
    """Correct uses of the package's types compile, and wrong uses do not."""
    tsc = need("tsc", "node-typescript")
    modules = work / "node_modules" / "hrbfnpr"
    shutil.copytree(ROOT / "bindings" / "js" / "src", modules / "src")
    shutil.copy(ROOT / "bindings" / "js" / "package.json", modules)
    shutil.copy(HERE / "types.mts", work)
    options = {"strict": True, "noEmit": True, "target": "es2022", "module": "nodenext", "moduleResolution": "nodenext",
               "lib": ["es2022", "dom"], "types": [], "skipLibCheck": False}
    (work / "tsconfig.json").write_text(json.dumps({"compilerOptions": options, "files": ["types.mts"]}))
    run(tsc, "-p", work)


def installed(work):
    """Installs the package from its tarball with npm, without a network."""
    npm = need("npm", "npm")
    packed = subprocess.check_output([sys.executable, ROOT / "bindings" / "js" / "package.py", "pack", work / "package"],
                                     text=True).strip()
    (work / "package.json").write_text('{ "private": true, "type": "module" }')
    run(npm, "install", "--offline", "--no-audit", "--no-fund", "--loglevel=error", packed, cwd=work)
    print(f"{Path(packed).name}: {Path(packed).stat().st_size / 1e6:.2f} MB")


def in_package(work, name, build):
    node = need_node(18)
    need_module(build)
    installed(work)
    for path in HERE.glob("*.mjs"):
        shutil.copy(path, work)
    run(node, f"{name}.test.mjs", cwd=work, env={**os.environ, "HRBFNPR_SOURCE": str(ROOT)})


def package(work):
    in_package(work, "package", "one thread")
    example = ROOT / "examples" / "quickstart.mjs"
    shutil.copy(example, work)
    run(need_node(18), example.name, cwd=work)
    if (work / "torus.svg").read_text(encoding="utf-8").count("<path") < 100:
        sys.exit("examples/quickstart.mjs leaves no drawing in torus.svg")


def threads(work):
    in_package(work, "threads", "threads")


def page(work):
    node = need_node(18)
    need_module("one thread")
    chromium = shutil.which("chromium") or shutil.which("chromium-browser") or need("google-chrome", "chromium")
    if not PLAYWRIGHT.is_dir():
        skip("there is no playwright-core: run scripts/fetch_playwright")
    folder = work / "page"
    run(ROOT / "examples" / "web" / "build", folder)
    for options, names in (([], ["threads"]), (["--one-thread"], ["page"])):
        if names == ["threads"] and not (folder / "hrbfnpr" / "wasm-threads").is_dir():
            print("the page with threads is left out: scripts/web builds them")
            continue
        with serving(folder, options) as address:
            run(node, HERE / f"{names[0]}_page.mjs", address, chromium, work,
                env={**os.environ, "NODE_PATH": str(PLAYWRIGHT.parent), "PLAYWRIGHT": str(PLAYWRIGHT)})


class serving:
    """Runs examples/web/serve during a `with` block and gives the address."""

    def __init__(self, folder, options):
        self.command = [sys.executable, ROOT / "examples" / "web" / "serve", "--folder", folder, "--port", "0", *options]

    def __enter__(self):
        self.server = subprocess.Popen([str(part) for part in self.command], stdout=subprocess.PIPE, text=True)
        return self.server.stdout.readline().strip()

    def __exit__(self, *_):
        self.server.terminate()
        self.server.wait()


def main():
    part, work = sys.argv[1], Path(sys.argv[2]).resolve()
    shutil.rmtree(work, ignore_errors=True)
    work.mkdir(parents=True)
    {"readers": readers, "types": types, "package": package, "threads": threads, "page": page}[part](work)


if __name__ == "__main__":
    main()
