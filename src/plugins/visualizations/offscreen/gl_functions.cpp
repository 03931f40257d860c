#include <argos3/plugins/simulator/visualizations/offscreen/gl_functions.h>

#include <argos3/core/utility/configuration/argos_exception.h>

namespace argos {

void SGlFunctions::Load(const std::function<TAnyFunction(const char*)>& getAddress) {
#define ARGOS_GL_LOAD(TYPE, NAME)                                                             \
  NAME = reinterpret_cast<TYPE>(getAddress("gl" #NAME));                                      \
  if (NAME == nullptr) {                                                                      \
    THROW_ARGOSEXCEPTION("The OpenGL library has no function \"gl" #NAME                      \
                         "\"; OpenGL 3.3 or later is needed (Debian: libgl1-mesa-dri 22.3)"); \
  }
  ARGOS_GL_FUNCTIONS(ARGOS_GL_LOAD)
#undef ARGOS_GL_LOAD
}

}  // namespace argos
