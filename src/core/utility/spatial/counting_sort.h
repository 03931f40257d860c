#ifndef ARGOS3_CORE_UTILITY_SPATIAL_COUNTING_SORT_H
#define ARGOS3_CORE_UTILITY_SPATIAL_COUNTING_SORT_H

#include <argos3/core/utility/datatypes/datatypes.h>
#include <argos3/core/utility/errors/argos_exception.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace argos {

/**
 * Sorts items by a small number, the key: the number of a cell, say.
 *
 * A sort is Start(), SetKey() for each item, Finish(). GetPlace() then gives the place of each item
 * in an array of the owner; the items of a key are one range of that array, from Begin() to End().
 * Items may be longer than one place. Does not allocate if there was a sort of as many items and
 * keys before, or Reserve().
 *
 * The sort is stable: items of equal keys keep their order. If keys were set on several threads at
 * once, SortRanges() has to follow; otherwise the order within a range is arbitrary.
 */
class CCountingSort {
 public:
  void Reserve(size_t items, size_t keys) {
    m_items.reserve(items);
    m_starts.reserve(keys + 1);
  }
  void Start(size_t items, size_t keys) {
    m_items.resize(items);
    m_starts.assign(keys + 1, 0);
  }
  /** @param length  number of places that the item takes. */
  void SetKey(size_t item, UInt32 key, UInt32 length = 1) {
    CheckKey(key);
    CheckItem(item);
    UInt32& end = m_starts[key + 1];
    m_items[item] = {key, end};
    end += length;
  }
  /** The same while other threads set the keys of other items. */
  void SetKeyOnThread(size_t item, UInt32 key, UInt32 length = 1) {
    CheckKey(key);
    CheckItem(item);
    // std::atomic_ref cannot be used: public headers are read as C++17, too
    m_items[item] = {key, __atomic_fetch_add(&m_starts[key + 1], length, __ATOMIC_RELAXED)};
  }
  /** Leaves an item out; instead of SetKey(). */
  void LeaveOut(size_t item) {
    CheckItem(item);
    m_items[item].Key = kLeftOut;
  }
  /** @return number of places of all items. */
  UInt32 Finish() {
    UInt32 sum = 0;
    for (UInt32& start : m_starts) {
      sum += start;
      start = sum;
    }
    return sum;
  }

  /** For how many keys a sort does not allocate. */
  size_t GetKeyCapacity() const { return m_starts.capacity() == 0 ? 0 : m_starts.capacity() - 1; }
  size_t GetNumItems() const { return m_items.size(); }
  size_t GetNumKeys() const { return m_starts.empty() ? 0 : m_starts.size() - 1; }
  bool IsLeftOut(size_t item) const {
    CheckItem(item);
    return m_items[item].Key == kLeftOut;
  }
  /** First place of an item that is not left out. */
  UInt32 GetPlace(size_t item) const {
    CheckItem(item);
    CheckKey(m_items[item].Key);
    return m_starts[m_items[item].Key] + m_items[item].Offset;
  }
  /** First place of the range of a key. */
  UInt32 Begin(UInt32 key) const {
    CheckKey(key);
    return m_starts[key];
  }
  /** One more than the last place of the range of a key. */
  UInt32 End(UInt32 key) const {
    CheckKey(key);
    return m_starts[key + 1];
  }
  /** Where Begin(key) is stored, for prefetching. */
  const UInt32* GetStartAddress(UInt32 key) const { return m_starts.data() + key; }

  /**
   * Puts the items of each range into their order after their keys were set on several threads.
   * @param pool    a CThreadPool.
   * @param sorted  the owner's array.
   * @param number  number(const T&): what the elements of a range are ordered by; unique.
   */
  template <typename POOL, typename T, typename NUMBER>
  void SortRanges(POOL& pool, std::vector<T>& sorted, NUMBER&& number) const {
    constexpr size_t kGrain = 4096;  // keys of a thread: most ranges are short
    pool.ParallelFor(GetNumKeys(), kGrain, [&](size_t begin, size_t end, UInt32) {
      for (size_t key = begin; key < end; ++key) {
        std::sort(sorted.begin() + m_starts[key], sorted.begin() + m_starts[key + 1],
                  [&number](const T& a, const T& b) { return number(a) < number(b); });
      }
    });
  }

 private:
  static constexpr UInt32 kLeftOut = ~UInt32(0);

  void CheckItem([[maybe_unused]] size_t item) const {
    ARGOS_ASSERT(item < m_items.size(),
                 "a sort of " << m_items.size() << " items has no item " << item);
  }
  void CheckKey([[maybe_unused]] UInt32 key) const {
    ARGOS_ASSERT(key < GetNumKeys(), "a sort by " << GetNumKeys() << " keys has no key " << key);
  }

  struct SItem {
    UInt32 Key;
    UInt32 Offset;  // distance from the beginning of the range
  };

  std::vector<SItem> m_items;
  std::vector<UInt32> m_starts;  // (keys + 1) until Finish(), element k + 1 counts key k
};

}  // namespace argos

#endif
