# SPDX-License-Identifier: MIT
"""Writes the bill of materials of all packages, as CycloneDX 1.5, and the file of their SHA-256 sums.

Call make() after all other packages are made, and write_sums() last.
"""
from __future__ import annotations

import hashlib
import json
import re
import uuid
from dataclasses import dataclass
from datetime import datetime, timezone
from pathlib import Path
from typing import Any, Dict, List, Sequence, Tuple
from urllib.parse import quote

from common import HEADERS, PLATFORMS, Release, run

SUMS = "SHA256SUMS"
ZIG = "0.11.0"  # the toolchain of Linux and macOS
LLVM_OF_ZIG = "16.0.1"  # the version of the libc++ in it, by its _LIBCPP_VERSION


@dataclass(frozen=True)
class Part:
    """Code of a third party that packages contain, or a compiler."""

    name: str  # the name of the section in THIRD-PARTY-NOTICES.md
    licence: str  # an SPDX expression
    source: str  # the Debian package that it comes from, or "zig"
    publisher: str = ""

    @property
    def version(self) -> str:
        """The upstream version: that of the Debian package without epoch and revision."""
        if self.source == "zig":
            return LLVM_OF_ZIG
        return re.split(r"[-+~]", debian_version(self.source).split(":")[-1])[0]

    @property
    def reference(self) -> str:
        """The package URL, which also names the part in the bill."""
        if self.source == "zig":
            return f"pkg:generic/libc%2B%2B@{LLVM_OF_ZIG}?zig={ZIG}"
        return f"pkg:deb/debian/{quote(self.source, safe='')}@{quote(debian_version(self.source), safe='')}"


PARTS: Dict[str, Part] = {
    part.name: part
    for part in (
        Part("Eigen", "MPL-2.0", "libeigen3-dev", "Eigen authors"),
        Part("GLM", "MIT", "libglm-dev", "G-Truc Creation"),
        Part("Highway", "Apache-2.0", "libhwy-dev", "Google LLC"),
        Part("JSON for Modern C++", "MIT", "nlohmann-json3-dev", "Niels Lohmann"),
        Part("libc++", "Apache-2.0 WITH LLVM-exception", "zig", "LLVM contributors"),
        Part("libstdc++", "GPL-3.0-or-later WITH GCC-exception-3.1", "g++-mingw-w64-x86-64-posix",
             "Free Software Foundation, Inc."),
        Part("winpthreads", "MIT AND BSD-3-Clause", "mingw-w64-x86-64-dev", "mingw-w64 project"),
        Part("Emscripten", "MIT AND Apache-2.0 WITH LLVM-exception", "emscripten", "Emscripten authors"),
    )
}
COMPILERS = {"libc++": "zig", "libstdc++": "g++-mingw-w64-x86-64-posix", "Emscripten": "emscripten"}  # by runtime
VERSION = r"[\d.]+"
# The first pattern that a file's name matches gives its package URL. A name in the URL is that of the pattern's groups.
PACKAGE_URLS: Sequence[Tuple[str, str]] = (
    (rf"hrbfnpr-{VERSION}.*\.whl|hrbfnpr-{VERSION}\.tar\.gz", "pkg:pypi/hrbfnpr@{version}?file_name={file}"),
    (rf"(?P<name>.+)_{VERSION}_(?P<arch>\w+)\.deb", "pkg:deb/debian/{name}@{version}?arch={arch}"),
    (rf"(?P<name>.+?)\.{VERSION}\.nupkg", "pkg:nuget/{name}@{version}"),
    (rf"(?P<name>.+?)-{VERSION}\.tgz", "pkg:npm/{name}@{version}"),
    (rf"(?P<name>.+?)-{VERSION}\.crate", "pkg:cargo/{name}@{version}"),
    (".*", "pkg:generic/hrbfnpr@{version}?file_name={file}"),
)


def debian_version(package: str) -> str:
    return run("dpkg-query", "-W", "-f=${Version}", package, quiet=True)


def make(release: Release) -> List[Path]:
    path = release.dist / f"hrbfnpr-{release.version}.cdx.json"
    files = [file for file in package_files(release) if file != path]
    path.write_text(json.dumps(bill(release, files), indent=2, ensure_ascii=False) + "\n", encoding="utf-8")
    return [path]


