# Included by scripts/mutate.sh into the project: compiles each file in MUTATED alone, outside of the unit of its
# neighbours, and writes "<file> <target>" for each into MUTATED_TARGETS. Test programs say which mutants a test reaches.
function(argos_visit_targets folder)
  get_property(targets DIRECTORY "${folder}" PROPERTY BUILDSYSTEM_TARGETS)
  foreach(target IN LISTS targets)
    get_target_property(sources ${target} SOURCES)
    foreach(source IN LISTS sources)
      get_filename_component(path "${source}" ABSOLUTE BASE_DIR "${folder}")
      if(path IN_LIST MUTATED)
        # a change may leave something unused
        set_source_files_properties("${path}" DIRECTORY "${folder}"
          PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON COMPILE_OPTIONS -w)
        file(APPEND "${MUTATED_TARGETS}" "${path} ${target}\n")
      endif()
    endforeach()
    get_target_property(launcher ${target} CXX_COMPILER_LAUNCHER)
    if(launcher)
      set_property(TARGET ${target} PROPERTY CXX_COMPILER_LAUNCHER "${here}/compile.sh" ${launcher})
    endif()
    if(target MATCHES "_tests$")
      target_sources(${target} PRIVATE "${here}/reach_listener.cpp")
      # the precompiled header has Catch2 without listeners
      set_source_files_properties("${here}/reach_listener.cpp" DIRECTORY "${folder}"
        PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON SKIP_PRECOMPILE_HEADERS ON)
    endif()
  endforeach()
  get_property(children DIRECTORY "${folder}" PROPERTY SUBDIRECTORIES)
  foreach(child IN LISTS children)
    argos_visit_targets("${child}")
  endforeach()
endfunction()

set(here "${CMAKE_CURRENT_LIST_DIR}")
function(argos_separate_mutated)
  file(WRITE "${MUTATED_TARGETS}" "")
  argos_visit_targets("${PROJECT_SOURCE_DIR}")
endfunction()
cmake_language(DEFER DIRECTORY "${CMAKE_SOURCE_DIR}" CALL argos_separate_mutated)
