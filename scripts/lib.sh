# shellcheck shell=bash
# Shared by the scripts in this folder; sourced, not run.
repo="$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)"
# processes at once; set by scripts that run others side by side
jobs="${JOBS:-$(nproc)}"
# the build of run.sh and test.sh
# shellcheck disable=SC2034  # they use it
release_build="$(realpath -m -- "${BUILD_DIR:-$repo/build}")"

# git that also works for root in a clone of another owner
git() {
  command git -c safe.directory="$repo" "$@"
}

say() {
  printf '\n== %s\n' "$*"
}

die() {
  printf '%s: %s\n' "$(basename "$0")" "$*" >&2
  exit 1
}

# configure <build folder> <cmake arguments...>: configures if necessary, with Ninja if it is
# installed.
configure() {
  local build="$1"
  shift
  local cache="$build/CMakeCache.txt"
  if [[ -f "$cache" ]] && ! grep -qxF "CMAKE_HOME_DIRECTORY:INTERNAL=$repo" "$cache"; then
    echo "$build was configured for another folder; creating it again"
    rm -rf -- "$build"
  fi
  local stamp="$build/configured_with" wanted="$*"
  if [[ -f "$stamp" && -f "$cache" && "$(<"$stamp")" == "$wanted" ]]; then
    return 0 # the build configures again if a CMakeLists.txt changes
  fi
  local generator=()
  if [[ ! -f "$cache" ]] && command -v ninja >/dev/null; then
    generator=(-G Ninja)
  fi
  cmake -S "$repo" -B "$build" "${generator[@]}" "$@" || return
  printf '%s' "$wanted" >"$stamp"
}

# configure_release <build folder> <cmake arguments...>: the build that run.sh and test.sh share, so that the second one
# compiles only what the first one did not need. Units of several sources compile in a third of the time.
configure_release() {
  configure "$1" -DCMAKE_BUILD_TYPE=Release -DCMAKE_UNITY_BUILD=ON -DCMAKE_UNITY_BUILD_BATCH_SIZE=8 "${@:2}"
}

build() {
  cmake --build "$1" --parallel "$jobs" "${@:2}"
}
