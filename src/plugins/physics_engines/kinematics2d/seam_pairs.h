#ifndef ARGOS3_PLUGINS_PHYSICS_ENGINES_KINEMATICS2D_SEAM_PAIRS_H
#define ARGOS3_PLUGINS_PHYSICS_ENGINES_KINEMATICS2D_SEAM_PAIRS_H

#include <argos3/core/utility/datatypes/datatypes.h>

#include <algorithm>
#include <limits>
#include <span>
#include <utility>
#include <vector>

namespace argos {

/** Pairs of discs, by place, that may touch across a seam of a periodic arena in a tick. */
class CSeamPairs {
 public:
  /** Removes all pairs. @param places  their number. */
  void Clear(size_t places) {
    m_pairs.clear();
    m_first.assign(places, kNone);
  }
  /** Adds a pair in both directions. */
  void Add(UInt32 a, UInt32 b) {
    m_pairs.emplace_back(a, b);
    m_pairs.emplace_back(b, a);
  }
  /** To be called after the last Add(). */
  void Sort() {
    std::sort(m_pairs.begin(), m_pairs.end());
    for (size_t i = m_pairs.size(); i-- > 0;) {
      m_first[m_pairs[i].first] = static_cast<UInt32>(i);
    }
  }
  bool Has(UInt32 place) const { return !m_pairs.empty() && m_first[place] != kNone; }
  /** Calls visit(other) for the partners of a disc until it returns true. @return true if it did.
   */
  template <typename VISIT>
  bool ForPartners(UInt32 place, VISIT&& visit) const {
    if (!Has(place)) {
      return false;
    }
    for (size_t i = m_first[place]; i < m_pairs.size() && m_pairs[i].first == place; ++i) {
      if (visit(m_pairs[i].second)) {
        return true;
      }
    }
    return false;
  }

 private:
  static constexpr UInt32 kNone = std::numeric_limits<UInt32>::max();

  std::vector<std::pair<UInt32, UInt32>> m_pairs;  // a place and its partner
  std::vector<UInt32> m_first;  // (discs by place) into m_pairs
};

}  // namespace argos

#endif
