#!/usr/bin/env bash
# Installs missing packages, builds everything with warnings as errors, and runs all checks and tests:
#   scripts/test.sh [--quick]     --quick: only build and tests, neither clang-tidy nor the downstream builds
# The build is that of run.sh, in build/ or where BUILD_DIR says, with the tests added to it.
# Tests that take many minutes have the label soak and are excluded; run them with: ctest --test-dir build -L soak
# With CI=true it leaves clang-tidy to .ci/run, which runs it in a build where it is faster.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/lib.sh"
quick=0
case "${1:-}" in
  "") ;;
  --quick) quick=1 ;;
  -h | --help) sed -n '2,7s/^# \{0,1\}//p' "${BASH_SOURCE[0]}"; exit 0 ;;
  *) die "unknown argument '$1'; there is only --quick" ;;
esac
cd "$repo"
build_dir="$release_build"
# a fixed folder, so that ccache finds again what was compiled there
work="$build_dir/checks"
rm -rf -- "$work"
mkdir -p "$work/tmp"

began() {
  say "$1 (after ${SECONDS} s)"
}

check_format() {
  git ls-files -z --cached --others --exclude-standard -- '*.h' '*.cpp' |
    while IFS= read -r -d '' file; do [[ ! -f "$file" ]] || printf '%s\0' "$file"; done |
    xargs -0 -r -n 50 -P "$jobs" clang-format --dry-run --Werror
}

# The installed headers are complete, include no third-party header except Eigen's, Lua's and, if it is there, OpenGL's, and
# compile together at the level to which the CMake package raises users' projects.
check_installed_headers() { # check_installed_headers <include folder>
  local included found
  while IFS= read -r included; do
    [[ -f "$1/$included" ]] || die "an installed header includes <$included>, which is not installed"
  done < <(grep -rhoE '^ *# *include *<argos3/[^>]+' "$1" | sed 's/.*<//' | sort -u)
  found="$(grep -rnE '^ *# *include *[<"](box2d|ode|tinyxml2|FreeImage|gsl|fmt|CLI|GL|EGL)[/.]' "$1" |
    grep -v '/qt-opengl/gl_calls\.h:' || true)"
  [[ -z "$found" ]] || die "installed headers include third-party ones: $found"
  find "$1" -name '*.h' -printf '#include <%P>\n' | sort >"$work/all_headers.cpp"
  # shellcheck disable=SC2046  # several flags
  c++ -std=gnu++17 -Wall -Wextra -Werror -fsyntax-only -I"$1" $(pkg-config --cflags eigen3 lua5.4) "$work/all_headers.cpp"
  echo "$(wc -l <"$work/all_headers.cpp") headers are installed and complete, and compile as gnu++17"
}

# Builds a user's project against the installed simulator, found in one of two ways; its experiment must run and write data.
build_user_project() { # build_user_project <name> <cmake arguments...>
  local folder="$work/$1" data="$work/$1/paths.csv"
  mkdir -p "$folder"
  if command -v ccache >/dev/null; then
    # here only: CMake would take it over into the build of the simulator, too, and compile all of that again
    export CMAKE_CXX_COMPILER_LAUNCHER=ccache CCACHE_NOHASHDIR=1 CCACHE_BASEDIR="$work"
  fi
  {
    cmake -S "$repo/examples/user_project" -B "$folder/build" -DCMAKE_BUILD_TYPE=Release "${@:2}" &&
      cmake --build "$folder/build" --parallel "$jobs" &&
      (cd "$folder" && "$work/prefix/bin/argos3" -c "$repo/examples/user_project/obstacle_avoidance.argos")
  } >"$folder/log" 2>&1 || { cat "$folder/log" >&2; die "the user's project ($1) failed, see above"; }
  [[ -s "$data" ]] || die "the user's project ($1) ran but wrote no paths.csv"
  echo "$1: built and ran; its data has $(wc -l <"$data") lines"
}

# Steps that need the build only and are side by side, each on one core: mostly one program at a time runs in them.

# The same sources are compiled with optimization above; this finds what they include or link of the simulator.
step_robot() {
  echo "Controllers without the simulator (ARGOS_BUILD_FOR=robot, in build-robot/)"
  configure "$repo/build-robot" -DCMAKE_BUILD_TYPE=Release -DARGOS_BUILD_TESTING=OFF -DARGOS_WERROR=ON \
    -DARGOS_BUILD_FOR=robot -DARGOS_PRECOMPILE_HEADERS=OFF -DCMAKE_CXX_FLAGS_RELEASE=-O0
  build "$repo/build-robot"
}

