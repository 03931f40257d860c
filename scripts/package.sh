#!/usr/bin/env bash
# Makes the packages argos3-sim, argos3-sim-dev and argos3-sim-examples and checks what is in them:
#   scripts/package.sh [--build BUILD_FOLDER] [OUT [FORMAT]...]
# OUT is packages/ by default; FORMAT is deb, tgz or rpm, by default all three. Without --build the simulator is built in
# build-package/ for the prefix /usr; with it the packages have what is built there.
# scripts/check_packages.sh installs them in a bare Debian.
set -euo pipefail
if [[ "${1:-}" == -h || "${1:-}" == --help ]]; then
  sed -n '2,6s/^# \{0,1\}//p' "${BASH_SOURCE[0]}"
  exit 0
fi
source "$(dirname "${BASH_SOURCE[0]}")/lib.sh"
build_dir="$repo/build-package"
has_build=0
if [[ "${1:-}" == --build ]]; then
  (($# > 1)) || die "--build needs a folder"
  build_dir="$(cd "$2" && pwd)"
  has_build=1
  shift 2
fi
out="${1:-$repo/packages}"
mkdir -p "$out"
out="$(cd "$out" && pwd)"
formats=("${@:2}")
((${#formats[@]} > 0)) || formats=(deb tgz rpm)
for format in "${formats[@]}"; do
  [[ "$format" =~ ^(deb|tgz|rpm)$ ]] || die "unknown format '$format'; there are deb, tgz and rpm"
done

if ((!has_build)); then
  "$repo/scripts/setup.sh" run package
  configure_release "$build_dir" -DCMAKE_INSTALL_PREFIX=/usr -DARGOS_BUILD_TESTING=OFF
  build "$build_dir"
fi
# cpack does not do it
cmake "$build_dir" >/dev/null
work="$(mktemp -d)"
trap 'rm -rf -- "$work"' EXIT
touch "$work/begin"

for format in "${formats[@]}"; do
  (cd "$build_dir" && cpack -G "${format^^}" -B "$work/$format") >"$work/log" 2>&1 ||
    { cat "$work/log" >&2; die "cpack -G ${format^^} failed, see above"; }
  find "$work/$format" -maxdepth 1 -name "*.${format/tgz/tar.gz}" -exec mv -t "$out" {} +
done

# check_deb PACKAGE PATTERN...: the package has a path for each pattern and nothing where only a local administrator
# installs; lintian, if it is there, finds no error.
check_deb() {
  local file listing="$work/$1.list" pattern
  file="$(find "$out" -maxdepth 1 -name "$1_*.deb" -newer "$work/begin")"
  [[ -f "$file" ]] || die "there is not one new $1_*.deb in $out: '$file'"
  dpkg-deb --contents "$file" | awk '{ print $6 }' >"$listing"
  for pattern in "${@:2}"; do
    grep -qE -- "$pattern" "$listing" || die "no path in $1 matches '$pattern'"
  done
  ! grep -nE 'usr/local|/build/' "$listing" || die "$1 has paths that belong in no package, see above"
  if command -v lintian >/dev/null; then
    # private libraries are linked by relative paths, there is no Debian changelog, the name of the original has an
    # underscore, and the address is set by those who publish packages, with -DCPACK_PACKAGE_CONTACT
    lintian --allow-root --fail-on error --suppress-tags custom-library-search-path,no-changelog,bogus-mail-host,bad-provided-package-name "$file" >"$work/lintian" 2>&1 ||
      { cat "$work/lintian" >&2; die "lintian finds errors in $1, see above"; }
  fi
  echo "  $(basename "$file"): $(grep -vc '/$' "$listing") files, $(stat -c %s "$file" | numfmt --to=iec)"
}

depends() { # depends PACKAGE NAME...; names of libraries end in a version that differs between releases of Debian
  local name field
  field="$(dpkg-deb --field "$out/$1"_*.deb Depends), "
  for name in "${@:2}"; do
    grep -qE "(^|, )${name//+/\\+}( \(|, )" <<<"$field" || die "$1 does not depend on $name, but on: $field"
  done
}

provides() { # provides PACKAGE NAME
  dpkg-deb --field "$out/$1"_*.deb Provides | grep -qE "(^|, )$2 \\(= " || die "$1 does not provide $2"
}

echo "in $out/:"
for format in "${formats[@]}"; do
  if [[ "$format" == deb ]]; then
    check_deb argos3-sim /bin/argos3$ /bin/argos3-campaign$ /bin/argos3-plot$ /libargos3core_simulator.so$ /libargos3_hdf5_tables.so$ \
      /libargos3_images.so$ /libargos3plugin_simulator_footbot.so$ /libargos3plugin_simulator_footbot.labels$ /doc/argos3-sim/copyright$
    check_deb argos3-sim-dev /core/simulator/simulator.h$ /core/config.h$ /core/build_id.h$ /ARGoSConfig.cmake$ \
      /argos3_simulator.pc$ /doc/argos3-sim-dev/copyright$
    check_deb argos3-sim-examples /experiments/diffusion_10.argos$ /libfootbot_diffusion.so$ \
      /examples/user_project/CMakeLists.txt$ /guide/index.md$ /doc/argos3-sim-examples/copyright$
    # a linked library, and the marks of packages.txt
    mapfile -t runtime < <("$repo/scripts/setup.sh" --list runtime)
    mapfile -t dev < <("$repo/scripts/setup.sh" --list dev)
    depends argos3-sim libc6 'libgsl[0-9]*' "${runtime[@]}"
    depends argos3-sim-dev argos3-sim "${dev[@]}"
    depends argos3-sim-examples argos3-sim
    # the original's name, which packages of plug-ins depend on
    provides argos3-sim argos3_simulator
  else
    # one archive with everything, three packages for rpm
    find "$out" -maxdepth 1 -name "*.${format/tgz/tar.gz}" -newer "$work/begin" -printf '  %f: %s bytes\n' | sort | tee "$work/made"
    wanted=1
    [[ "$format" != rpm ]] || wanted=3
    (($(wc -l <"$work/made") == wanted)) || die "not $wanted but the packages above were made for $format"
  fi
done
