#include <argos3/plugins/simulator/entities/warn_once.h>

#include <argos3/core/simulator/context/current.h>
#include <argos3/core/simulator/space/space.h>
#include <argos3/core/utility/logging/argos_log.h>

#include <set>

namespace argos {

namespace {

class CWarnings : public CSpaceExtension {
 public:
  std::set<std::string> Given;
};

}  // namespace

void WarnOnce(const std::string& text) {
  if (CurrentSpace().GetExtension<CWarnings>().Given.insert(text).second) {
    LOGERR << "[WARNING] " << text << std::endl;
  }
}

}  // namespace argos
