# SPDX-License-Identifier: MIT
"""A host with its own job system."""

import re

import run

NAME = "Job system (C++17)"
WORKERS = 4


def version():
    return "thread pool"


def draw(work, library, examples):
    picture = work / "picture.rgba"
    said = run.run([examples / "jobs" / "jobs", work / "picture.pam"])
    print(said, end="")
    tasks = [int(count) for count in re.findall(r"(\d+) on ", said)]
    if len(tasks) != WORKERS + 1 or sum(tasks) < 100 or tasks.count(0) > 1:
        raise run.Failed("the pool's threads did not run the tasks")
    threads = [int(count) for count in re.findall(r"(\d+) (?:before|after)", said)]
    if threads != [WORKERS + 1] * 2:
        raise run.Failed(f"there are other threads than the main one and the pool's {WORKERS}")
    header, pixels = (work / "picture.pam").read_bytes().split(b"ENDHDR\n", 1)
    if header != b"P7\nWIDTH 640\nHEIGHT 480\nDEPTH 4\nMAXVAL 255\nTUPLTYPE RGB_ALPHA\n":
        raise run.Failed(f"not the header of a PAM picture: {header}")
    picture.write_bytes(pixels)
    return picture
