# shellcheck shell=bash
# Stamps of checks that passed, so that they do not run again before something that they depend on changes; sourced, not
# run. A stamp is an empty file in $XDG_CACHE_HOME/argos3-checks, by default ~/.cache/argos3-checks, whose name is
# a hash of all inputs of the check; so stamps outlive a build folder. With ARGOS_CHECK_ALL=1 everything runs in spite of them.
source "$(dirname "${BASH_SOURCE[0]}")/lib.sh"
stamps="${XDG_CACHE_HOME:-${HOME:+$HOME/.cache}}"
stamps="${stamps:+$stamps/argos3-checks}"

# The functions print_... print inputs of a check; they fail if one of them cannot be read.

# print_files: a line with the mode and one with the hash of each file whose name is read; names end with NUL
print_files() {
  # shellcheck disable=SC2016  # that shell expands it
  sort -z | xargs -0 -r "$BASH" -c 'stat --dereference --format="%A %n" -- "$@" && sha256sum -- "$@"' print_files
}

# print_folder FOLDER [ARGUMENTS OF FIND]...: files of a folder
print_folder() (
  cd "$1" && find . -type f "${@:2}" -print0 | print_files
)

# list_repository [PATTERN]...: names of files of the repository, also of new ones, but not of those that git ignores
list_repository() (
  cd "$repo" && git ls-files -z --cached --others --exclude-standard -- "$@" |
    while IFS= read -r -d '' file; do [[ ! -f "$file" ]] || printf '%s\0' "$file"; done
)

# print_repository [PATTERN]...: those files
print_repository() (
  cd "$repo" && list_repository "$@" | print_files
)

# print_system: what affects every check. It fails without dpkg: nothing tells then whether a compiler or a library changed.
print_system() {
  local names='ARGOS_.*|CC|CXX|C.*FLAGS|LD.*|CMAKE_.*|CTEST_.*|PKG_CONFIG.*|LC_.*|LANG|LANGUAGE|TZ|PATH|PYTHON.*|LUA.*|.*SAN_OPTIONS'
  names+='|MALLOC_.*|MESA_.*|GALLIUM_.*|LIBGL_.*|EGL_.*|DISPLAY|NO_COLOR|CI|MUTATION_.*'
  uname -srm && dpkg-query --show && "${CXX:-c++}" --version &&
    env | grep -E "^($names)=" | grep -v '^ARGOS_CHECK_ALL=' | LC_ALL=C sort
}

# stamp_of KIND: the path of the stamp of the inputs that are read; nothing without a folder for stamps
stamp_of() {
  local hash
  hash="$(sha256sum)" || return
  [[ -z "$stamps" ]] || echo "$stamps/$1/${hash%% *}"
}

# has_passed STAMP: an empty name is that of no stamp
has_passed() {
  [[ "${ARGOS_CHECK_ALL:-0}" == 0 && -n "$1" && -f "$1" ]] || return
  # it is in use
  touch -c -- "$1" 2>/dev/null || true
}

note_passed() { # note_passed STAMP
  [[ -z "$1" ]] || { : >"$1"; } 2>/dev/null || true
}

forget_passed() { # forget_passed STAMP: of a check that failed in spite of it
  [[ -z "$1" ]] || rm -f -- "$1" 2>/dev/null || true
}

# prepare_stamps KIND: removes stamps not used for a month, and says if none can be written
prepare_stamps() {
  if ! { [[ -n "$stamps" ]] && mkdir -p -- "$stamps/$1" && [[ -w "$stamps/$1" ]]; } 2>/dev/null; then
    echo "${stamps:-~/.cache/argos3-checks}/$1 cannot be written: the next run will not know what has passed in this one"
    return 0
  fi
  # another run may do the same
  find "$stamps" -type f -mtime +30 -delete 2>/dev/null || true
}
