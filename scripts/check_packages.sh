#!/usr/bin/env bash
# Installs the Debian packages in a bare Debian 12, runs an experiment, builds projects against them, replays the user's
# guide (every command of every page, with its expected output), removes them and checks that nothing is left. Needs root,
# debootstrap and a network; takes minutes, so continuous integration does not run it:
#   scripts/check_packages.sh [PACKAGES]     the folder with the .deb files, by default packages/, made by package.sh
# MIRROR is where debootstrap and apt fetch packages, by default http://deb.debian.org/debian.
set -euo pipefail
if [[ "${1:-}" == -h || "${1:-}" == --help ]]; then
  sed -n '2,6s/^# \{0,1\}//p' "${BASH_SOURCE[0]}"
  exit 0
fi
source "$(dirname "${BASH_SOURCE[0]}")/lib.sh"
packages="$(cd "${1:-$repo/packages}" && pwd)" || die "no folder ${1:-packages}; run scripts/package.sh first"
source "$(dirname "${BASH_SOURCE[0]}")/bare_debian.sh"
for part in argos3-sim argos3-sim-dev argos3-sim-examples; do
  found=("$packages/$part"_*.deb)
  [[ -f "${found[0]}" && ${#found[@]} == 1 ]] || die "there is not one $part""_*.deb in $packages: ${found[*]}"
done

install_debian bookworm
mkdir "$system/packages"
cp "$packages"/argos3-sim*.deb "$system/packages"

say "Install argos3-sim and argos3-sim-examples, run an experiment (after ${SECONDS} s)"
before="$(inside dpkg-query --show | wc -l)"
apt_install "/packages/$(basename "$packages"/argos3-sim_*.deb)" "/packages/$(basename "$packages"/argos3-sim-examples_*.deb)"
echo "$(($(inside dpkg-query --show | wc -l) - before)) packages, with those that they need"
inside argos3 --version
inside argos3 -q foot-bot | head -n 3
inside bash -c 'cd /root && argos3 -c /usr/share/argos3/experiments/diffusion_10.argos --length 2'
frames="$(find "$system/root/out" -name '*.png' -size +1k | wc -l)"
((frames > 0)) || die "the experiment wrote no frame"
echo "$frames frames"

say "Install argos3-sim-dev, build projects (after ${SECONDS} s)"
apt_install "/packages/$(basename "$packages"/argos3-sim-dev_*.deb)"
# shellcheck disable=SC2016  # that shell expands it
inside bash -euo pipefail -c '
  cp -r /usr/share/argos3/examples /root/examples
  cd /root/examples/user_project
  for way in OFF ON; do
    cmake -S . -B build -DUSE_PKG_CONFIG=$way >configure.log 2>&1 || { cat configure.log; exit 1; }
    cmake --build build --clean-first --parallel 2 >build.log 2>&1 || { cat build.log; exit 1; }
    rm -f paths.csv
    argos3 -zc obstacle_avoidance.argos
    echo "USE_PKG_CONFIG=$way: $(wc -l <paths.csv) lines of data"
  done' || die "a project failed, see above"

say "Replay the user's guide (after ${SECONDS} s)"
mapfile -t tools < <("$repo/scripts/setup.sh" --list guide)
apt_install "${tools[@]}"
copy_sources /root/sources
inside /root/sources/scripts/check_guide.sh /usr || die "a page of the guide failed, see above"

say "Remove all (after ${SECONDS} s)"
inside dpkg --listfiles argos3-sim argos3-sim-dev argos3-sim-examples | sort -u >"$system/tmp/installed"
inside apt-get -y -qq -o Dpkg::Use-Pty=0 purge argos3-sim argos3-sim-dev argos3-sim-examples >"$system/tmp/apt.log" 2>&1 ||
  { tail "$system/tmp/apt.log" >&2; die "purge failed, see above"; }
left=()
while IFS= read -r path; do
  # a folder may belong to other packages, too
  [[ ! -e "$system$path" ]] || inside dpkg-query --search "$path" >/dev/null 2>&1 || left+=("$path")
done < <(grep '^/' "$system/tmp/installed")
mapfile -t named < <(cd "$system" && find . -xdev \( -path ./proc -o -path ./tmp -o -path ./root -o -path ./packages -o \
  -path ./var/log \) -prune -o -iname '*argos*' -print)
((${#left[@]} + ${#named[@]} == 0)) || die "the packages left behind: ${left[*]} ${named[*]}"
say "The packages install, run, build and are removed without a trace; after ${SECONDS} s"
