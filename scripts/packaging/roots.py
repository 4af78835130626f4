# SPDX-License-Identifier: MIT
"""Small Debian systems in folders, in which the packages are installed as a user would.

debootstrap makes each system once, in .cache/roots or the folder that HRBFNPR_ROOTS names.  Delete the folder to make
them anew.  A trial sees a system through an overlay, so that the next trial finds it unchanged.  Each command runs in
mount and process namespaces of its own; its mounts and its processes end with it, also if it is killed.
"""
from __future__ import annotations

import os
import re
import shlex
import shutil
import signal
import subprocess
import sys
import tempfile
from contextlib import contextmanager
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path
from typing import Callable, Iterator, List, Mapping, Optional, Sequence, Tuple

from common import ROOT, PathLike
from rows import Row

SUITES = ("bullseye", "bookworm", "trixie")
SYSTEMS = Path(os.environ.get("HRBFNPR_ROOTS") or ROOT / ".cache" / "roots")
PYTHON = ("python3-venv", "python3-cffi")
PICTURES = ("python3-numpy", "python3-pil")
COMPILER = ("gcc", "libc6-dev", "pkgconf")
EMULATOR = "qemu-aarch64-static"
TOOLS = {"debootstrap": "debootstrap", "unshare": "util-linux", "chroot": "coreutils"}  # program -> Debian package
PATIENCE = 1800  # seconds after which a command counts as hanging


class Failed(Exception):
    """A trial failed.  The message is the last lines of what the command printed."""


class NotRun(Exception):
    """A trial cannot run here.  The message says why."""


def attempt_row(package: str, where: str, draw: Callable[[], str]) -> Row:
    """Return the row of a trial that returns the hash of its picture, or raises Failed or NotRun."""
    print(f"\n==> {package}: {where}", flush=True)
    try:
        return Row(package, where, "ok", draw())
    except NotRun as reason:
        return Row(package, where, f"skipped: {reason}")
    except (Failed, OSError, ValueError, SystemExit) as failure:
        print(failure, file=sys.stderr, flush=True)
        return Row(package, where, f"failed: {shorten(str(failure))}")


def rows_on(suite: str, packages: Sequence[Path], rows: Callable[[System], List[Row]]) -> List[Row]:
    """Return the rows of trials on a bare system.  If there is no system, they are one row for each package."""
    print(f"\n==> {suite}: {', '.join(package.name for package in packages)}", flush=True)
    try:
        for package in packages:
            require(package)
        with fresh(suite) as system:
            return rows(system)
    except NotRun as reason:
        result = f"skipped: {reason}"
    except Failed as failure:
        print(failure, file=sys.stderr, flush=True)
        result = f"failed: {shorten(str(failure))}"
    return [Row(package.name, suite, result) for package in packages]


def found(dist: Path, pattern: str) -> Path:
    """Return the one file with this pattern, or the pattern in place of its name if it was not made."""
    paths = sorted(dist.glob(pattern))
    return paths[0] if paths else dist / pattern


def require(package: Path) -> None:
    if not package.is_file():
        raise NotRun(f"{package.name} was not made")


def shorten(text: str, most: int = 100) -> str:
    """Return the last line that says something, or its beginning."""
    lines = [line.strip() for line in text.splitlines() if line.strip()]
    return lines[-1][:most] if lines else "no message"


def execute(*command: PathLike, title: str = "", cwd: Optional[PathLike] = None,
            env: Optional[Mapping[str, str]] = None) -> str:
    """Run a command and return what it prints.  Raises Failed with the title of the command and the end of that.

    Its children are killed with it if it hangs, or if the trial is interrupted.
    """
    words = [str(word) for word in command]
    title = title or shlex.join(words)
    with subprocess.Popen(words, cwd=cwd, env=env, text=True, errors="replace", stdin=subprocess.DEVNULL,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT, start_new_session=True) as process:
        try:
            printed, _ = process.communicate(timeout=PATIENCE)
        except BaseException as error:
            os.killpg(process.pid, signal.SIGKILL)
            if isinstance(error, subprocess.TimeoutExpired):
                raise Failed(f"{title} still ran after {PATIENCE} seconds") from None
            raise
    if process.returncode != 0:
        end = "\n".join(printed.splitlines()[-30:])
        raise Failed(f"{title} ended with {process.returncode}:\n{end}")
    return printed


