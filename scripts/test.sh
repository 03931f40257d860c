#!/usr/bin/env bash
# Installs missing packages, builds everything with warnings as errors, and runs all checks and tests:
#   scripts/test.sh [--quick] [--all]
#     --quick   only build and tests, neither clang-tidy nor the downstream builds
#     --all     also what has passed before with the same inputs (scripts/stamps.sh); as ARGOS_CHECK_ALL=1
# The build is that of run.sh, in build/ or where BUILD_DIR says, with the tests added to it.
# Tests that take many minutes have the label soak and are excluded; run them with: ctest --test-dir build -L soak
# With CI=true it leaves clang-tidy to .ci/run, which runs it in a build where it is faster.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/stamps.sh"
quick=0
for argument in "$@"; do
  case "$argument" in
    --quick) quick=1 ;;
    --all) export ARGOS_CHECK_ALL=1 ;;
    -h | --help) sed -n '2,9s/^# \{0,1\}//p' "${BASH_SOURCE[0]}"; exit 0 ;;
    *) die "unknown argument '$argument'; there are --quick and --all" ;;
  esac
done
cd "$repo"
build_dir="$release_build"
# one run at a time in a build
if [[ "${checks_locked:-}" != "$build_dir" ]]; then
  mkdir -p "$build_dir"
  flock --nonblock "$build_dir/checks.lock" true || echo "Another run uses $build_dir; waiting for its end"
  checks_locked="$build_dir" exec flock --close "$build_dir/checks.lock" "$BASH" "$repo/scripts/test.sh" "$@"
fi
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

# The installed headers are complete, include no third-party header except Eigen's in eigen_bridge.h, Lua's and, if it is
# there, OpenGL's, and compile together at the level to which the CMake package raises users' projects, those of users who
# call neither Eigen nor Lua without the folders of these.
check_installed_headers() { # check_installed_headers <include folder>
  local included found
  while IFS= read -r included; do
    [[ -f "$1/$included" ]] || die "an installed header includes <$included>, which is not installed"
  done < <(grep -rhoE '^ *# *include *<argos3/[^>]+' "$1" | sed 's/.*<//' | sort -u)
  found="$(grep -rnE '^ *# *include *[<"](box2d|ode|tinyxml2|FreeImage|gsl|fmt|CLI|GL|EGL)[/.]' "$1" |
    grep -v '/qt-opengl/gl_calls\.h:' || true)"
  [[ -z "$found" ]] || die "installed headers include third-party ones: $found"
  find "$1" -name '*.h' -printf '#include <%P>\n' | sort >"$work/all_headers.cpp"
  # those of users who call Eigen or Lua
  local third='/(eigen_bridge|lua_headers|lua_quaternion|lua_user_type|lua_utility|lua_vector[23])\.h>'
  grep -vE "$third" "$work/all_headers.cpp" >"$work/plain_headers.cpp"
  grep -E "$third" "$work/all_headers.cpp" >"$work/third_party_headers.cpp"
  c++ -std=gnu++17 -Wall -Wextra -Werror -fsyntax-only -I"$1" "$work/plain_headers.cpp"
  # shellcheck disable=SC2046  # several flags
  c++ -std=gnu++17 -Wall -Wextra -Werror -fsyntax-only -I"$1" $(pkg-config --cflags eigen3 lua5.4) "$work/third_party_headers.cpp"
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

# Steps that need the build only and are side by side, each on one core: mostly one program at a time runs in them. A step
# is left out if it passed before with the same inputs: step_NAME is the step, inputs_NAME prints its inputs. Those of
# every step are print_system, this script and the scripts that it sources.

# The installed simulator, but for its pages and the commit that argos3 --version shows.
print_installed() {
  cat "$work/installed.inputs"
}

# The built one.
print_built() (
  cd "$build_dir" && find bin/argos3 lib experiments -type f -print0 | print_files
)

inputs_digests() {
  print_built && print_repository scripts/digests.sh src/testing/digests.txt src/testing/scenes experiments
}

step_digests() {
  echo "Pinned digests"
  "$repo/scripts/digests.sh" "$build_dir"
}

inputs_build_id() {
  print_repository '*/CMakeLists.txt' CMakeLists.txt src/cmake src/core/build_id.h.in src/testing/unit/'*.cmake'
}

# The tests that are no programs of their own.
step_build_id() {
  echo "The build id of a changed header, and the recipe cmake ../src"
  ctest --test-dir "$build_dir" --output-on-failure --no-tests=error \
    --tests-regex '^(build_id_of_a_changed_header|build_from_the_src_folder)$'
}

# All that controllers are compiled from.
list_robot_sources() {
  list_repository CMakeLists.txt '*/CMakeLists.txt' ':!src/testing' src/cmake src/core/config.h.in src/core/build_id.h.in \
    src/core/utility src/core/control_interface src/core/wrappers src/compat 'src/plugins/*/control_interface/*' experiments
}

inputs_robot() (
  cd "$repo" && list_robot_sources | print_files
)

