# SPDX-License-Identifier: MIT
"""Runs cases of ablation_cases.py with changed constants. scripts/ablate.py sends a line of JSON for each to the standard input.

    ablation_worker.py FOLDER THREADS        answers {"case", "set", "back"} with {"changes", "seconds"}
    ablation_worker.py FOLDER --used CASE    prints the constants that a case reads
"""

import ctypes
import json
import os
import pickle
import sys
import time
import warnings
from pathlib import Path
from typing import Any, Dict

import ablation_cases
import hrbfnpr

library = ctypes.CDLL(os.environ["HRBFNPR_LIBRARY"])
library.hrbfnpr_tune.argtypes = [ctypes.c_char_p, ctypes.c_double]
library.hrbfnpr_tuned.restype = ctypes.c_char_p


def put(values: Dict[str, float]) -> None:
    for name, value in values.items():
        if library.hrbfnpr_tune(name.encode(), value) != 1:
            raise KeyError(name)


def measured(case: str, kept: ablation_cases.Kept) -> Dict[str, Any]:
    """Runs a case. Returns its result and its seconds. An error of the library is a result, too."""
    begin = time.process_time()
    try:
        result = ablation_cases.summary(ablation_cases.CASES[case](kept))
    except (hrbfnpr.Error, ValueError) as error:
        result = {"error": str(error)}
    return {"result": result, "seconds": time.process_time() - begin}


def usual(case: str, kept: ablation_cases.Kept, folder: Path) -> Dict[str, Any]:
    """Returns the result of a case with unchanged constants, and caches it in a file. The first run only fills caches."""
    file = folder / f"{case}.pickle"
    if not file.exists():
        measured(case, kept)
        file.write_bytes(pickle.dumps(measured(case, kept)))
    found: Dict[str, Any] = pickle.loads(file.read_bytes())
    return found


def main() -> None:
    folder = Path(sys.argv[1])
    warnings.simplefilter("ignore")
    kept = ablation_cases.Kept(folder)
    if sys.argv[2] == "--used":
        hrbfnpr.set_default_context(hrbfnpr.Context(thread_count=1))
        ablation_cases.CASES[sys.argv[3]](kept)
        print(library.hrbfnpr_tuned().decode(), end="")
        return
    hrbfnpr.set_default_context(hrbfnpr.Context(thread_count=int(sys.argv[2])))
    warm: Dict[str, Any] = {}
    for line in sys.stdin:
        asked = json.loads(line)
        case = asked["case"]
        if case not in warm:
            warm[case] = usual(case, kept, folder)
        put(asked["set"])
        after = measured(case, kept)
        put(asked["back"])
        changes = ablation_cases.changes(warm[case]["result"], after["result"])
        print(json.dumps({"changes": changes, "seconds": after["seconds"], "usual": warm[case]["seconds"]}), flush=True)


if __name__ == "__main__":
    main()
