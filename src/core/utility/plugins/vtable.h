#ifndef ARGOS3_CORE_UTILITY_PLUGINS_VTABLE_H
#define ARGOS3_CORE_UTILITY_PLUGINS_VTABLE_H

/*
 * The cooperative visitor: every class of a hierarchy has an integer tag, every kind of operation a
 * flat table indexed by tag. Calling an operation takes two array look-ups and no dynamic_cast.
 *
 * The core library stores tags and tables, so that all shared libraries agree on them.
 */

#include <argos3/core/config.h>  // checks the language level
#include <argos3/core/utility/plugins/process_wide.h>

#include <atomic>
#include <cstddef>
#include <memory>
#include <mutex>
#include <typeinfo>
#include <utility>
#include <vector>

namespace argos {

/** The number of tags of a hierarchy. */
template <typename BASE>
struct STagCounter {
  static std::size_t Count;
};
template <typename BASE>
std::size_t STagCounter<BASE>::Count = 0;

namespace detail {
/**
 * Returns the tag of a pair of classes, assigning a new one if necessary; sets the counter to that
 * of the base.
 */
std::size_t GetTagOf(const std::type_info& derived, const std::type_info& base,
                     std::size_t& counter);
}  // namespace detail

/** The tag of a class in a hierarchy: from 1 up, in the order of the first requests. */
template <typename DERIVED, typename BASE>
std::size_t GetTag() {
  static const std::size_t tag =
      detail::GetTagOf(typeid(DERIVED), typeid(BASE), STagCounter<BASE>::Count);
  return tag;
}

/** The same tag, as an object. */
template <typename DERIVED, typename BASE>
struct STagHolder {
  static std::size_t Tag;
};
template <typename DERIVED, typename BASE>
std::size_t STagHolder<DERIVED, BASE>::Tag = ::argos::GetTag<DERIVED, BASE>();

/**
 * Base class of the root of a hierarchy, which also uses ENABLE_VTABLE() to declare the virtual
 * GetTag(). Not polymorphic, to avoid a second table pointer in every entity.
 */
template <typename BASE>
struct EnableVTableFor {
  template <typename DERIVED>
  std::size_t GetTagHelper(const DERIVED*) const {
    return ::argos::GetTag<DERIVED, BASE>();
  }

 protected:
  ~EnableVTableFor() = default;
};

/**
 * A table of functions, one per class of a hierarchy.
 *
 * Thread safe; reading takes no lock: adding an entry creates a new table, and earlier tables stay
 * valid for concurrent readers. The number of entries is the number of classes; they are added
 * while libraries load.
 *
 * @tparam CONTEXT   distinguishes tables of different operations.
 * @tparam FUNCTION  default-constructible and copyable, such as a pointer to a function.
 */
template <typename CONTEXT, typename BASE, typename FUNCTION>
class CVTable {
 public:
  /** Sets the entry of a class. */
  template <typename DERIVED>
  void Add(FUNCTION function) {
    const std::size_t tag = GetTag<DERIVED, BASE>();
    const std::lock_guard<std::recursive_mutex> lock(detail::GetRegistrationMutex());
    auto entries = m_generations.empty() ? std::make_unique<TEntries>()
                                         : std::make_unique<TEntries>(*m_generations.back());
    if (entries->size() <= tag) {
      entries->resize(tag + 1);
    }
    (*entries)[tag] = SEntry{function, true};
    m_generations.push_back(std::move(entries));
    m_entries.store(m_generations.back().get(), std::memory_order_release);
  }

  /** Returns the entry of a tag; if there is none, that of BASE, otherwise FUNCTION(). */
  FUNCTION operator[](std::size_t index) const {
    const TEntries* const entries = m_entries.load(std::memory_order_acquire);
    if (entries == nullptr) {
      return FUNCTION();
    }
    if (index < entries->size() && (*entries)[index].IsSet) {
      return (*entries)[index].Function;
    }
    const std::size_t base = GetTag<BASE, BASE>();
    return base < entries->size() ? (*entries)[base].Function : FUNCTION();
  }

  /** One more than the highest tag that has an entry; 0 if there is none. */
  std::size_t Size() const {
    const TEntries* const entries = m_entries.load(std::memory_order_acquire);
    return entries == nullptr ? 0 : entries->size();
  }

 private:
  struct SEntry {
    FUNCTION Function{};
    bool IsSet = false;
  };

  typedef std::vector<SEntry> TEntries;

  std::vector<std::unique_ptr<const TEntries>> m_generations;
  std::atomic<const TEntries*> m_entries{nullptr};  // the latest generation
};

/** The table of a context, one per process. */
template <typename CONTEXT, typename BASE, typename FUNCTION>
CVTable<CONTEXT, BASE, FUNCTION>& GetVTable() {
  return detail::GetProcessWide<CVTable<CONTEXT, BASE, FUNCTION>>();
}

}  // namespace argos

/**
 * Gives a class its own tag: use it in the public part of every class of the hierarchy. A class
 * without it is treated as its base class.
 */
// "virtual" and not "override", because users' classes do not use override elsewhere, and compilers
// warn of inconsistent use
#ifdef __clang__
#define ENABLE_VTABLE()                                                                           \
  _Pragma("clang diagnostic push")                                                                \
      _Pragma("clang diagnostic ignored \"-Winconsistent-missing-override\"") virtual std::size_t \
      GetTag() {                                                                                  \
    return this->GetTagHelper(this);                                                              \
  }                                                                                               \
  _Pragma("clang diagnostic pop")
#else
#define ENABLE_VTABLE()              \
  virtual std::size_t GetTag() {     \
    return this->GetTagHelper(this); \
  }
#endif

/**
 * Reserves the first tag for the root of a hierarchy; use it once per hierarchy, in a source file.
 */
#define INIT_VTABLE_FOR(BASE) \
  [[maybe_unused]] static const std::size_t argosRootTagOf##BASE = ::argos::GetTag<BASE, BASE>();

#ifndef ARGOS_WITHOUT_COMPANIONS
#include <argos3/core/utility/logging/argos_log.h>
#endif

#endif
