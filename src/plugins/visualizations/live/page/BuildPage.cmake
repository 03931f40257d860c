# Builds PAGE from SOURCE with the packages in FOLDER; without these, there is no page, and each build looks again.
file(READ "${FOLDER}/stamp" installed)
if(installed STREQUAL "")
  file(REMOVE "${PAGE}")
  return()
endif()
execute_process(
  COMMAND "${CMAKE_COMMAND}" -E env "PAGE_MODULES=${FOLDER}" "${NODE}" "${SOURCE}/build.mjs" "${PAGE}"
  RESULT_VARIABLE result)
if(NOT result EQUAL 0)
  message(FATAL_ERROR "The page of the live view cannot be built")
endif()
