#ifndef ARGOS3_CORE_UTILITY_DATATYPES_ANY_H
#define ARGOS3_CORE_UTILITY_DATATYPES_ANY_H

#include <argos3/core/utility/errors/argos_exception.h>
#include <argos3/core/utility/text/string_utilities.h>

#include <any>
#include <typeinfo>
#include <utility>

namespace argos {

/**
 * A value of any copyable type, or nothing. Pointers are held without heap allocation.
 *
 * any_cast() returns the value if its type is exactly the requested one, also across shared
 * libraries.
 */
class CAny {
 public:
  /** Creates an empty object. */
  CAny() = default;

  template <typename T>
  CAny(const T& object) : m_value(std::in_place_type<T>, object) {}
  CAny(const CAny&) = default;
  CAny(CAny&&) = default;
  CAny& operator=(const CAny&) = default;
  CAny& operator=(CAny&&) = default;
  ~CAny() = default;

  CAny& swap(CAny& other) {
    m_value.swap(other.m_value);
    return *this;
  }

  template <typename T>
  CAny& operator=(const T& object) {
    m_value.emplace<T>(object);
    return *this;
  }

  /** Returns the type of the value; that of void if the object is empty. */
  const std::type_info& GetType() const { return m_value.type(); }

 private:
  template <typename T>
  friend T* any_cast(CAny* any);
  template <typename T>
  friend const T* any_cast(const CAny* any);

  std::any m_value;
};

/** @return null if the value is not exactly a T. */
template <typename T>
T* any_cast(CAny* any) {
  return any == nullptr ? nullptr : std::any_cast<T>(&any->m_value);
}

template <typename T>
const T* any_cast(const CAny* any) {
  return any == nullptr ? nullptr : std::any_cast<T>(&any->m_value);
}

namespace detail {
template <typename T, typename ANY>
auto& AnyCastOrThrow(ANY& any) {
  auto* value = any_cast<T>(&any);
  if (value == nullptr) {
    THROW_ARGOSEXCEPTION("any_cast: found a value of type " << DemangledName(any.GetType())
                                                            << ", expected "
                                                            << DemangledName(typeid(T)));
  }
  return *value;
}
}  // namespace detail

/** @throws CARGoSException if the value is not exactly a T; the text names both types. */
template <typename T>
const T& any_cast(const CAny& any) {
  return detail::AnyCastOrThrow<T>(any);
}

template <typename T>
T& any_cast(CAny& any) {
  return detail::AnyCastOrThrow<T>(any);
}

}  // namespace argos

#endif
