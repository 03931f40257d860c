#ifndef ARGOS3_CORE_UTILITY_PLUGINS_PROCESS_WIDE_H
#define ARGOS3_CORE_UTILITY_PLUGINS_PROCESS_WIDE_H

#include <atomic>
#include <mutex>
#include <typeinfo>

namespace argos::detail {

/*
 * The locks of loading. Several threads may load libraries and experiments at the same time; ticks
 * use none of these locks. Lock order, including the dynamic linker's own lock:
 *
 * loading mutex > dynamic linker's lock > registration mutex
 *
 * A library that is opened by other means than CDynamicLoading registers its plug-ins without the
 * loading mutex; hence the second mutex.
 */

/**
 * Held while a library loads, and while a label is looked up: a label that is found therefore
 * belongs to a completely loaded library.
 */
std::recursive_mutex& GetLoadingMutex();

/**
 * Held briefly while process-wide data is read or changed. Code under this lock must not call the
 * dynamic linker (dlopen, dladdr) or user code.
 */
std::recursive_mutex& GetRegistrationMutex();

/** Locks both mutexes, in order; held during a look-up. */
class CLookUpLock {
 public:
  CLookUpLock();

 private:
  std::lock_guard<std::recursive_mutex> m_loading;
  std::lock_guard<std::recursive_mutex> m_registration;
};

/**
 * Returns the process-wide object of a type; created at the first call, deleted at the end of the
 * process. The caller synchronises access to its contents.
 *
 * A static variable of a template does not suffice: a program that exports no symbols, or a library
 * compiled with hidden visibility, would have its own copy. The core library keeps this one.
 */
void* GetProcessWideObject(const std::type_info& type, void* (*create)(),
                           void (*destroy)(void* object));

/** The typed version. @tparam T default-constructible. */
template <typename T>
T& GetProcessWide() {
  // not a static reference, because the guard of its initialisation would be a further lock without
  // a defined order
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
