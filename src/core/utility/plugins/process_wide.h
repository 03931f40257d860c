#ifndef ARGOS3_CORE_UTILITY_PLUGINS_PROCESS_WIDE_H
#define ARGOS3_CORE_UTILITY_PLUGINS_PROCESS_WIDE_H

#include <typeinfo>

namespace argos::detail {

/**
 * The one object of a type in the process; made at the first call, deleted at the end of the
 * process.
 *
 * A static variable of a template is not enough for that: a program that exports no symbols, or a
 * library compiled with hidden visibility, would have its own. This one is kept by the core
 * library.
 */
void* GetProcessWideObject(const std::type_info& type, void* (*create)(),
                           void (*destroy)(void* object));

/** The same, typed. @tparam T default-constructible. */
template <typename T>
T& GetProcessWide() {
  static T& object = *static_cast<T*>(GetProcessWideObject(
      typeid(T), []() -> void* { return new T; },
      [](void* pointer) { delete static_cast<T*>(pointer); }));
  return object;
}

}  // namespace argos::detail

#endif
