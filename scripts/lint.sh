#!/usr/bin/env bash
# Checks the project's rules that neither compiler nor formatter checks and that a text search can find. Prints each
# violation as file:line: text; the exit status is 1 if there is any.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/lib.sh"
cd "$repo"

maxHeaderLines=300
maxSourceLines=600
violations=0
mapfile -t sources < <(git ls-files --cached --others --exclude-standard -- \
  'src/*.h' 'src/*.cpp' 'experiments/*.h' 'experiments/*.cpp' 'examples/*.h' 'examples/*.cpp' |
  while IFS= read -r file; do [[ -f "$file" ]] && echo "$file"; done)
((${#sources[@]} > 0)) || die "found no sources"

report() { # report <rule> <found lines>
  [[ -z "$2" ]] && return 0
  printf '%s\n' "$2" | sed "s|\$|    [$1]|"
  violations=$((violations + $(printf '%s\n' "$2" | wc -l)))
}

only() { # only <extended regular expression on paths>: the sources that match
  printf '%s\n' "${sources[@]}" | grep -E "$1" || true
}

search() { # search <extended regular expression> <files...>: ignores comments and literals
  local pattern="$1"
  shift
  (($# > 0)) || return 0
  awk -v pattern="$pattern" '
    FNR == 1 { inComment = inRaw = 0 }
    {
      line = $0
      if (inRaw) {
        if (!sub(/^.*\)"/, "", line)) next
        inRaw = 0
      }
      gsub(/R"\([^)]*\)"/, "\"\"", line)
      if (sub(/R"\(.*/, "", line)) inRaw = 1
      gsub(/\\./, "", line)
      gsub(/"[^"]*"/, "\"\"", line)
      if (inComment) {
        if (!sub(/^.*\*\//, "", line)) next
        inComment = 0
      }
      gsub(/\/\*([^*]|\*+[^*\/])*\*+\//, "", line)
      sub(/\/\/.*/, "", line)
      if (sub(/\/\*.*/, "", line)) inComment = 1
      if (line ~ pattern) print FILENAME ":" FNR ": " $0
    }' "$@"
}

includes() { # includes <regular expression of paths> <forbidden include prefix>: companions do not count
  local files
  mapfile -t files < <(only "$1")
  ((${#files[@]} == 0)) || forbidden="#include *[<\"]($2)" awk '
    FNR == 1 { isCompanion = 0 }
    /^#ifndef ARGOS_WITHOUT_COMPANIONS/ { isCompanion = 1 }
    /^#endif/ { isCompanion = 0 }
    !isCompanion && $0 ~ ENVIRON["forbidden"] { print FILENAME ":" FNR ":" $0 }' "${files[@]}"
}

# The direction of dependencies. The include roots of the build enforce it, too; these rules give clearer messages.
report "utility includes nothing above it" \
  "$(includes '^src/core/utility/' 'argos3/(core/(control_interface|simulator|wrappers)|plugins)/')"
report "the control interface includes utility only" \
  "$(includes '^src/core/control_interface/' 'argos3/(core/(simulator|wrappers)|plugins)/')"
# The include graph of these folders, without companions, which a header includes for users' code alone.
arrows_upward() {
  local files
  mapfile -t files < <(only '^src/(core|support|run|program)/')
  awk -v layersFile=scripts/layers.txt '
    BEGIN {
      while ((getline line < layersFile) > 0) {
        if (line ~ /^#/) continue
        ++layer
        n = split(line, folders, " ")
        for (i = 1; i <= n; ++i) layerOf[folders[i]] = layer
      }
    }
    FNR == 1 {
      isCompanion = 0
      folder = FILENAME
      sub(/^src\//, "", folder); sub(/\/[^\/]*$/, "", folder)
      if (!(folder in layerOf)) print FILENAME ":1: " folder " is not in " layersFile
    }
    /^#ifndef ARGOS_WITHOUT_COMPANIONS/ { isCompanion = 1 }
    /^#endif/ { isCompanion = 0 }
    !isCompanion && match($0, /^ *# *include *<argos3\/(core|support|run|program)\//) {
      included = $0
      sub(/^[^<]*<argos3\//, "", included); sub(/\/[^\/]*>.*$/, "", included)
      if (included != folder && layerOf[included] >= layerOf[folder])
        print FILENAME ":" FNR ": " folder " is not above " included
    }' "${files[@]}"
}
report "no include leads upward (scripts/layers.txt)" "$(arrows_upward)"
report "statistics include the utility of the core only" \
  "$(includes '^src/campaign/statistics/' 'argos3/(core/(control_interface|simulator|wrappers)|plugins|campaign/[^s]|campaign/s[^t])')"
report "reports of campaigns include design, store, statistics and the utility of the core only" \
  "$(includes '^src/campaign/report/' 'argos3/(core/(control_interface|simulator|wrappers)|plugins|campaign/(execution|scheduling|slurm|program))')"
report "the core includes no plug-in" "$(includes '^src/core/' 'argos3/plugins/')"
report "run and program include no plug-in, and plug-ins neither" \
  "$(includes '^src/(run|program)/' 'argos3/plugins/')$(includes '^src/plugins/' 'argos3/(run|program)/')"
report "a control interface includes no simulator" \
  "$(includes '^src/plugins/robots/[^/]*/control_interface/' 'argos3/(core/simulator|plugins/simulator|plugins/robots/[^/]*/simulator)/')"
report "a robot includes no engine" "$(includes '^src/plugins/robots/' 'argos3/plugins/simulator/physics_engines/')"
report "an engine includes no robot" "$(includes '^src/plugins/physics_engines/' 'argos3/plugins/robots/')"
report "include by the public path, <argos3/...>" \
  "$(includes '^src/(core|compat|support|run|program|plugins|campaign)/' '\.\./')"

mapfile -t ours < <(only '^src/(core|compat|support|run|program|plugins|campaign)/')
# simulator.cpp defines it; command_line.cpp is the program that runs the thread's simulator, as users' programs do
mapfile -t noInstance < <(printf '%s\n' "${ours[@]}" |
  grep -vE '^src/(core/simulator/simulator|program/command_line)\.cpp$')
report "GetInstance() is for users: take what you need as a parameter" \
  "$(search 'CSimulator::GetInstance *\(' "${noInstance[@]}")"
report "no #pragma once: guards are ARGOS3_<PATH>_H" "$(grep -nH '^ *#pragma once' "${sources[@]}" || true)"
report "never dlclose" "$(search '(^|[^A-Za-z_])dlclose *\(' "${ours[@]}")"

# Ownership: unique_ptr everywhere, except where the ARGoS API transfers ownership by raw pointers:
#   plugins/factory*, plugins/process_wide.h           objects from factories, objects that exist as long as the process
#   REGISTER_* in ci_controller.h                      the same
#   ci_controller.cpp                                  a controller deletes the devices that were added to it
#   byte_array.cpp                                     parts are returned as new objects
#   simulator.cpp                                      the singleton, whose constructor is private
#   memory/object_slabs.cpp                            the allocator itself
# Tests use the API of users, including raw ownership.
rawOwners='^src/core/(utility/plugins/(factory|process_wide)|control_interface/ci_controller\.|utility/datatypes/byte_array\.cpp|utility/memory/object_slabs\.cpp|simulator/simulator\.cpp)'
mapfile -t owners < <(only '^(src/(core|compat|support|run|program|plugins|campaign)|experiments)/' | grep -vE "$rawOwners")
report "no raw new: std::make_unique" \
  "$(search '(^|[^A-Za-z0-9_.>])new +[A-Za-z_:(]' "${owners[@]}" | grep -v 'operator new' || true)"
report "no raw delete: std::unique_ptr" \
  "$(search '(^|[^A-Za-z0-9_=.>]|[^= ] +)delete(\[\])? +[A-Za-z_:(*]' "${owners[@]}" | grep -v 'operator delete' || true)"

mapfile -t noLoadAhead < <(printf '%s\n' "${ours[@]}" | grep -v '^src/core/utility/memory/load_ahead\.h$')
report "prefetch only through memory/load_ahead.h" "$(search '[Pp]refetch' "${noLoadAhead[@]}")"

report "bounds are named kMax and kMin" "$(grep -nHE '\<k(Most|Largest|Least|Smallest)([A-Z0-9]|\>)' "${sources[@]}" || true)"
report "no TODO, FIXME or XXX" "$(grep -nHE '\<(TODO|FIXME|XXX)\>' "${sources[@]}" || true)"

guards() {
  local headers
  mapfile -t headers < <(only '^src/(core|compat|support|run|program|plugins|campaign|testing)/.*\.h$' | grep -vE '^src/testing/compat/(user_|projects/)')
  awk '
    function finish() {
      if (file != "" && found < 2) print file ":1: the guard should be " guard
    }
    FNR == 1 {
      finish()
      file = FILENAME
      guard = toupper(file)
      sub(/^SRC\//, "", guard); sub(/\.H$/, "", guard); gsub(/[\/-]/, "_", guard)
      guard = "ARGOS3_" guard "_H"
      found = 0
    }
    $0 == "#ifndef " guard || $0 == "#define " guard { ++found }
    END { finish() }' "${headers[@]}"
}
report "include guards are paths" "$(guards)"

# the files of src/testing/compat/ are lists of signatures
lengths() {
  printf '%s\0' "${sources[@]}" | grep -zv '^src/testing/compat/' | xargs -0 wc -l |
    awk -v header="$maxHeaderLines" -v source="$maxSourceLines" '
      $2 == "total" { next }
      { limit = $2 ~ /\.h$/ ? header : source }
      $1 > limit { print $2 ":" $1 ": longer than " limit " lines" }'
}
report "files are short" "$(lengths)"

# Plug-ins share one namespace, and the linker merges template instances over different types with the same name.
types_with_one_name() {
  local headers
  mapfile -t headers < <(only '^src/(core|compat|support|run|program|plugins|campaign)/.*\.h$')
  awk 'match($0, /^(struct|class|enum|union) [A-Za-z_0-9 ]+[^;]*$/) {
         line = $0
         sub(/^enum (class |struct )?/, "", line); sub(/^(struct|class|union) /, "", line)
         name = line; sub(/[^A-Za-z_0-9].*$/, "", name)
         if (line ~ /[<;]/ || substr(line, length(name) + 1, 2) == "::") next
         if (name in where && where[name] != FILENAME)
           print FILENAME ":" FNR ": " name " is defined in " where[name] ", too"
         where[name] = FILENAME
       }' "${headers[@]}"
}
report "types of plug-ins have unique names" "$(types_with_one_name)"

python_errors() {
  git ls-files -z --cached --others --exclude-standard -- '*.py' | xargs -0 python3 -c '
import os, sys
for file in filter(os.path.exists, sys.argv[1:]):
    try:
        compile(open(file, encoding="utf-8").read(), file, "exec")
    except (SyntaxError, ValueError) as error:
        print(f"{file}:1: {error}")'
}
report "Python scripts compile" "$(python_errors)"

if ((violations > 0)); then
  echo "lint: $violations violation(s)"
  exit 1
fi
echo "lint: ${#sources[@]} files are fine"
