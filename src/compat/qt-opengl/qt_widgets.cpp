#include <argos3/plugins/simulator/visualizations/qt-opengl/qt_widgets.h>

#include <argos3/core/utility/logging/argos_log.h>

#include <mutex>
#include <set>
#include <string>

namespace argos {

void WarnOfQtName(const char* name) {
  static std::mutex mutex;
  static std::set<std::string> known;
  const std::lock_guard<std::mutex> lock(mutex);
  if (known.insert(name).second) {
    LOGERR << "[WARNING] " << name
           << " is accepted, but has no effect: there is no window, and pictures do not contain "
              "what code draws with it"
           << std::endl;
  }
}

}  // namespace argos
