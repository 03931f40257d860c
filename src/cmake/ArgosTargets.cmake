# The calls with which this project defines its targets:
#
#   argos_add_core_part(utility ...)   an object library, one layer of the core
#   argos_add_core(LINK ...)           all parts merged into libargos3core_<build-for>.so, alias argos3::core
#   argos_add_plugin(media ...)        libargos3plugin_<build-for>_media.so, alias argos3::media; installed, the targets
#                                      are ARGoS::core and ARGoS::media
#   argos_add_module(name ...)         a library of controllers or loop functions, installed with the examples
#   argos_add_test(name ...)           a Catch2 program; ctest runs each of its test cases
#   argos_add_run_target()             the target run: all that is installed, without tests and benchmarks
#
# Each target has an include root of its own, made of links to the source folders, so it sees the headers of the
# targets that it links and no others: an include against the direction of dependencies does not compile.

# Makes <build>/include/<target>/argos3/<prefix> a link to a source folder and stores the root in <rootVariable>.
function(argos_link_headers rootVariable target prefix folder)
  set(root "${PROJECT_BINARY_DIR}/include/${target}")
  get_filename_component(parent "${root}/argos3/${prefix}" DIRECTORY)
  file(MAKE_DIRECTORY "${parent}")
  file(CREATE_LINK "${folder}" "${root}/argos3/${prefix}" SYMBOLIC)
  set(${rootVariable} "${root}" PARENT_SCOPE)
endfunction()

# With CMAKE_UNITY_BUILD, distributes the sources of a target over units of at most CMAKE_UNITY_BUILD_BATCH_SIZE sources (8).
# A unit with half of that number ends with its folder, so a new source changes the units of its folder and not all that
# follow in the list.
#   argos_group_sources(<target> <regular expression of the sources>)
function(argos_group_sources target pattern)
  if(NOT CMAKE_UNITY_BUILD)
    return()
  endif()
  set(most 8)
  if(CMAKE_UNITY_BUILD_BATCH_SIZE)
    set(most ${CMAKE_UNITY_BUILD_BATCH_SIZE})
  endif()
  math(EXPR enough "${most} / 2")
  get_target_property(sources ${target} SOURCES)
  list(FILTER sources INCLUDE REGEX "${pattern}")
  list(SORT sources)
  set(unit 0)
  set(size 0)
  set(lastFolder)
  foreach(source IN LISTS sources)
    get_filename_component(folder "${source}" DIRECTORY)
    if(size EQUAL most OR (size GREATER_EQUAL enough AND NOT folder STREQUAL lastFolder))
      math(EXPR unit "${unit} + 1")
      set(size 0)
    endif()
    math(EXPR size "${size} + 1")
    set(lastFolder "${folder}")
    set_source_files_properties("${source}" PROPERTIES UNITY_GROUP ${target}_${unit})
  endforeach()
  set_target_properties(${target} PROPERTIES UNITY_BUILD_MODE GROUP)
endfunction()

# Like argos_link_headers(), for headers whose include paths differ from their places in the source folder: makes one
# link for each header. Both lists are passed by name and have the same order.
function(argos_link_each_header rootVariable target prefix headersVariable includePathsVariable)
  # a folder of its own: include/<target>/argos3/<prefix> may be a link to the source folder, from an earlier configure
  set(root "${PROJECT_BINARY_DIR}/include/flat/${target}")
  file(REMOVE_RECURSE "${root}")
  foreach(header includePath IN ZIP_LISTS ${headersVariable} ${includePathsVariable})
    get_filename_component(folder "${root}/argos3/${prefix}/${includePath}" DIRECTORY)
    file(MAKE_DIRECTORY "${folder}")
    file(CREATE_LINK "${CMAKE_CURRENT_SOURCE_DIR}/${header}" "${root}/argos3/${prefix}/${includePath}" SYMBOLIC)
  endforeach()
  set(${rootVariable} "${root}" PARENT_SCOPE)
endfunction()

# Installs public headers of a folder at their include paths below include/argos3/<prefix>, and makes their hash a part
# of the build id of plug-ins. Takes the same two lists.
function(argos_install_headers library prefix folder headersVariable includePathsVariable)
  foreach(header includePath IN ZIP_LISTS ${headersVariable} ${includePathsVariable})
    get_filename_component(subfolder "${includePath}" DIRECTORY)
    install(FILES "${folder}/${header}" DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/argos3/${prefix}/${subfolder}"
      COMPONENT dev)
    argos_add_public_header(${library} "argos3/${prefix}/${includePath}" "${folder}/${header}")
  endforeach()
endfunction()

