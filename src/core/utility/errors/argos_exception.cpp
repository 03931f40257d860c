#include <argos3/core/utility/errors/argos_exception.h>

#include <argos3/core/utility/errors/line_marks.h>

#include <new>

namespace argos {

namespace {

const char* DescribeNested(std::exception& nested) {
  return dynamic_cast<std::bad_alloc*>(&nested) != nullptr ? "not enough memory" : nested.what();
}

}  // namespace

CARGoSException::CARGoSException(const std::string& what, std::exception* nested)
    : m_text(MarkLines("[FATAL] " + what +
                       (nested != nullptr ? std::string("\n") + DescribeNested(*nested) : ""))) {}

// defined here so that the core library holds the only type info of the class
CARGoSException::~CARGoSException() noexcept = default;

}  // namespace argos
