#include <argos3/core/utility/errors/argos_exception.h>

#include <new>

namespace argos {

CARGoSException::CARGoSException(const std::string& what, std::exception* nested)
    : m_text("[FATAL] " + what) {
  if (nested != nullptr) {
    m_text += '\n';
    m_text +=
        dynamic_cast<std::bad_alloc*>(nested) != nullptr ? "not enough memory" : nested->what();
  }
}

// defined here so that the core library holds the only type info of the class
CARGoSException::~CARGoSException() noexcept = default;

}  // namespace argos