# argos_add_core_part(<name> [FOLDER <f>] INCLUDE_PREFIX <p> PUBLIC_HEADERS ... SOURCES ... [LINK ...]
#                     [LINK_PRIVATE ...] [ABOVE_PLUGINS])
#   Names of headers and sources are relative to ${CMAKE_CURRENT_SOURCE_DIR}/<f>, by default <name>. With ABOVE_PLUGINS, the part is in
#   the same library, but its headers are seen only by what links argos3::<name>.
function(argos_add_core_part name)
  cmake_parse_arguments(PARSE_ARGV 1 ARG "ABOVE_PLUGINS" "FOLDER;INCLUDE_PREFIX" "PUBLIC_HEADERS;SOURCES;LINK;LINK_PRIVATE")
  if(NOT ARG_FOLDER)
    set(ARG_FOLDER ${name})
  endif()
  set(folder "${CMAKE_CURRENT_SOURCE_DIR}/${ARG_FOLDER}")
  set(target argos3_${name})
  argos_link_headers(root ${target} ${ARG_INCLUDE_PREFIX} "${folder}")

  list(TRANSFORM ARG_SOURCES PREPEND "${folder}/")
  add_library(${target} OBJECT ${ARG_SOURCES})
  target_include_directories(${target} PUBLIC "${root}" "${PROJECT_BINARY_DIR}/include/config")
  target_link_libraries(${target} PUBLIC ${ARG_LINK} PRIVATE argos_options ${ARG_LINK_PRIVATE})
  target_compile_definitions(${target} PRIVATE ARGOS_WITHOUT_COMPANIONS)
  set_property(GLOBAL APPEND PROPERTY ARGOS_CORE_PARTS ${target})
  if(ARG_ABOVE_PLUGINS)
    add_library(argos3_${name}_headers INTERFACE)
    add_library(argos3::${name} ALIAS argos3_${name}_headers)
    target_include_directories(argos3_${name}_headers INTERFACE "${root}")
  else()
    set_property(GLOBAL APPEND PROPERTY ARGOS_CORE_ROOTS "$<BUILD_INTERFACE:${root}>")
  endif()
  argos_group_sources(${target} "\\.cpp$")
  argos_precompile(${target} library)

  argos_check_headers(${target} ${ARG_INCLUDE_PREFIX} ARG_PUBLIC_HEADERS)
  argos_install_headers(core ${ARG_INCLUDE_PREFIX} "${folder}" ARG_PUBLIC_HEADERS ARG_PUBLIC_HEADERS)
endfunction()

# Some public headers include companions, which users' code expects but which they do not need themselves, unless
# ARGOS_WITHOUT_COMPANIONS is defined, as for the simulator and its plug-ins: these include what they use.

# argos_add_core([LINK ...])
#   LINK names what the public headers need.
function(argos_add_core)
  cmake_parse_arguments(PARSE_ARGV 0 ARG "" "" "LINK")
  get_property(parts GLOBAL PROPERTY ARGOS_CORE_PARTS)
  set(target argos3core_${ARGOS_BUILD_FOR})
  add_library(${target} SHARED)
  add_library(argos3::core ALIAS ${target})
  get_property(roots GLOBAL PROPERTY ARGOS_CORE_ROOTS)
  target_link_libraries(${target} PRIVATE ${parts})
  target_include_directories(${target} PUBLIC ${roots} "$<BUILD_INTERFACE:${PROJECT_BINARY_DIR}/include/config>"
                                              "$<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>")
  target_link_libraries(${target} PUBLIC ${ARG_LINK} PRIVATE argos_options)
  # a process that forks for each run of a campaign resolves symbols once, and not each of its forks
  if(NOT APPLE)
    target_link_options(${target} PRIVATE LINKER:-z,now)
  endif()
  argos_share_build_id(${target})
  target_compile_features(${target} INTERFACE cxx_std_17)
  set_target_properties(${target} PROPERTIES LINKER_LANGUAGE CXX EXPORT_NAME core)
  install(TARGETS ${target} EXPORT ARGoSTargets LIBRARY DESTINATION ${ARGOS_LIBRARY_SUBDIR})
endfunction()

