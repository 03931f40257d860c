# This ARGoS draws without a display and has no Qt visualization, so projects skip what they guard with
# if(ARGOS_QTOPENGL_FOUND).
set(ARGOS_QTOPENGL_FOUND FALSE)
set(ARGoSQTOpenGL_FOUND FALSE)
set(ARGOS_QTOPENGL_INCLUDE_DIRS "")
set(ARGOS_QTOPENGL_LIBRARIES "")