def write_sums(release: Release) -> Path:
    """Write the sums as `sha256sum --check` reads them."""
    path = release.dist / SUMS
    path.write_text("".join(f"{sha256(file)}  {file.name}\n" for file in package_files(release)), encoding="utf-8")
    return path


def package_files(release: Release) -> List[Path]:
    return sorted(path for path in release.dist.iterdir() if path.is_file() and path.name != SUMS)


def sha256(path: Path) -> str:
    return hashlib.sha256(path.read_bytes()).hexdigest()


def bill(release: Release, files: Sequence[Path]) -> Dict[str, Any]:
    """Return the whole bill.  The library depends on the headers, and each file on the code of others inside it."""
    inside = {file: parts_inside(release, file.name) for file in files}
    used = [name for name in PARTS if name in HEADERS or any(name in parts for parts in inside.values())]
    library = f"pkg:generic/hrbfnpr@{release.version}"
    main = {"type": "library", "bom-ref": library, "name": "hrbfnpr", "version": release.version, "purl": library,
            "licenses": [{"license": {"id": "MIT"}}]}
    packages = [file_component(release, file) for file in files]
    references = {name: PARTS[name].reference for name in used}
    dependencies = {library: [references[name] for name in HEADERS]}
    for component, parts in zip(packages, inside.values()):
        dependencies[component["bom-ref"]] = [library, *(references[name] for name in parts)]
    dependencies.update({reference: [] for reference in references.values()})
    sums = "".join(component["hashes"][0]["content"] for component in packages)
    return {
        "$schema": "http://cyclonedx.org/schema/bom-1.5.schema.json", "bomFormat": "CycloneDX", "specVersion": "1.5",
        "serialNumber": f"urn:uuid:{uuid.uuid5(uuid.NAMESPACE_URL, f'{library}#{sums}')}", "version": 1,
        "metadata": {
            "timestamp": datetime.fromtimestamp(release.epoch, timezone.utc).isoformat(), "component": main,
            "lifecycles": [{"phase": "build"}],
        },
        "components": [*packages, *(part_component(PARTS[name]) for name in used)],
        "dependencies": [{"ref": ref, "dependsOn": sorted(needed)} for ref, needed in dependencies.items()],
        "formulation": [{"components": [compiler(COMPILERS[name]) for name in used if name in COMPILERS]}],
    }


def parts_inside(release: Release, name: str) -> Tuple[str, ...]:
    """Return the parts that are inside the package with this file name."""
    if re.search(r"^libhrbfnpr-dev_|_all\.deb$|\.crate$|-source\.|amalgamat|hrbfnpr-[\d.]+\.tar\.gz$", name):
        return ()
    if re.match(r"hrbfnpr-[\d.]+\.tgz", name):  # the npm package
        return (*HEADERS, "Emscripten")
    ours = [PLATFORMS[rid] for rid in release.natives]
    named = [platform for platform in ours if re.search(
        rf"-{platform.rid}\.|{platform.wheel_tag}|_{platform.debian or 'no'}\.deb", name)]
    runtimes = [runtime for platform in named or ours for runtime in platform.runtimes]
    return (*HEADERS, *(name for name in PARTS if name in runtimes))


def file_component(release: Release, file: Path) -> Dict[str, Any]:
    return {"type": "file", "bom-ref": file.name, "name": file.name, "version": release.version,
            "hashes": [{"alg": "SHA-256", "content": sha256(file)}], "licenses": [{"license": {"id": "MIT"}}],
            "purl": package_url(release, file.name)}


def package_url(release: Release, name: str) -> str:
    for pattern, url in PACKAGE_URLS:
        found = re.fullmatch(pattern, name)
        if found:
            return url.format(version=release.version, file=quote(name), **found.groupdict())
    raise ValueError(name)


def part_component(part: Part) -> Dict[str, Any]:
    return {"type": "library", "bom-ref": part.reference, "publisher": part.publisher, "name": part.name,
            "version": part.version, "licenses": [{"expression": part.licence}], "purl": part.reference}


def compiler(source: str) -> Dict[str, Any]:
    version = ZIG if source == "zig" else debian_version(source)
    return {"type": "application", "bom-ref": f"compiler:{source}", "name": source, "version": version}