# Mounts an overlay of LOWER unless it is "", and all that a command needs, and runs the command in the folder MERGED.
ENTER = """
set -e
lower=$1 changes=$2 scratch=$3 merged=$4 exchange=$5
shift 5
[ -z "$lower" ] || mount -t overlay overlay -o "lowerdir=$lower,upperdir=$changes,workdir=$scratch" "$merged"
mkdir -p "$merged/trial"
mount --bind "$exchange" "$merged/trial"
mount -t proc proc "$merged/proc"
mount --rbind /dev "$merged/dev"
for file in /etc/resolv.conf /etc/hosts; do
  [ ! -e "$file" ] || { touch "$merged$file" && mount --bind "$file" "$merged$file"; }
done
exec chroot "$merged" "$@"
"""

PASSED = ("http_proxy", "https_proxy", "no_proxy")  # the only variables of the caller that enter a system
INSIDE = {"PATH": "/usr/sbin:/usr/bin:/sbin:/bin", "HOME": "/root", "LC_ALL": "C.UTF-8",
          "DEBIAN_FRONTEND": "noninteractive", "PYTHONDONTWRITEBYTECODE": "1"}


@dataclass(frozen=True)
class System:
    """A system that commands can run in.  Its folder /trial is the folder `exchange` outside."""

    name: str
    merged: Path  # where commands see the system
    work: Path  # scratch space
    lower: str = ""  # the folder that an overlay leaves unchanged
    emulator: Tuple[str, ...] = ()  # begins each command, for programs of another processor

    @property
    def exchange(self) -> Path:
        return self.work / "exchange"

    def put(self, *files: Path) -> List[str]:
        """Copy files to /trial and return their paths in the system."""
        return [f"/trial/{Path(shutil.copy2(file, self.exchange)).name}" for file in files]

    def write(self, name: str, text: str) -> str:
        """Write a file of /trial and return its path in the system."""
        (self.exchange / name).write_text(text, encoding="utf-8")
        return f"/trial/{name}"

    def run(self, *command: str, **environment: str) -> str:
        """Run a command in /trial of the system and return what it prints.  Raises Failed."""
        print(f"{self.name}# {shlex.join(command)}", flush=True)
        values = {**INSIDE, **{name: os.environ[name] for name in PASSED if name in os.environ}, **environment}
        one_processor = ("taskset", "-c", str(max(os.sched_getaffinity(0)))) if self.emulator else ()
        return execute(
            *one_processor, *NAMESPACES, "sh", "-c", ENTER, "enter", self.lower, self.work / "changes",
            self.work / "scratch", self.merged, self.exchange, *self.emulator, "/usr/bin/env", "-i", "--chdir=/trial",
            *(f"{name}={value}" for name, value in values.items()), *self.emulator, *command, title=shlex.join(command))

    def install(self, *packages: str) -> None:
        """Install Debian packages, or files of them in /trial."""
        self.run("apt-get", "-q", "-y", "--no-install-recommends", "install", *packages)


NAMESPACES = ("unshare", "--mount", "--pid", "--fork", "--kill-child")


def refusal() -> str:
    """Return why no system can be entered here, or ""."""
    if os.geteuid() != 0:
        return "needs root"
    missing = [package for program, package in TOOLS.items() if shutil.which(program) is None]
    if missing:
        return f"needs {', '.join(missing)}"
    return "" if mounts("-t", "proc", "proc", "/proc") else "mounts are not allowed here"


def mounts(*arguments: PathLike) -> bool:
    """Whether mount succeeds with these arguments."""
    command = [*NAMESPACES, "mount", *map(str, arguments)]
    return subprocess.run(command, stderr=subprocess.DEVNULL, check=False).returncode == 0


@lru_cache(maxsize=None)
def overlays() -> bool:
    """Whether an overlay can be mounted on the folder of the systems."""
    with folder_for_work() as work:
        parts = [work / name for name in ("changes", "scratch", "merged", "exchange")]
        options = "lowerdir={3},upperdir={0},workdir={1}".format(*parts)
        return mounts("-t", "overlay", "overlay", "-o", options, parts[2])


