# SPDX-License-Identifier: MIT
"""Prints results that the summary of CTest leaves out: each client with its version and result, and why tests were skipped.

    report_tests.py JUNIT.XML
    report_tests.py JUNIT.XML --longer SECONDS      names the tests that took longer, for LONG in their CMakeLists.txt
"""

import sys
import xml.etree.ElementTree as ElementTree


def said(case):
    return [line.strip() for line in (case.findtext("system-out") or "").splitlines() if line.strip()]


def reason(case):
    lines = said(case)
    told = [line for line in lines if "skip" in line.lower() and not line.startswith("[")]
    skip = case.find("skipped")
    return (told or lines or [skip.get("message", "no reason given") if skip is not None else "disabled"])[-1]


def clients(cases):
    """Yields for each test of a client (tests/clients/run.py) its name with the version, and the result."""
    for case in cases:
        name = case.get("name")
        if name.startswith("clients."):
            lines = [line for line in said(case) if line.startswith("client ")]
            title, _, result = (lines or [f"client {name.partition('.')[2]}: failed"])[-1][7:].rpartition(": ")
            yield title, result


def long_tests(cases, seconds):
    return sorted(case.get("name") for case in cases if float(case.get("time") or 0) > seconds)


def main():
    cases = list(ElementTree.parse(sys.argv[1]).getroot().iter("testcase"))
    if sys.argv[2:3] == ["--longer"]:
        print("\n".join(long_tests(cases, float(sys.argv[3]))))
        return
    table = list(clients(cases))
    if table:
        width = max(len(title) for title, _ in table)
        print("\nclients, and whether each draws the same picture as the C program:")
        for title, result in table:
            print(f"  {title:{width}}  {result}")
    skipped = [case for case in cases if case.get("status") in ("notrun", "disabled")]
    if skipped:
        print(f"\n{len(skipped)} skipped:")
    for case in skipped:
        print(f"  {case.get('name')}: {reason(case)}")


if __name__ == "__main__":
    main()
