# shellcheck shell=bash
# That it builds is the test of CMake's part. Without CMake, a level that is too low gives one message.
include="$(dirname "$(command -v argos3)")/../include"
for header in core/control_interface/ci_controller.h core/simulator/loop_functions.h core/utility/math/vector2.h \
  core/utility/datatypes/set.h plugins/robots/foot-bot/simulator/footbot_entity.h; do
  echo "#include <argos3/$header>" >header.cpp
  if c++ -std=c++11 -fsyntax-only -I"$include" header.cpp 2>errors; then
    echo "$header compiled as C++11"
    exit 1
  fi
  grep 'error:' errors | head -n 1 | grep 'ARGoS needs C++17 or later: compile with -std=gnu++17' >found
  grep -c 'error:' errors | expect "errors of $header (one, and the end of the compilation)" 1 2 0
done