# argos_add_plugin(<name> INCLUDE_PREFIX <p> [PUBLIC_HEADERS ...] [SOURCES ...] [LINK ...] [LINK_PRIVATE ...]
#                  [CONTROL_INTERFACE_HEADERS ...] [CONTROL_INTERFACE_SOURCES ...] [FLAT_FOLDER <f>]
#                  [COMPAT_FOLDER <f> COMPAT_HEADERS ... COMPAT_SOURCES ...])
#   PUBLIC_HEADERS are installed and each compiled alone; LINK names the targets whose headers may be used (the core
#   always is); LINK_PRIVATE is third party and never leaks. The CONTROL_INTERFACE_ lists, of robots, name what lies in
#   the folder control_interface/: a build for a robot compiles that alone. FLAT_FOLDER names a folder whose sub-folders
#   group the sources but do not appear in include paths: <f>/rays/ray_caster.h is included as
#   <argos3/<p>/<f>/ray_caster.h>, in the build tree and when installed. The COMPAT_ lists name what lies in src/compat/<f>, has the same
#   include paths, and is in the same library.
function(argos_add_plugin name)
  cmake_parse_arguments(PARSE_ARGV 1 ARG "" "INCLUDE_PREFIX;FLAT_FOLDER;COMPAT_FOLDER"
    "PUBLIC_HEADERS;SOURCES;COMPAT_HEADERS;COMPAT_SOURCES;CONTROL_INTERFACE_HEADERS;CONTROL_INTERFACE_SOURCES;LINK;LINK_PRIVATE")
  list(TRANSFORM ARG_CONTROL_INTERFACE_HEADERS PREPEND control_interface/)
  list(TRANSFORM ARG_CONTROL_INTERFACE_SOURCES PREPEND control_interface/)
  set(linkedFolder)
  if(NOT ARGOS_BUILD_FOR_SIMULATOR)
    set(ARG_PUBLIC_HEADERS)
    set(ARG_SOURCES)
    set(ARG_LINK_PRIVATE)
    set(linkedFolder /control_interface)
  endif()
  set(headers ${ARG_CONTROL_INTERFACE_HEADERS} ${ARG_PUBLIC_HEADERS})
  set(sources ${ARG_CONTROL_INTERFACE_SOURCES} ${ARG_SOURCES})
  if(NOT sources)
    return()
  endif()

  set(target argos3plugin_${ARGOS_BUILD_FOR}_${name})
  set(includePaths ${headers})
  if(ARG_FLAT_FOLDER)
    list(TRANSFORM includePaths REPLACE "^${ARG_FLAT_FOLDER}/.+/" "${ARG_FLAT_FOLDER}/")
    argos_link_each_header(root ${target} ${ARG_INCLUDE_PREFIX} headers includePaths)
  else()
    argos_link_headers(root ${target} ${ARG_INCLUDE_PREFIX}${linkedFolder} "${CMAKE_CURRENT_SOURCE_DIR}${linkedFolder}")
  endif()
  add_library(${target} SHARED ${sources})
  add_library(argos3::${name} ALIAS ${target})
  target_compile_definitions(${target} PRIVATE ARGOS_WITHOUT_COMPANIONS)
  target_include_directories(${target} PUBLIC "$<BUILD_INTERFACE:${root}>")
  target_link_libraries(${target} PUBLIC argos3core_${ARGOS_BUILD_FOR} PRIVATE argos_options ${ARG_LINK_PRIVATE})
  foreach(alias IN LISTS ARG_LINK)
    if(TARGET ${alias})
      get_target_property(linked ${alias} ALIASED_TARGET)
      target_link_libraries(${target} PUBLIC ${linked})
    elseif(ARGOS_BUILD_FOR_SIMULATOR)
      message(FATAL_ERROR "argos_add_plugin(${name}): no target ${alias}; define it before")
    endif()
  endforeach()

  if(ARG_COMPAT_FOLDER)
    set(compatFolder "${PROJECT_SOURCE_DIR}/src/compat/${ARG_COMPAT_FOLDER}")
    argos_link_headers(compatRoot ${target}_compat ${ARG_INCLUDE_PREFIX} "${compatFolder}")
    target_include_directories(${target} PUBLIC "$<BUILD_INTERFACE:${compatRoot}>")
    list(TRANSFORM ARG_COMPAT_SOURCES PREPEND "${compatFolder}/")
    target_sources(${target} PRIVATE ${ARG_COMPAT_SOURCES})
    argos_install_headers(${name} ${ARG_INCLUDE_PREFIX} "${compatFolder}" ARG_COMPAT_HEADERS ARG_COMPAT_HEADERS)
  endif()
  argos_group_sources(${target} "\\.cpp$")
  argos_precompile(${target} library)
  set(checkedHeaders ${includePaths} ${ARG_COMPAT_HEADERS})
  argos_check_headers(${target} ${ARG_INCLUDE_PREFIX} checkedHeaders)
  argos_install_headers(${name} ${ARG_INCLUDE_PREFIX} "${CMAKE_CURRENT_SOURCE_DIR}" headers includePaths)
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${name})
  set_property(GLOBAL APPEND PROPERTY ARGOS_RUN_TARGETS ${target})
  install(TARGETS ${target} EXPORT ARGoSTargets LIBRARY DESTINATION ${ARGOS_LIBRARY_SUBDIR})
  argos_index_labels(${target})
