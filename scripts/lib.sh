# Shared by the scripts of this folder; source it.
#
#   install_packages build test     installs the Debian packages of these sets that are missing
#
# shellcheck shell=bash

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
# The interpreter that Debian's Python packages belong to, whatever else is on the PATH.
python=/usr/bin/python3

say() { printf '\n==> %s\n' "$*"; }
die() { printf '%s: %s\n' "$(basename "$0")" "$*" >&2; exit 1; }

package_set() {
  case $1 in
    build) echo g++ cmake ninja-build pkgconf libeigen3-dev libglm-dev libhwy-dev ;;
    python) echo python3 python3-cffi python3-numpy python3-pil python3-meshio python3-tqdm ;;
    test) echo libgtest-dev libgmock-dev python3-pytest python3-numpy python3-cffi python3-dev binutils ;;
    csharp) echo mono-mcs mono-runtime ;;
    coverage) echo gcovr ;;
    bench) echo libopenblas0 libegl-dev libgles-dev libgl1-mesa-dri ;;
    thread) echo clang-14 libclang-rt-14-dev libomp-14-dev llvm-14 ;;
    npm) echo npm ;;
    lint) echo clang-format-14 clang-tidy-14 libomp-14-dev ;;
    *) die "there is no package set '$1'" ;;
  esac
}

installed() { [ "$(dpkg-query -W -f='${db:Status-Status}' "$1" 2>/dev/null)" = installed ]; }

install_packages() {
  local set package missing=() as_root=()
  if ! command -v apt-get >/dev/null; then
    say "no apt-get here: going on with the tools that are installed"
    return
  fi
  for set in "$@"; do
    for package in $(package_set "$set"); do
      installed "$package" || missing+=("$package")
    done
  done
  [ ${#missing[@]} -gt 0 ] || return 0
  if [ "$(id -u)" -ne 0 ]; then
    command -v sudo >/dev/null || die "please install, as root: apt-get install ${missing[*]}"
    as_root=(sudo)
  fi
  say "installing ${missing[*]}"
  "${as_root[@]}" apt-get -q update
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive \
    apt-get -q -y --no-install-recommends install "${missing[@]}"
}

# The same for packages that a system need not have: those that it does not offer are left out.
install_packages_if_offered() {
  local package
  command -v apt-cache >/dev/null || return 0
  for package in $(package_set "$1"); do
    if ! installed "$package" && [ -z "$(apt-cache madison "$package" 2>/dev/null)" ]; then
      say "$package is not offered here: going on without"
      return 0
    fi
  done
  install_packages "$1"
}

# configure PRESET [-DNAME=VALUE...]
configure() {
  local preset=$1 launcher=()
  shift
  if command -v ccache >/dev/null; then launcher=(-DCMAKE_CXX_COMPILER_LAUNCHER=ccache); fi
  cmake --preset "$preset" -S "$root" -DPython3_EXECUTABLE="$python" "${launcher[@]}" "$@"
}
