#ifndef ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS2D_TOUCH_MEMORY_H
#define ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS2D_TOUCH_MEMORY_H

#include <argos3/plugins/simulator/physics_engines/dynamics2d/contact_memory.h>

#include <algorithm>
#include <tuple>
#include <vector>

namespace argos {

/** The forces of the contact points of solids at the end of the last tick: see CContactMemory. */
class CTouchMemory {
 public:
  /** Names a contact point while no body is added or removed. */
  struct SKey {
    UInt32 A, B;  // bodies; B may be an obstacle
    UInt32 Parts;  // of the two, and the number of the point

    friend bool operator==(const SKey&, const SKey&) = default;
    friend bool operator<(const SKey& a, const SKey& b) {
      return std::tie(a.A, a.B, a.Parts) < std::tie(b.A, b.B, b.Parts);
    }
  };

  void Reserve(size_t points) { m_points.reserve(points); }
  void Clear() { m_points.clear(); }
  bool IsEmpty() const { return m_points.empty(); }
  void Collect(const SKey& key, const SContactForce& force) { m_points.push_back({key, force}); }
  /** After all are collected. */
  void Finish() {
    std::sort(m_points.begin(), m_points.end(),
              [](const SPoint& a, const SPoint& b) { return a.Key < b.Key; });
  }
  /** Safe on several threads. @return no force if there was no such contact. */
  SContactForce Find(const SKey& key) const {
    const auto found = std::lower_bound(
        m_points.begin(), m_points.end(), key,
        [](const SPoint& point, const SKey& wanted) { return point.Key < wanted; });
    return found != m_points.end() && found->Key == key ? found->Force : SContactForce();
  }

 private:
  struct SPoint {
    SKey Key;
    SContactForce Force;
  };

  std::vector<SPoint> m_points;  // by key
};

}  // namespace argos

#endif
