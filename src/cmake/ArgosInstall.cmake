# What is installed besides libraries, programs and headers: the CMake package ARGoS, a pkg-config file, shell completion,
# manual pages, documentation, experiments and examples. Components: runtime, dev, examples; see ArgosPackages.cmake.
include(CMakePackageConfigHelpers)
set(argosCmakeDir "${CMAKE_INSTALL_DATAROOTDIR}/argos3/cmake")
set(argosGenerated "${PROJECT_BINARY_DIR}/generated")

configure_package_config_file(src/cmake/install/ARGoSConfig.cmake.in "${argosGenerated}/ARGoSConfig.cmake"
  INSTALL_DESTINATION "${argosCmakeDir}" PATH_VARS CMAKE_INSTALL_INCLUDEDIR ARGOS_LIBRARY_SUBDIR
  NO_CHECK_REQUIRED_COMPONENTS_MACRO)
foreach(file ARGoSConfigVersion.cmake ARGoSSettings.cmake FindARGoSQTOpenGL.cmake)
  configure_file(src/cmake/install/${file}.in "${argosGenerated}/${file}" @ONLY)
endforeach()
install(FILES "${argosGenerated}/ARGoSConfig.cmake" "${argosGenerated}/ARGoSConfigVersion.cmake"
              "${argosGenerated}/ARGoSSettings.cmake" "${argosGenerated}/FindARGoSQTOpenGL.cmake"
              src/cmake/FindFreeImage.cmake
        DESTINATION "${argosCmakeDir}" COMPONENT dev)
# beside the package's own files, finders that users' projects count on
foreach(file ARGoSCheckQTOpenGL ARGoSLanguageLevel ARGoSLua FindDLFCN FindGooglePerfTools FindLua51 FindLua52 FindLua53
             FindPthreads)
  install(FILES src/cmake/install/${file}.cmake DESTINATION "${argosCmakeDir}" COMPONENT dev)
endforeach()
install(EXPORT ARGoSTargets NAMESPACE ARGoS:: FILE ARGoSTargets-${ARGOS_BUILD_FOR}.cmake DESTINATION "${argosCmakeDir}"
        COMPONENT dev)

