# Writes the commit and the type of the build, as "argos3 --version" shows them, unless the file has them already.
#   cmake -D FILE=<file> -D SOURCE=<repository> -D TYPE=<build type> -P WriteBuildFile.cmake
set(commit "unknown")
execute_process(COMMAND git -C "${SOURCE}" rev-parse HEAD OUTPUT_VARIABLE found ERROR_QUIET
  OUTPUT_STRIP_TRAILING_WHITESPACE RESULT_VARIABLE status)
if(status EQUAL 0 AND EXISTS "${SOURCE}/.git")
  set(commit "${found}")
  execute_process(COMMAND git -C "${SOURCE}" diff --quiet HEAD ERROR_QUIET RESULT_VARIABLE status)
  if(NOT status EQUAL 0)
    string(APPEND commit " with changes")
  endif()
endif()
file(CONFIGURE OUTPUT "${FILE}" CONTENT "ARGOS_COMMIT=${commit}\nARGOS_BUILD_TYPE=${TYPE}\n" @ONLY)
