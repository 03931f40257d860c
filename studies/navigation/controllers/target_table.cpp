#include "target_table.h"

#include <algorithm>

using namespace argos;

bool STargetEntry::IsBetterThan(const STargetEntry& other) const {
  return Sequence != other.Sequence ? Sequence > other.Sequence
                                    : IsKnown() && Distance < other.Distance;
}

CTargetTable::CTargetTable(const CByteArray& message) {
  for (std::size_t i = 0; i < kNumTargets; ++i) {
    const UInt8* bytes = message.ToCArray() + 4 * i;
    m_entries[i].Sequence = static_cast<UInt16>(bytes[0] * 256 + bytes[1]);
    m_entries[i].Distance = bytes[2] * 256 + bytes[3];
  }
}

CByteArray CTargetTable::ToMessage() const {
  CByteArray message(kNumBytes);
  for (std::size_t i = 0; i < kNumTargets; ++i) {
    const auto distance = static_cast<UInt16>(std::min(m_entries[i].Distance + 0.5, 65535.0));
    const UInt16 sequence = m_entries[i].Sequence;
    message[4 * i] = static_cast<UInt8>(sequence / 256);
    message[4 * i + 1] = static_cast<UInt8>(sequence % 256);
    message[4 * i + 2] = static_cast<UInt8>(distance / 256);
    message[4 * i + 3] = static_cast<UInt8>(distance % 256);
  }
  return message;
}
