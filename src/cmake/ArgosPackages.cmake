# Packages: `cpack -G DEB`, RPM or TGZ in the build folder, as scripts/package.sh calls it. Three parts:
#
#   runtime    argos3-sim            programs, libraries, manual pages
#   dev        argos3-sim-dev        headers, CMake package, pkg-config file
#   examples   argos3-sim-examples   experiments with their controllers, projects of users, pages
#
# What they depend on besides linked libraries is marked in scripts/packages.txt.
if(NOT ARGOS_BUILD_FOR_SIMULATOR)
  return()
endif()

# Sets <variable> to the packages with a mark, separated by commas.
function(argos_marked_packages variable mark)
  set(list "${PROJECT_SOURCE_DIR}/scripts/packages.txt")
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${list}")
  file(STRINGS "${list}" lines REGEX "^[^#].* ${mark}( |$)")
  list(TRANSFORM lines REPLACE " .*" "")
  list(JOIN lines ", " packages)
  set(${variable} "${packages}" PARENT_SCOPE)
endfunction()

set(CPACK_PACKAGE_NAME argos3-sim)
set(CPACK_PACKAGE_VENDOR "${PROJECT_NAME}")
set(CPACK_PACKAGE_CONTACT "The developers of argos3-sim <argos3-sim@localhost>" CACHE STRING
    "Name and address of who makes the packages")
set(CPACK_PACKAGE_VERSION "${PROJECT_VERSION}")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "simulator for swarms of robots with the interface of ARGoS 3")
set(CPACK_PACKAGE_DESCRIPTION "Runs experiments with one robot or a hundred thousand from one XML file. Controllers in C++ or Lua, \
experiments and plug-ins use the interface of ARGoS 3; the same file and seed give the same results to the bit.")
set(CPACK_RESOURCE_FILE_LICENSE "${PROJECT_SOURCE_DIR}/LICENSE")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_VERBATIM_VARIABLES ON)
set(CPACK_THREADS 0)

set(CPACK_COMPONENTS_ALL runtime dev examples)
set(CPACK_COMPONENT_RUNTIME_DESCRIPTION "Programs, libraries and manual pages.")
set(CPACK_COMPONENT_DEV_DESCRIPTION "Headers, CMake package and pkg-config file, for controllers, loop functions, plug-ins and programs.")
set(CPACK_COMPONENT_EXAMPLES_DESCRIPTION "Experiments and their controllers, projects to start from, and the user's guide.")
set(CPACK_COMPONENT_DEV_DEPENDS runtime)
set(CPACK_COMPONENT_EXAMPLES_DEPENDS runtime)

set(CPACK_ARCHIVE_COMPONENT_INSTALL OFF)

set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE "${ARGOS_RELEASE}")
set(CPACK_DEBIAN_ENABLE_COMPONENT_DEPENDS ON)
set(CPACK_DEBIAN_RUNTIME_PACKAGE_NAME argos3-sim)
set(CPACK_DEBIAN_DEV_PACKAGE_NAME argos3-sim-dev)
set(CPACK_DEBIAN_EXAMPLES_PACKAGE_NAME argos3-sim-examples)
set(CPACK_DEBIAN_RUNTIME_PACKAGE_SECTION science)
set(CPACK_DEBIAN_DEV_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_EXAMPLES_PACKAGE_SECTION science)
set(CPACK_DEBIAN_RUNTIME_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_EXAMPLES_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS "${CMAKE_LIBRARY_OUTPUT_DIRECTORY}")
argos_marked_packages(CPACK_DEBIAN_RUNTIME_PACKAGE_DEPENDS runtime)
argos_marked_packages(CPACK_DEBIAN_RUNTIME_PACKAGE_RECOMMENDS option)
argos_marked_packages(CPACK_DEBIAN_DEV_PACKAGE_DEPENDS dev)
# The original's package is argos3_simulator, an older one argos3: they install the same files, and packages of plug-ins
# depend on them. The other parts depend on this one.
set(CPACK_DEBIAN_RUNTIME_PACKAGE_CONFLICTS "argos3, argos3-simulator, argos3_simulator")
set(CPACK_DEBIAN_RUNTIME_PACKAGE_REPLACES "argos3, argos3-simulator, argos3_simulator")
set(CPACK_DEBIAN_RUNTIME_PACKAGE_PROVIDES
  "argos3-simulator (= ${PROJECT_VERSION}), argos3_simulator (= ${PROJECT_VERSION})")

set(CPACK_RPM_COMPONENT_INSTALL ON)
set(CPACK_RPM_FILE_NAME RPM-DEFAULT)
set(CPACK_RPM_MAIN_COMPONENT runtime)
set(CPACK_RPM_PACKAGE_RELEASE "${ARGOS_RELEASE}")
set(CPACK_RPM_PACKAGE_LICENSE MIT)
set(CPACK_RPM_PACKAGE_GROUP "Applications/Engineering")
set(CPACK_RPM_RUNTIME_PACKAGE_PROVIDES "argos3_simulator = ${PROJECT_VERSION}")
set(CPACK_RPM_RUNTIME_PACKAGE_CONFLICTS "argos3_simulator < 2026")
set(CPACK_RPM_DEV_PACKAGE_NAME argos3-sim-devel)
set(CPACK_RPM_EXAMPLES_PACKAGE_NAME argos3-sim-examples)
set(CPACK_RPM_DEV_PACKAGE_REQUIRES "argos3-sim = ${PROJECT_VERSION}, cmake, gcc-c++, eigen3-devel, lua-devel")
set(CPACK_RPM_EXAMPLES_PACKAGE_REQUIRES "argos3-sim = ${PROJECT_VERSION}")
# folders of the system itself
set(CPACK_RPM_EXCLUDE_FROM_AUTO_FILELIST_ADDITION /usr /usr/bin /usr/include /usr/lib /usr/lib/pkgconfig /usr/share
  /usr/share/doc /usr/share/man /usr/share/man/man1 /usr/share/mime /usr/share/mime/packages)

include(CPack)
