"""Prints the tests that CTest skipped, each with the last words it said.

    skipped_tests.py JUNIT.XML
"""

import sys
import xml.etree.ElementTree as ElementTree


def reason(case):
    said = [line.strip() for line in (case.findtext("system-out") or "").splitlines() if line.strip()]
    told = [line for line in said if "skip" in line.lower() and not line.startswith("[")]
    skip = case.find("skipped")
    return (told or said or [skip.get("message", "no reason given") if skip is not None else "disabled"])[-1]


def main():
    cases = ElementTree.parse(sys.argv[1]).getroot().iter("testcase")
    skipped = [case for case in cases if case.get("status") in ("notrun", "disabled")]
    if skipped:
        print(f"\n{len(skipped)} skipped:")
    for case in skipped:
        print(f"  {case.get('name')}: {reason(case)}")


if __name__ == "__main__":
    main()