@contextmanager
def folder_for_work() -> Iterator[Path]:
    """Yield a folder with the folders of a trial, which is deleted at the end."""
    SYSTEMS.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory(prefix="trial-", dir=SYSTEMS) as name:
        for part in ("changes", "scratch", "merged", "exchange"):
            (Path(name) / part).mkdir()
        yield Path(name)


def mirror(sources: str) -> str:
    """Return the address of the Debian archive in the text of sources of apt, or "" for debootstrap's own choice."""
    found = re.search(r"^(?:URIs:|deb\s+(?:\[[^\]]*\]\s*)?)\s*(https?://\S+/debian)/?(?:\s|$)", sources, re.MULTILINE)
    return found[1] if found else ""


def apt_sources() -> str:
    """Return the text of all sources of apt on this machine."""
    folder = Path("/etc/apt")
    paths = [folder / "sources.list", *sorted((folder / "sources.list.d").glob("*"))]
    return "\n".join(path.read_text(encoding="utf-8") for path in paths if path.is_file())


def debootstrap(suite: str, folder: Path, *options: str) -> None:
    print(f"\n==> making the system of {suite} in {folder}", flush=True)
    folder.parent.mkdir(parents=True, exist_ok=True)
    shutil.rmtree(folder, ignore_errors=True)
    address = mirror(apt_sources())
    execute("debootstrap", "--variant=minbase", *options, suite, folder, *([address] if address else []))


def base(suite: str) -> Path:
    """Return the folder of a bare system, which is made the first time.

    The packages that trials install are in its apt cache.
    """
    folder, part = SYSTEMS / suite, SYSTEMS / f"{suite}.part"
    if not folder.exists():
        debootstrap(suite, part)
        (part / "etc" / "dpkg" / "dpkg.cfg.d" / "fast").write_text("force-unsafe-io\n", encoding="utf-8")
        with folder_for_work() as work:
            system = System(suite, part, work)
            system.run("apt-get", "-q", "update")
            system.install("--download-only", *PYTHON, *PICTURES, *COMPILER)
        part.rename(folder)
    return folder


# Unpacks a Debian package into a system. /lib and the like stay links to folders.
UNPACK = 'dpkg-deb --fsys-tarfile "$1" | tar -xC "$2" --keep-directory-symlink'


def arm64_base() -> Path:
    """Return the folder with the unpacked packages of an arm64 system with Python, which is made the first time.

    Its packages are unpacked but not configured, because that would run their scripts under an emulator.
    """
    folder, part = SYSTEMS / "bookworm-arm64", SYSTEMS / "bookworm-arm64.part"
    if not folder.exists():
        packages = ",".join(("python3", "python3-pip-whl", *PYTHON[1:]))
        debootstrap("bookworm", part, "--foreign", "--arch=arm64", f"--include={packages}")
        for package in sorted((part / "var/cache/apt/archives").glob("*.deb")):
            execute("sh", "-c", UNPACK, "unpack", package, part)
        shutil.copy2(str(shutil.which(EMULATOR)), part / "usr/bin")
        if (part / "proc").is_symlink():  # debootstrap makes one to /proc if it runs in a container
            (part / "proc").unlink()
            (part / "proc").mkdir()
        part.rename(folder)
    return folder


@contextmanager
def fresh(suite: str) -> Iterator[System]:
    """Yield a bare system, and delete its changes at the end.  Raises NotRun if it cannot be entered."""
    refuse(refusal())
    with trial(suite, base(suite)) as system:
        yield system


@contextmanager
def fresh_arm64() -> Iterator[System]:
    """Yield an arm64 system with Python whose programs run under qemu, on one processor.

    qemu 7.2 does not keep the order of stores and loads of other processors that the library's threads rely on.
    """
    refuse(refusal() or ("" if shutil.which(EMULATOR) else "needs qemu-user-static"))
    with trial("bookworm-arm64", arm64_base(), (f"/usr/bin/{EMULATOR}",)) as system:
        yield system


def refuse(why: str) -> None:
    if why:
        raise NotRun(why)


@contextmanager
def trial(name: str, folder: Path, emulator: Tuple[str, ...] = ()) -> Iterator[System]:
    with folder_for_work() as work:
        if not overlays():
            execute("cp", "-a", "--reflink=auto", f"{folder}/.", work / "merged")
        yield System(name, work / "merged", work, str(folder) if overlays() else "", emulator)
