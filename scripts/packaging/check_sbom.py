# SPDX-License-Identifier: MIT
"""Checks a bill of materials against the schema of CycloneDX 1.5 and for references without a component.

    check_sbom.py FILE    prints each error and returns 1 if there is one, or 77 if the schema cannot be read

scripts/fetch_cyclonedx fetches the schema, and Debian's package python3-jsonschema applies it.
"""
from __future__ import annotations

import json
import sys
from importlib.util import find_spec
from pathlib import Path
from typing import Any, Dict, Iterator, List

from common import ROOT

SCHEMAS = ROOT / ".cache" / "cyclonedx"
SKIPPED = 77  # CTest's SKIP_RETURN_CODE


def can_read_schema() -> bool:
    return SCHEMAS.is_dir() and find_spec("jsonschema") is not None


def schema_errors(bill: Dict[str, Any]) -> List[str]:
    """Return the places that break the schema."""
    import jsonschema

    schemas = {name: json.loads((SCHEMAS / f"{name}.SNAPSHOT.schema.json").read_text(encoding="utf-8"))
               for name in ("bom-1.5", "spdx", "jsf-0.82")}
    main = schemas["bom-1.5"]
    folder = main["$id"].rpartition("/")[0]
    known = {f"{folder}/{name}.SNAPSHOT.schema.json": schema for name, schema in schemas.items()}
    validator = jsonschema.Draft7Validator(main, resolver=jsonschema.RefResolver(main["$id"], main, store=known))
    return [f"{'/'.join(map(str, error.absolute_path))}: {error.message}" for error in validator.iter_errors(bill)]


def reference_errors(bill: Dict[str, Any]) -> Iterator[str]:
    """Find names that are not unique, and names in the graph of dependencies without a component."""
    components = [bill["metadata"]["component"], *bill["components"]]
    known = [component["bom-ref"] for component in components]
    yield from (f"{name} is the name of two components" for name in known if known.count(name) > 1)
    nodes = [node["ref"] for node in bill["dependencies"]]
    if sorted(nodes) != sorted(known):
        yield "the graph and the list do not have the same components"
    for node in bill["dependencies"]:
        yield from (f"{node['ref']} depends on {name}, which is no component"
                    for name in node["dependsOn"] if name not in known)


def main() -> int:
    bill = json.loads(Path(sys.argv[1]).read_text(encoding="utf-8"))
    readable = can_read_schema()
    errors = [*reference_errors(bill), *(schema_errors(bill) if readable else [])]
    print("\n".join(errors) or "no errors")
    if not readable:
        print("the schema was not applied: run scripts/fetch_cyclonedx and install python3-jsonschema")
    return 1 if errors else 0 if readable else SKIPPED


if __name__ == "__main__":
    sys.exit(main())
