#!/usr/bin/env bash
# Installs missing packages of packages.txt; if none is missing, does nothing and needs no network.
#   scripts/setup.sh [MARK]...           those with one of the marks run, live, test, site, package; by default run
#   scripts/setup.sh --list [MARK]...    prints them instead
# Run by run.sh and test.sh, and by those who build by hand.
set -euo pipefail

scripts="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)"
list="$scripts/packages.txt"

fail() {
  printf 'setup: %s\n' "$@" >&2
  exit 1
}

if [[ "${1:-}" == -h || "${1:-}" == --help ]]; then
  sed -n '2,5s/^# \{0,1\}//p' "${BASH_SOURCE[0]}"
  exit 0
fi
only_list=0
if [[ "${1:-}" == --list ]]; then
  only_list=1
  shift
fi
(($# > 0)) || set -- run
for mark in "$@"; do
  [[ "$mark" =~ ^(run|live|test|site|package|guide|runtime|dev|option)$ ]] || fail "'$mark' is no mark of $list"
done
mapfile -t wanted < <(awk -v marks="$*" '
  /^[^#]/ {
    for (i = 2; i <= NF; ++i)
      if (index(" " marks " ", " " $i " ")) { print $1; next }
  }' "$list")
if ((only_list)); then
  printf '%s\n' "${wanted[@]}"
  exit 0
fi

is_installed() {
  # those of Node.js's own packages, which conflict with Debian's
  if [[ "$1" == npm || "$1" == nodejs ]] && command -v npm >/dev/null && command -v node >/dev/null; then
    return 0
  fi
  [[ "$(dpkg-query --show --showformat='${db:Status-Status}' "$1" 2>/dev/null)" == installed ]]
}

if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
  for tool in cmake c++ pkg-config; do
    command -v "$tool" >/dev/null || fail "this is not a Debian system, and '$tool' is missing;" \
      "install what corresponds to the packages in $list"
  done
  echo "setup: this is not a Debian system; assuming that the packages in scripts/packages.txt are installed"
  exit 0
fi

missing=()
for package in "${wanted[@]}"; do
  is_installed "$package" || missing+=("$package")
done
if ((${#missing[@]} == 0)); then
  echo "setup: all ${#wanted[@]} packages are installed"
  exit 0
fi

root=()
if ((EUID != 0)); then
  command -v sudo >/dev/null || fail "missing packages: ${missing[*]}" \
    "installing them needs root, and there is no sudo; as root, run: apt-get install ${missing[*]}"
  root=(sudo)
fi
apt_get() {
  "${root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -y -o Dpkg::Use-Pty=0 "$@"
}

echo "setup: ${#missing[@]} of ${#wanted[@]} packages are missing: ${missing[*]}"
echo "setup: fetching the lists of packages"
apt_get -qq update || echo "setup: that failed (no network?); trying with the present lists" >&2

unknown=()
for package in "${missing[@]}"; do
  [[ -n "$(apt-cache show --no-all-versions "$package" 2>/dev/null)" ]] || unknown+=("$package")
done
((${#unknown[@]} == 0)) || fail "apt does not know the packages: ${unknown[*]}" \
  "is this Debian 12, is there a network, and does /etc/apt/sources.list* contain the main archive?"

echo "setup: installing (a few minutes)"
log="$(mktemp)"
trap 'rm -f "$log"' EXIT
if ! apt_get install --no-install-recommends "${missing[@]}" 2>&1 | tee "$log" |
  awk '/^(Get:|Fetched|Setting up)/ { print "  " $0; fflush() }'; then
  tail -n 20 "$log" >&2
  fail "apt-get could not install: ${missing[*]}" "its last lines are above"
fi
for package in "${missing[@]}"; do
  is_installed "$package" || fail "apt-get succeeded, but '$package' is not installed"
done
echo "setup: done"
