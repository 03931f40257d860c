#include <argos3/testing/support/paths.h>

namespace argos {

std::string InSourceTree(const std::string& path) {
  return ARGOS_TEST_SOURCE_DIR "/" + path;
}

std::string InBuildTree(const std::string& path) {
  return ARGOS_TEST_BINARY_DIR "/" + path;
}

}  // namespace argos
