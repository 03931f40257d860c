#ifndef ARGOS3_CORE_UTILITY_PLUGINS_PROCESS_WIDE_H
#define ARGOS3_CORE_UTILITY_PLUGINS_PROCESS_WIDE_H

#include <atomic>
#include <mutex>
#include <typeinfo>

namespace argos::detail {

/*
 * The locks of loading. Several threads may load libraries and experiments at the same time; a tick
 * needs none of this. Their order, with the dynamic linker's own lock between them:
 *
 *   loading mutex > the dynamic linker's > registration mutex
 *
 * A library that is opened otherwise than by CDynamicLoading registers its plug-ins without holding
 * the loading mutex; hence the second one.
 */

/**
 * Held while a library loads, and while a label is looked up: so whoever finds a label finds a
 * library that is loaded completely.
 */
std::recursive_mutex& GetLoadingMutex();

/**
 * Held while something process-wide is read or changed, for a moment: nothing that may wait for the
 * dynamic linker (dlopen, dladdr) or for user code is called under it.
 */
std::recursive_mutex& GetRegistrationMutex();

/** Both, in their order: what a look-up holds. */
class CLookUpLock {
 public:
  CLookUpLock();

 private:
  std::lock_guard<std::recursive_mutex> m_loading;
  std::lock_guard<std::recursive_mutex> m_registration;
};

/**
 * The one object of a type in the process; made at the first call, deleted at the end of the
 * process. What the object holds is for the caller to protect.
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
  // not a static reference: the guard of its initialisation would be one more lock, without an
  // order
  static std::atomic<T*> object{nullptr};
  T* known = object.load(std::memory_order_acquire);
  if (known == nullptr) {
    known = static_cast<T*>(GetProcessWideObject(
        typeid(T), []() -> void* { return new T; },
        [](void* pointer) { delete static_cast<T*>(pointer); }));
    object.store(known, std::memory_order_release);
  }
  return *known;
}

}  // namespace argos::detail

#endif
