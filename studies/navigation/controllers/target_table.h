#ifndef TARGET_TABLE_H
#define TARGET_TABLE_H

#include <argos3/core/utility/datatypes/byte_array.h>
#include <argos3/core/utility/datatypes/datatypes.h>

#include <array>
#include <cstddef>

/** What a robot knows of a target. */
struct STargetEntry {
  argos::UInt16 Sequence = 0;  // number of the target's broadcast; larger is fresher; 0: unknown
  argos::Real Distance = 0.0;  // length of the way to the target, cm

  bool IsKnown() const { return Sequence > 0; }
  /** True if this is fresher, or as fresh and the way is shorter. */
  bool IsBetterThan(const STargetEntry& other) const;
};

constexpr std::size_t kNumTargets = 2;

/**
 * The table of all targets, as it is broadcast: for each target its sequence number and its
 * distance, 16 bits each.
 */
class CTargetTable {
 public:
  static constexpr std::size_t kNumBytes = 4 * kNumTargets;

  CTargetTable() = default;
  explicit CTargetTable(const argos::CByteArray& message);

  const STargetEntry& operator[](std::size_t target) const { return m_entries[target]; }
  STargetEntry& operator[](std::size_t target) { return m_entries[target]; }
  argos::CByteArray ToMessage() const;

 private:
  std::array<STargetEntry, kNumTargets> m_entries;
};

#endif
