# Installs the packages of package-lock.json in FOLDER. If that fails, the build goes on without the page: an empty stamp.
file(MAKE_DIRECTORY "${FOLDER}")
file(COPY "${SOURCE}/package.json" "${SOURCE}/package-lock.json" DESTINATION "${FOLDER}")
execute_process(
  COMMAND "${NPM}" ci --prefer-offline --ignore-scripts --no-audit --no-fund --fetch-retries=1
    --fetch-timeout=30000 --loglevel=error
  WORKING_DIRECTORY "${FOLDER}"
  TIMEOUT 300
  RESULT_VARIABLE result
  OUTPUT_VARIABLE output
  ERROR_VARIABLE output)
if(result EQUAL 0)
  file(WRITE "${FOLDER}/stamp" "installed\n")
else()
  message(WARNING "The page of the live view is not built: npm cannot install its packages.\n${output}")
  file(WRITE "${FOLDER}/stamp" "")
endif()
