#ifndef ARGOS3_CORE_CONTROL_INTERFACE_PRINT_READINGS_H
#define ARGOS3_CORE_CONTROL_INTERFACE_PRINT_READINGS_H

#include <cstddef>
#include <ostream>

/*
 * How readings of sensors are printed. Their operators are templates, template <int = 0>, so that
 * users' own ones, which are not, have precedence.
 */

namespace argos {

/** Prints a reading: `Value=<0.5>, Angle=<...>`. @param fields  names and values by turns. */
template <typename VALUE, typename... FIELDS>
std::ostream& PrintReading(std::ostream& stream, const char* name, const VALUE& value,
                           const FIELDS&... fields) {
  stream << name << "=<" << value << ">";
  if constexpr (sizeof...(fields) > 0) {
    PrintReading(stream << ", ", fields...);
  }
  return stream;
}

namespace detail {

template <typename READING>
const READING& GetReading(const READING& reading) {
  return reading;
}
template <typename READING>
const READING& GetReading(READING* reading) {
  return *reading;
}

}  // namespace detail

/** Prints a list of readings, or of pointers: `{ Value=<0.5> } { Value=<0> }` and an end of line.
 */
template <typename LIST>
std::ostream& PrintReadings(std::ostream& stream, const LIST& list) {
  for (std::size_t i = 0; i < list.size(); ++i) {
    stream << (i == 0 ? "{ " : " { ") << detail::GetReading(list[i]) << " }";
  }
  return stream << '\n';
}

}  // namespace argos

#endif
