# SPDX-License-Identifier: MIT
"""The bill of materials names each package with its sum and the code of others in it."""
from __future__ import annotations

import json
import subprocess
import tempfile
import unittest
from pathlib import Path
from typing import Any, Dict, List

import stand_in  # first: it sets the path of the other modules
import check_sbom
import sbom

URLS = {  # file in the folder of packages -> its package URL
    "HrbfNpr.{}.nupkg": "pkg:nuget/HrbfNpr@{}",
    "hrbfnpr-{}-linux-x64.tar.gz": "pkg:generic/hrbfnpr@{}?file_name=hrbfnpr-{}-linux-x64.tar.gz",
    "hrbfnpr-{}-py3-none-win_amd64.whl": "pkg:pypi/hrbfnpr@{}?file_name=hrbfnpr-{}-py3-none-win_amd64.whl",
    "hrbfnpr-{}-source.tar.gz": "pkg:generic/hrbfnpr@{}?file_name=hrbfnpr-{}-source.tar.gz",
    "hrbfnpr-{}.tar.gz": "pkg:pypi/hrbfnpr@{}?file_name=hrbfnpr-{}.tar.gz",
    "hrbfnpr-{}.tgz": "pkg:npm/hrbfnpr@{}",
    "hrbfnpr-sys-{}.crate": "pkg:cargo/hrbfnpr-sys@{}",
    "libhrbfnpr1_{}_amd64.deb": "pkg:deb/debian/libhrbfnpr1@{}?arch=amd64",
    "python3-hrbfnpr_{}_all.deb": "pkg:deb/debian/python3-hrbfnpr@{}?arch=all",
}


class SbomTest(unittest.TestCase):
    def setUp(self) -> None:
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.release = stand_in.release(Path(folder.name), "linux-x64", "win-x64")
        for name in URLS:
            (self.release.dist / self.named(name)).write_text(name)
        # The versions of Debian's packages are those of the machine, which need not have all of them.
        versions = {"libglm-dev": "0.9.9.8+ds-6", "libhwy-dev": "1.0.3-3+deb12u1"}
        real, sbom.debian_version = sbom.debian_version, lambda package: versions.get(package, "12.2.0-14")
        self.addCleanup(setattr, sbom, "debian_version", real)

    def named(self, pattern: str) -> str:
        return pattern.replace("{}", self.release.version)

    def bill(self) -> Dict[str, Any]:
        (path,) = sbom.make(self.release)
        return json.loads(path.read_text(encoding="utf-8"))

    def test_each_file_has_its_sum_and_url(self) -> None:
        files = {part["name"]: part for part in self.bill()["components"] if part["type"] == "file"}
        self.assertEqual({name: part["purl"] for name, part in files.items()},
                         {self.named(name): self.named(url) for name, url in URLS.items()})
        for name, part in files.items():
            self.assertEqual(part["hashes"], [{"alg": "SHA-256", "content": sbom.sha256(self.release.dist / name)}])

    def inside(self, pattern: str) -> List[str]:
        """The names of the parts that a file depends on."""
        bill = self.bill()
        names = {part["bom-ref"]: part["name"] for part in bill["components"]}
        (node,) = [node for node in bill["dependencies"] if node["ref"] == self.named(pattern)]
        return sorted(names[ref] for ref in node["dependsOn"] if ref in names)

    def test_each_file_depends_on_the_code_inside_it(self) -> None:
        headers = ["Eigen", "GLM", "Highway", "JSON for Modern C++"]
        self.assertEqual(self.inside("hrbfnpr-{}-linux-x64.tar.gz"), [*headers, "libc++"])
        self.assertEqual(self.inside("libhrbfnpr1_{}_amd64.deb"), [*headers, "libc++"])
        self.assertEqual(self.inside("hrbfnpr-{}-py3-none-win_amd64.whl"), [*headers, "libstdc++", "winpthreads"])
        self.assertEqual(self.inside("HrbfNpr.{}.nupkg"), [*headers, "libc++", "libstdc++", "winpthreads"])
        self.assertEqual(self.inside("hrbfnpr-{}.tgz"), sorted([*headers, "Emscripten"]))
        for name in ("hrbfnpr-{}-source.tar.gz", "hrbfnpr-{}.tar.gz", "hrbfnpr-sys-{}.crate",
                     "python3-hrbfnpr_{}_all.deb"):
            self.assertEqual(self.inside(name), [])

    def test_versions_are_those_of_the_upstream_projects(self) -> None:
        versions = {part["name"]: part["version"] for part in self.bill()["components"] if part["type"] == "library"}
        self.assertEqual((versions["GLM"], versions["Highway"], versions["libstdc++"]), ("0.9.9.8", "1.0.3", "12.2.0"))

    def test_a_second_run_writes_the_same_bill(self) -> None:
        first = self.bill()
        self.assertEqual(self.bill(), first)
        self.assertEqual(first["metadata"]["timestamp"], "2023-11-14T22:13:20+00:00")
        (self.release.dist / self.named("hrbfnpr-{}.tgz")).write_text("another file")
        self.assertNotEqual(self.bill()["serialNumber"], first["serialNumber"])

    def test_the_graph_is_whole(self) -> None:
        self.assertEqual(list(check_sbom.reference_errors(self.bill())), [])

    def test_errors_of_the_graph_are_found(self) -> None:
        bill = self.bill()
        bill["components"].append(bill["components"][0])
        bill["dependencies"][0]["dependsOn"].append("nothing")
        self.assertEqual(len(list(check_sbom.reference_errors(bill))), 4)

    @unittest.skipUnless(check_sbom.can_read_schema(), "needs scripts/fetch_cyclonedx and python3-jsonschema")
    def test_the_bill_keeps_the_schema(self) -> None:
        bill = self.bill()
        self.assertEqual(check_sbom.schema_errors(bill), [])
        bill["components"][0]["hashes"][0]["alg"] = "SHA"
        self.assertEqual(len(check_sbom.schema_errors(bill)), 1)

    def test_sha256sum_reads_the_sums(self) -> None:
        sums = sbom.write_sums(self.release)
        self.assertEqual(len(sums.read_text().splitlines()), len(URLS))
        self.assertEqual(sbom.write_sums(self.release).read_text(), sums.read_text())
        subprocess.run(["sha256sum", "--check", "--quiet", "--strict", sums.name], cwd=sums.parent, check=True)


if __name__ == "__main__":
    stand_in.main("sha256sum")