# The same sources are compiled with optimization above; this finds what they include or link of the simulator.
step_robot() {
  echo "Controllers without the simulator (ARGOS_BUILD_FOR=robot, in build-robot/)"
  configure "$repo/build-robot" -DCMAKE_BUILD_TYPE=Release -DARGOS_BUILD_TESTING=OFF -DARGOS_WERROR=ON \
    -DARGOS_BUILD_FOR=robot -DARGOS_PRECOMPILE_HEADERS=OFF -DCMAKE_CXX_FLAGS_RELEASE=-O0
  build "$repo/build-robot"
  if [[ -f "$repo/build-robot/build.ninja" ]]; then
    # what the compiler has read is listed
    (cd "$repo/build-robot" && ninja -t deps | sed -n 's/^    //p' | sort -u | xargs -d '\n' realpath --relative-base="$repo") |
      grep -vE '^(/|build)' | sort -u | comm -23 - <(list_robot_sources | tr '\0' '\n' | sort) >"$work/robot_unlisted"
    [[ ! -s "$work/robot_unlisted" ]] || die "list_robot_sources lacks what the compiler has read:" "$(<"$work/robot_unlisted")"
  fi
}

inputs_users_projects() {
  print_installed && print_repository examples/user_project
}

step_users_projects() {
  echo "A user's project, built in two ways"
  build_user_project find_package -DCMAKE_PREFIX_PATH="$work/prefix"
  PKG_CONFIG_PATH="$work/prefix/lib/pkgconfig" build_user_project pkg_config -DUSE_PKG_CONFIG=ON
}

inputs_outside_projects() {
  print_installed && print_repository scripts/outside_projects.sh src/testing/compat/projects
}

step_outside_projects() {
  echo "Projects written for ARGoS 3"
  "$repo/scripts/outside_projects.sh" "$work/prefix" "$work/projects"
}

# Of compiled files, packages depend on the libraries that they need and on the symbols that they take from them.
inputs_packages() {
  print_folder "$work/prefix" ! -path '*/lib/*.so' ! -path './bin/*' ! -path ./share/argos3/build.txt &&
    (cd "$work/prefix" && find . -type f \( -path '*/lib/*.so' -o -path './bin/*' \) -printf '%M %p\n' | sort | while read -r mode file; do
      echo "$mode $file"
      if ! readelf --dynamic --wide "$file" 2>&1 | grep -E 'NEEDED|SONAME|RUNPATH|RPATH|FLAGS'; then
        sha256sum "$file"
      fi
      nm --dynamic --undefined-only --with-symbol-versions "$file" 2>&1 || true
    done) &&
    cat "$build_dir/CPackConfig.cmake" &&
    print_repository scripts/package.sh scripts/packages.txt scripts/setup.sh
}

step_packages() {
  echo "Debian packages and an archive"
  "$repo/scripts/package.sh" --build "$build_dir" "$work/packages" deb tgz
}

# Links lead to any file, of which only the name counts.
inputs_site() {
  print_folder "$work/prefix/include" && print_folder "$work/prefix/share/argos3/cmake" &&
    "$build_dir/bin/argos3" -n -q all --json &&
    list_repository | tr '\0' '\n' && print_repository '*.md' doc scripts/site scripts/site.sh
}

step_site() {
  echo "The site: user's guide and API reference"
  BUILD_DIR="$build_dir" "$repo/scripts/site.sh" "$work/site"
}

inputs_examples() {
  print_installed && print_repository scripts/examples.sh examples
}

step_examples() {
  echo "Examples of the first day"
  "$repo/scripts/examples.sh" "$work/prefix"
}

# Pages show parts of any file but sources of the simulator, and link to any.
inputs_studies() {
  print_installed && print_repository studies
}

