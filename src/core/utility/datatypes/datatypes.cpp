#include <argos3/core/utility/datatypes/datatypes.h>

#include <ostream>

namespace argos {

std::ostream& operator<<(std::ostream& stream, const SInt8 value) {
  return stream << static_cast<int>(value);
}

std::ostream& operator<<(std::ostream& stream, const UInt8 value) {
  return stream << static_cast<int>(value);
}

}  // namespace argos