endfunction()

# Writes the labels that a library registers beside it, so that it is opened only when one of them is needed. A build that
# cannot run its programs does without: then all libraries are opened at the start.
function(argos_index_labels target)
  if(NOT ARGOS_BUILD_FOR_SIMULATOR OR APPLE OR (CMAKE_CROSSCOMPILING AND NOT CMAKE_CROSSCOMPILING_EMULATOR))
    return()
  endif()
  # by which the index is known to belong to the library
  target_link_options(${target} PRIVATE LINKER:--build-id)
  add_custom_command(TARGET ${target} POST_BUILD COMMAND argos3_write_labels "$<TARGET_FILE:${target}>" VERBATIM)
  install(FILES "$<TARGET_FILE_DIR:${target}>/$<TARGET_FILE_PREFIX:${target}>$<TARGET_FILE_BASE_NAME:${target}>.labels"
    DESTINATION ${ARGOS_LIBRARY_SUBDIR})
endfunction()

# argos_add_module(<name> SOURCES ... [LINK ...] [FOLDER <f>])
#   lib<name>.so in <build>/<f>, by default <build>/experiments: found at run time when that is in ARGOS_PLUGIN_PATH.
function(argos_add_module name)
  cmake_parse_arguments(PARSE_ARGV 1 ARG "" "FOLDER" "SOURCES;LINK")
  if(NOT ARG_FOLDER)
    set(ARG_FOLDER experiments)
  endif()
  add_library(${name} MODULE ${ARG_SOURCES})
  target_link_libraries(${name} PRIVATE argos_options argos3::core ${ARG_LINK})
  set_target_properties(${name} PROPERTIES LIBRARY_OUTPUT_DIRECTORY "${PROJECT_BINARY_DIR}/${ARG_FOLDER}")
  argos_precompile(${name} library)
  if(ARG_FOLDER STREQUAL "experiments")
    set_property(GLOBAL APPEND PROPERTY ARGOS_RUN_TARGETS ${name})
    set_target_properties(${name} PROPERTIES INSTALL_RPATH "$ORIGIN/..")
    install(TARGETS ${name} LIBRARY DESTINATION ${ARGOS_LIBRARY_SUBDIR}/experiments COMPONENT examples)
  endif()
endfunction()

function(argos_add_run_target)
  get_property(targets GLOBAL PROPERTY ARGOS_RUN_TARGETS)
  if(TARGET argos3)
    add_custom_target(run DEPENDS argos3 argos3-campaign argos3-plot argos_build_file ${targets})
  endif()
endfunction()

# argos_add_test(<name> SOURCES ... [LINK ...] [LABEL <l>] [DEPENDS ...] [TIMEOUT <s>] [PROCESSORS <n>])
#   DEPENDS names targets that the test loads at run time.
function(argos_add_test name)
  cmake_parse_arguments(PARSE_ARGV 1 ARG "" "LABEL;TIMEOUT;PROCESSORS" "SOURCES;LINK;DEPENDS")
  if(NOT ARG_LABEL)
    set(ARG_LABEL unit)
  endif()
  if(NOT ARG_TIMEOUT)
    set(ARG_TIMEOUT 300)
  endif()
  if(ARGOS_SANITIZE)
    math(EXPR ARG_TIMEOUT "10 * ${ARG_TIMEOUT}")
  endif()
  if(NOT ARG_PROCESSORS)
    set(ARG_PROCESSORS 1)
  endif()
  add_executable(${name} ${ARG_SOURCES})
  target_link_libraries(${name} PRIVATE argos_options argos_test_options argos3::core argos3::program argos3::run
    ${ARG_LINK} Catch2::Catch2WithMain)
  argos_precompile(${name} test)
  # each test file has a namespace of its own, the helpers of a program have not
  set(helpers ${ARG_SOURCES})
  list(FILTER helpers EXCLUDE REGEX "_test\\.cpp$")
  set_source_files_properties(${helpers} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
  argos_group_sources(${name} "_test\\.cpp$")
  if(ARG_DEPENDS)
    add_dependencies(${name} ${ARG_DEPENDS})
  endif()
  catch_discover_tests(${name} WORKING_DIRECTORY "${PROJECT_BINARY_DIR}"
    PROPERTIES LABELS ${ARG_LABEL} TIMEOUT ${ARG_TIMEOUT} PROCESSORS ${ARG_PROCESSORS})
endfunction()
