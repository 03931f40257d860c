#ifndef ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS3D_KEY_TABLE_H
#define ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS3D_KEY_TABLE_H

#include <argos3/core/utility/datatypes/datatypes.h>

#include <bit>
#include <initializer_list>
#include <utility>
#include <vector>

namespace argos {

/**
 * The key of a pair of bodies: hardly ever that of another pair.
 * @param parts  numbers of the parts that touch.
 */
inline UInt64 ComputePairKey(UInt64 first, UInt64 second, UInt64 parts) {
  UInt64 key = parts;
  for (const UInt64 body : {first, second}) {
    key = (key ^ body) * 0x9E3779B97F4A7C15U;
    key ^= key >> 29;
  }
  return key;
}

/**
 * Entries with a member Key, which are found by it; those of one key follow each other.
 *
 * A table of the same size as before allocates nothing. It is made at the first search.
 */
template <typename ENTRY>
class CKeyTable {
 public:
  const std::vector<ENTRY>& Get() const { return m_entries; }
  ENTRY& Add() {
    m_isFilled = false;
    return m_entries.emplace_back();
  }
  void Clear() {
    m_entries.clear();
    m_isFilled = false;
  }
  void Swap(std::vector<ENTRY>& entries) {
    std::swap(m_entries, entries);
    m_isFilled = false;
  }
  /** @return the index of the first entry of a key, or their number if there is none. */
  size_t Find(UInt64 key) {
    if (!m_isFilled) {
      Fill();
    }
    for (size_t place = key & (m_table.size() - 1); m_table[place] != 0;
         place = (place + 1) & (m_table.size() - 1)) {
      if (m_entries[m_table[place] - 1].Key == key) {
        return m_table[place] - 1;
      }
    }
    return m_entries.size();
  }

 private:
  void Fill() {
    // places for each entry, at least
    constexpr size_t kRoom = 2;
    const size_t size = std::bit_ceil(kRoom * m_entries.size() + 1);
    m_table.assign(size, 0);
    for (size_t i = 0; i < m_entries.size(); ++i) {
      if (i > 0 && m_entries[i].Key == m_entries[i - 1].Key) {
        continue;
      }
      size_t place = m_entries[i].Key & (size - 1);
      while (m_table[place] != 0) {
        place = (place + 1) & (size - 1);
      }
      m_table[place] = static_cast<UInt32>(i + 1);
    }
    m_isFilled = true;
  }

  std::vector<ENTRY> m_entries;
  std::vector<UInt32> m_table;  // hash table: 1 + index of the first entry of a key
  bool m_isFilled = false;
};

}  // namespace argos

#endif