install(FILES "${PROJECT_BINARY_DIR}/include/config/argos3/core/config.h"
        DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/argos3/core" COMPONENT dev)

configure_file(src/cmake/install/argos3.pc.in "${argosGenerated}/argos3_${ARGOS_BUILD_FOR}.pc" @ONLY)
install(FILES "${argosGenerated}/argos3_${ARGOS_BUILD_FOR}.pc" DESTINATION lib/pkgconfig COMPONENT dev)

if(ARGOS_BUILD_FOR_SIMULATOR)
  install(FILES src/cmake/install/argos.xml DESTINATION "${CMAKE_INSTALL_DATAROOTDIR}/mime/packages")

  # each package has its licence where Debian looks for it
  set(argosDocDir "${CMAKE_INSTALL_DATAROOTDIR}/doc")
  install(FILES LICENSE RENAME copyright DESTINATION "${argosDocDir}/argos3-sim")
  install(FILES LICENSE RENAME copyright DESTINATION "${argosDocDir}/argos3-sim-dev" COMPONENT dev)
  install(FILES LICENSE RENAME copyright DESTINATION "${argosDocDir}/argos3-sim-examples" COMPONENT examples)
  install(FILES CHANGELOG.md CITATION.cff DESTINATION "${argosDocDir}/argos3-sim")
  # pages and their pictures, with the same paths between them as in the sources
  install(FILES README.md DESTINATION "${argosDocDir}/argos3-sim-examples" COMPONENT examples)
  install(DIRECTORY doc DESTINATION "${argosDocDir}/argos3-sim-examples" COMPONENT examples)
  install(DIRECTORY examples DESTINATION "${CMAKE_INSTALL_DATAROOTDIR}/argos3" COMPONENT examples
          PATTERN "build*" EXCLUDE PATTERN "*.csv" EXCLUDE)
  install(DIRECTORY experiments DESTINATION "${CMAKE_INSTALL_DATAROOTDIR}/argos3" COMPONENT examples
          PATTERN "CMakeLists.txt" EXCLUDE PATTERN "*.sqlite*" EXCLUDE PATTERN "*.report" EXCLUDE PATTERN "*.runs" EXCLUDE)

  # in a file and not in the code, so that a commit links nothing again
  set(argosBuildFile "${PROJECT_BINARY_DIR}/share/argos3/build.txt")
  add_custom_target(argos_build_file ALL
    COMMAND "${CMAKE_COMMAND}" -D "FILE=${argosBuildFile}" -D "SOURCE=${PROJECT_SOURCE_DIR}"
            -D "TYPE=$<CONFIG>" -P "${PROJECT_SOURCE_DIR}/src/cmake/WriteBuildFile.cmake"
    BYPRODUCTS "${argosBuildFile}" COMMENT "Noting the commit" VERBATIM)
  install(FILES "${argosBuildFile}" DESTINATION "${CMAKE_INSTALL_DATAROOTDIR}/argos3")

  # schemas of experiment files, for editors: the program makes them from its plug-ins
  file(CONFIGURE OUTPUT "${argosGenerated}/InstallSchemas.cmake" CONTENT [=[
set(folder "$ENV{DESTDIR}${CMAKE_INSTALL_PREFIX}/@CMAKE_INSTALL_DATAROOTDIR@/argos3")
foreach(format rng rnc)
  message(STATUS "Installing: ${folder}/argos.${format}")
  execute_process(COMMAND "${CMAKE_COMMAND}" -E env "ARGOS_PLUGIN_PATH=@CMAKE_LIBRARY_OUTPUT_DIRECTORY@"
      "@PROJECT_BINARY_DIR@/bin/argos3" --schema ${format}
    OUTPUT_FILE "${folder}/argos.${format}" ERROR_VARIABLE errors RESULT_VARIABLE status)
  if(NOT status EQUAL 0)
    file(REMOVE "${folder}/argos.${format}")
    message(WARNING "The schema of experiment files cannot be made: ${errors}")
  endif()
endforeach()
file(COPY "@PROJECT_SOURCE_DIR@/src/cmake/install/schemas.xml" DESTINATION "${folder}")
]=] @ONLY)
  install(SCRIPT "${argosGenerated}/InstallSchemas.cmake")
endif()
if(ARGOS_INSTALL_LDSOCONF STREQUAL "AUTO")
  # Our programs and libraries find each other without it, but not users' programs and plug-ins that are installed without
  # a run path. Not in packages, whose files are put together in another folder.
  install(CODE [=[
if("$ENV{DESTDIR}" STREQUAL "" AND CMAKE_INSTALL_PREFIX MATCHES "^/(usr|usr/local|opt|opt/local)$" AND
   IS_DIRECTORY /etc/ld.so.conf.d)
  execute_process(COMMAND id -u OUTPUT_VARIABLE user OUTPUT_STRIP_TRAILING_WHITESPACE)
  if(user EQUAL 0)
    message(STATUS "Installing: /etc/ld.so.conf.d/argos3.conf")
    file(WRITE /etc/ld.so.conf.d/argos3.conf "${CMAKE_INSTALL_PREFIX}/lib/argos3\n")
  endif()
endif()
]=])
elseif(ARGOS_INSTALL_LDSOCONF)
  file(CONFIGURE OUTPUT "${argosGenerated}/argos3.conf" CONTENT "@CMAKE_INSTALL_PREFIX@/lib/argos3\n" @ONLY)
  install(FILES "${argosGenerated}/argos3.conf" DESTINATION /etc/ld.so.conf.d)
endif()

# for the build tree
set(argosPluginPath "${CMAKE_LIBRARY_OUTPUT_DIRECTORY}")
if(ARGOS_BUILD_EXPERIMENTS)
  string(APPEND argosPluginPath ":${PROJECT_BINARY_DIR}/experiments")
endif()
configure_file(src/cmake/install/setup_env.sh.in "${PROJECT_BINARY_DIR}/setup_env.sh" @ONLY)
# where recipes for ARGoS 3 expect them
configure_file(src/cmake/install/argos_post_install.sh.in "${PROJECT_BINARY_DIR}/argos_post_install.sh" @ONLY
  FILE_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
if(ARGOS_BUILD_FOR_SIMULATOR)
  file(MAKE_DIRECTORY "${PROJECT_BINARY_DIR}/core")
  file(CREATE_LINK ../bin/argos3 "${PROJECT_BINARY_DIR}/core/argos3" SYMBOLIC)
endif()