# Their reduced forms; fixed seeds.
step_studies() {
  echo "Main properties of the studies"
  local study
  for study in "$repo"/studies/*/CMakeLists.txt; do
    study="$(basename "$(dirname "$study")")"
    echo "$study:"
    "$repo/studies/check.sh" "$study" "$work/prefix" 2>&1
  done
}

inputs_guide() {
  print_installed && list_repository | tr '\0' '\n' &&
    print_repository . ':!src' ':!scripts' && print_repository scripts/guide scripts/check_guide.sh
}

step_guide() {
  echo "The user's guide"
  "$repo/scripts/check_guide.sh" "$work/prefix"
}

reaches_npm() {
  npm ping --fetch-retries 1 --fetch-timeout 20000 >/dev/null 2>&1
}

inputs_page() {
  { reaches_npm && echo "with the registry of npm" || echo "without"; } &&
    print_built && print_repository scripts/check_page.sh src/plugins/visualizations/live experiments
}

step_page() {
  echo "The page of the live view, in a browser"
  if ! reaches_npm; then
    echo "NOT CHECKED: the registry of npm cannot be reached"
    return 0
  fi
  "$repo/scripts/check_page.sh" "$build_dir"
}

inputs_headers() {
  print_folder "$work/prefix/include"
}

step_headers() {
  echo "Installed headers"
  check_installed_headers "$work/prefix/include"
}

list_steps() { # the names of all functions step_...
  declare -F | sed -n 's/^declare -f step_//p'
}

stamp_of_step() { # stamp_of_step <name>
  {
    echo "$1" && cat "$work/system.inputs" &&
      print_repository scripts/test.sh scripts/stamps.sh scripts/lib.sh && "inputs_$1"
  } | stamp_of steps
}

run_step() { # run_step <name>: prints what the step says when it ends
  set -o pipefail
  local began="$SECONDS" status=0 stamp="" stamp_now=""
  if [[ -s "$work/system.inputs" ]]; then
    stamp="$(stamp_of_step "$1")" || {
      echo "$1: its inputs cannot be read, see above"
      echo "$1" >>"$work/failed"
      return 1
    }
  fi
  if has_passed "$stamp"; then
    echo "-- $1: passed before with the same inputs"
    return 0
  fi
  # a new shell, so that an error in the step ends it
  # shellcheck disable=SC2016  # that shell expands it
  "$BASH" -c 'set -euo pipefail; "step_$1"' "$1" "$1" >"$work/$1.log" 2>&1 || status=$?
  echo "-- $(cat "$work/$1.log")"
  if ((status != 0)); then
    echo "$1 failed with status $status, see above"
    echo "$1" >>"$work/failed"
    forget_passed "$stamp"
    return 1
  fi
  [[ -z "$stamp" ]] || stamp_now="$(stamp_of_step "$1")"
  # not if they were edited meanwhile
  [[ "$stamp" != "$stamp_now" ]] || note_passed "$stamp"
  echo "   ($((SECONDS - began)) s)"
}

run_steps() { # run_steps <name>...
  export JOBS=1 TMPDIR="$work/tmp" repo jobs=1 build_dir work stamps
  : >"$work/failed"
  prepare_stamps steps
  print_system >"$work/system.inputs" || {
    echo "what is installed on this system cannot be read, so all steps run"
    : >"$work/system.inputs"
  }
  # shellcheck disable=SC2046  # one name each
  export -f $(declare -F | cut -d' ' -f3)
  # shellcheck disable=SC2016  # that shell expands it
  printf '%s\0' "$@" | xargs -0 -n 1 -P "$(nproc)" "$BASH" -c 'run_step "$1"' run_step || {
    # last, because the end of a long text is what people see first
    while IFS= read -r name; do
      echo "-- The last lines of $name, which failed:"
      tail -n 20 "$work/$name.log" || true
    done < <(sort -u "$work/failed")
    die "steps failed: $(sort -u "$work/failed" | paste -sd' ')"
  }
}

began "Packages"
"$repo/scripts/setup.sh" run test site

began "Layout of the sources (clang-format)"
check_format
echo "as .clang-format says"

began "Shell scripts (shellcheck)"
shellcheck scripts/*.sh .ci/run
shellcheck src/testing/compat/projects/*/check.sh studies/*.sh studies/*/*.sh
echo "nothing found"

began "Project rules (lint)"
"$repo/scripts/lint.sh"

began "Public headers, each alone, and compared with those of ARGoS 3"
configure_release "$build_dir" -DARGOS_BUILD_TESTING=ON -DARGOS_WERROR=ON
"$repo/scripts/check_headers.py" "$build_dir"
"$repo/scripts/check_api.py" "$build_dir"

began "Build (Release, with tests, warnings are errors, in ${build_dir#"$repo"/}/)"
build "$build_dir"

began "Tests"
"$repo/scripts/run_tests.sh" "$build_dir"

began "The build tree, through its setup_env.sh"
# shellcheck disable=SC1091  # generated
(source "$build_dir/setup_env.sh" && cd "$work" && argos3 -n -z -c "$repo/experiments/diffusion_1.argos" --length 1)

if ((quick)); then
  began "Pinned digests, build id"
  run_steps digests build_id
  say "The quick checks passed after ${SECONDS} s"
  exit 0
fi

began "Installation"
cmake --install "$build_dir" --prefix "$work/installed" >"$work/install.log"
# moved after the installation, because it must be relocatable
mv "$work/installed" "$work/prefix"
print_folder "$work/prefix" ! -path ./share/argos3/build.txt ! -path './share/doc/*' >"$work/installed.inputs"
# with the installed controllers, which are found by name
(cd "$work" && "$work/prefix/bin/argos3" -n -zc "$work/prefix/share/argos3/experiments/diffusion_10.argos" --length 1)

began "Side by side: digests, studies, users' projects, packages, site, guide, a build for robots"
longest_first=(page guide studies site outside_projects packages digests robot examples)
mapfile -t other_steps < <(list_steps | grep -vxF "$(printf '%s\n' "${longest_first[@]}")")
run_steps "${longest_first[@]}" "${other_steps[@]}"

if [[ "${CI:-}" == true ]]; then
  echo "clang-tidy follows in .ci/run"
else
  began "clang-tidy"
  # source by source and without precompiled headers, so that missing includes are found; this build is only configured
  configure "$repo/build-ci" -DCMAKE_BUILD_TYPE=Release -DARGOS_BUILD_TESTING=ON -DARGOS_WERROR=ON
  "$repo/scripts/tidy.sh" "$repo/build-ci"
fi

say "All checks passed after ${SECONDS} s"
