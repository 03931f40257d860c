# Builds PAGE from SOURCE with the packages in FOLDER. Without these there is no page, and the next build tries to install
# them again.
file(READ "${FOLDER}/stamp" installed)
if(installed STREQUAL "")
  file(REMOVE "${PAGE}" "${PAGE}.gz" "${FOLDER}/stamp")
  return()
endif()
execute_process(
  COMMAND "${CMAKE_COMMAND}" -E env "PAGE_MODULES=${FOLDER}" "${NODE}" "${SOURCE}/build.mjs" "${PAGE}"
  RESULT_VARIABLE result)
if(NOT result EQUAL 0)
  message(FATAL_ERROR "The page of the live view cannot be built")
endif()
