#include <argos3/core/utility/plugins/process_wide.h>

#include <map>
#include <typeindex>

namespace argos::detail {

namespace {

// its destruction, at the end of the process, is not thread-safe
class CObjects {
 public:
  CObjects() = default;
  CObjects(const CObjects&) = delete;
  CObjects& operator=(const CObjects&) = delete;
  ~CObjects() {
    for (auto& object : m_objects) {
      object.second.Destroy(object.second.Pointer);
    }
  }

  void* Get(const std::type_info& type, void* (*create)(), void (*destroy)(void*)) {
    // recursive, because creating an object may request another one
    const std::lock_guard<std::recursive_mutex> lock(GetRegistrationMutex());
    const auto known = m_objects.find(type);
    if (known != m_objects.end()) {
      return known->second.Pointer;
    }
    void* pointer = create();
    m_objects.emplace(type, SObject{pointer, destroy});
    return pointer;
  }

 private:
  struct SObject {
    void* Pointer;
    void (*Destroy)(void*);
  };

  std::map<std::type_index, SObject> m_objects;
};

}  // namespace

std::recursive_mutex& GetLoadingMutex() {
  // recursive, because a library may load others, or look up labels, while it is loaded
  static std::recursive_mutex mutex;
  return mutex;
}

std::recursive_mutex& GetRegistrationMutex() {
  static std::recursive_mutex mutex;
  return mutex;
}

CLookUpLock::CLookUpLock() : m_loading(GetLoadingMutex()), m_registration(GetRegistrationMutex()) {}

void* GetProcessWideObject(const std::type_info& type, void* (*create)(),
                           void (*destroy)(void* object)) {
  static CObjects objects;
  return objects.Get(type, create, destroy);
}

}  // namespace argos::detail
