# For projects that use pkg-config and then include(ARGoSCheckQTOpenGL).
include("${CMAKE_CURRENT_LIST_DIR}/FindARGoSQTOpenGL.cmake")