step_users_projects() {
  echo "A user's project, built in two ways"
  build_user_project find_package -DCMAKE_PREFIX_PATH="$work/prefix"
  PKG_CONFIG_PATH="$work/prefix/lib/pkgconfig" build_user_project pkg_config -DUSE_PKG_CONFIG=ON
}

step_outside_projects() {
  echo "Projects written for ARGoS 3"
  "$repo/scripts/outside_projects.sh" "$work/prefix" "$work/projects"
}

step_packages() {
  echo "Debian packages and an archive"
  "$repo/scripts/package.sh" --build "$build_dir" "$work/packages" deb tgz
}

step_site() {
  echo "The site: user's guide and API reference"
  BUILD_DIR="$build_dir" "$repo/scripts/site.sh" "$work/site"
}

step_examples() {
  echo "Examples of the first day"
  "$repo/scripts/examples.sh" "$work/prefix"
}

step_guide() {
  echo "The user's guide"
  "$repo/scripts/check_guide.sh" "$work/prefix"
}

step_headers() {
  echo "Installed headers"
  check_installed_headers "$work/prefix/include"
}

run_step() { # run_step <name>: prints what the step says when it ends
  local began="$SECONDS" status=0
  # a new shell, so that an error in the step ends it
  # shellcheck disable=SC2016  # that shell expands it
  "$BASH" -c 'set -euo pipefail; "step_$1"' "$1" "$1" >"$work/$1.log" 2>&1 || status=$?
  echo "-- $(cat "$work/$1.log")"
  if ((status != 0)); then
    echo "$1 failed with status $status, see above"
    return 1
  fi
  echo "   ($((SECONDS - began)) s)"
}

run_steps() { # run_steps <name>...
  export JOBS=1 TMPDIR="$work/tmp" repo jobs=1 build_dir work
  # shellcheck disable=SC2046  # one name each
  export -f $(declare -F | cut -d' ' -f3)
  # shellcheck disable=SC2016  # that shell expands it
  printf '%s\0' "$@" | xargs -0 -n 1 -P "$(nproc)" "$BASH" -c 'run_step "$1"' run_step ||
    die "steps failed, see above"
}

began "Packages"
"$repo/scripts/setup.sh" run test site

began "Layout of the sources (clang-format)"
check_format
echo "as .clang-format says"

began "Shell scripts (shellcheck)"
shellcheck scripts/*.sh .ci/run
shellcheck src/testing/compat/projects/*/check.sh studies/*/*.sh
echo "nothing found"

began "Project rules (lint)"
"$repo/scripts/lint.sh"

began "Public headers, each alone"
configure_release "$build_dir" -DARGOS_BUILD_TESTING=ON -DARGOS_WERROR=ON
"$repo/scripts/check_headers.py" "$build_dir"

began "Build (Release, with tests, warnings are errors, in ${build_dir#"$repo"/}/)"
build "$build_dir"

began "Tests"
"$repo/scripts/run_tests.sh" "$build_dir"
# the test that is no program of its own
ctest --test-dir "$build_dir" --output-on-failure --tests-regex '^build_id_of_a_changed_header$' --no-tests=error

began "The build tree, through its setup_env.sh"
# shellcheck disable=SC1091  # generated
(source "$build_dir/setup_env.sh" && cd "$work" && argos3 -n -z -c "$repo/experiments/diffusion_1.argos" --length 1)

began "Pinned digests"
"$repo/scripts/digests.sh" "$build_dir"

if ((quick)); then
  say "The quick checks passed after ${SECONDS} s"
  exit 0
fi

began "Installation"
cmake --install "$build_dir" --prefix "$work/installed" >"$work/install.log"
# moved after the installation, because it must be relocatable
mv "$work/installed" "$work/prefix"
# with the installed controllers, which are found by name
(cd "$work" && "$work/prefix/bin/argos3" -n -zc "$work/prefix/share/argos3/experiments/diffusion_10.argos" --length 1)

began "Side by side: users' projects, packages, site, guide, a build for robots"
# those that take longest begin
run_steps guide outside_projects site robot examples packages users_projects headers

if [[ "${CI:-}" == true ]]; then
  echo "clang-tidy follows in .ci/run"
else
  began "clang-tidy"
  # source by source and without precompiled headers, so that missing includes are found; this build is only configured
  configure "$repo/build-ci" -DCMAKE_BUILD_TYPE=Release -DARGOS_BUILD_TESTING=ON -DARGOS_WERROR=ON
  "$repo/scripts/tidy.sh" "$repo/build-ci"
fi

say "All checks passed after ${SECONDS} s"
