# SPDX-License-Identifier: MIT
"""Which of the tests that take turns are left out this time, as one regular expression for `ctest -E`.

    ctest -N | out_of_turn.py TURN TURNS EVERY_TURN TAKE_TURNS [NEVER]

The tests whose names match one of the regular expressions of the file TAKE_TURNS, and none of those of EVERY_TURN, are
dealt into TURNS hands, in the order of their names: those of the other hands than TURN are left out.  Those that match one
of the file NEVER, which the caller leaves out, are not named: CTest has no room for a long expression, and takes none then.
"""

import re
import sys


def patterns(path):
    with open(path, encoding="utf-8") as file:
        return [line.rstrip("\n") for line in file if line.strip()]


def dealt(names, every_turn, take_turns):
    def is_one_of(name, some):
        return any(re.search(one, name) for one in some)

    return sorted({name for name in names if is_one_of(name, take_turns) and not is_one_of(name, every_turn)})


def as_pattern(name):
    """As short as can be: CTest has no room for a long expression, and leaves nothing out then."""
    return "^" + re.sub(r"[^\w/]", ".", name) + "$"


def main():
    turn, turns = int(sys.argv[1]), int(sys.argv[2])
    names = re.findall(r"^ *Test +#\d+: (.*)$", sys.stdin.read(), re.MULTILINE)
    hands = dealt(names, patterns(sys.argv[3]), patterns(sys.argv[4]))
    never = patterns(sys.argv[5]) if len(sys.argv) > 5 else []
    left_out = [name for i, name in enumerate(hands) if i % turns != turn and not any(re.search(one, name) for one in never)]
    print("|".join(as_pattern(name) for name in left_out) or "^$")


if __name__ == "__main__":
    main()
