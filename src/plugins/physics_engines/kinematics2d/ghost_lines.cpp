#include <argos3/plugins/simulator/physics_engines/kinematics2d/ghost_lines.h>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace argos {

void CGhostLines::Reserve(size_t discs) {
  m_first.reserve(discs);
  m_lines.reserve(2 * discs);
}

void CGhostLines::Clear(size_t discs) {
  // most discs have no lines
  for (const SGhostLine& line : m_lines) {
    m_first[line.Slot] = kNone;
  }
  m_lines.clear();
  m_first.resize(discs, kNone);
}

void CGhostLines::Add(UInt32 slot, Real x, Real y, Real radius, UInt32 number,
                      const SGhostDisc& ghost) {
  ARGOS_ASSERT(slot < m_first.size(), "there is no disc in slot " << slot);
  const Real dx = ghost.X - x;
  const Real dy = ghost.Y - y;
  const Real distance = std::sqrt(dx * dx + dy * dy);
  if (!(distance > 0.0)) {
    // coincident centres define no line
    return;
  }
  m_lines.push_back({slot,
                     number,
                     {dx / distance, dy / distance},
                     {x, y},
                     0.5 * (distance - (radius + ghost.Radius))});
}

void CGhostLines::Sort() {
  std::sort(m_lines.begin(), m_lines.end(), [](const SGhostLine& a, const SGhostLine& b) {
    return std::tie(a.Slot, a.Ghost) < std::tie(b.Slot, b.Ghost);
  });
  for (size_t i = m_lines.size(); i-- > 0;) {
    m_first[m_lines[i].Slot] = static_cast<UInt32>(i);
  }
}

std::span<const SGhostLine> CGhostLines::Get(UInt32 slot) const {
  if (!Has(slot)) {
    return {};
  }
  const size_t first = m_first[slot];
  ARGOS_ASSERT(first < m_lines.size() && m_lines[first].Slot == slot,
               "the ghost lines of slot " << slot << " are not sorted");
  size_t end = first + 1;
  while (end < m_lines.size() && m_lines[end].Slot == slot) {
    ++end;
  }
  return {m_lines.data() + first, m_lines.data() + end};
}

}  // namespace argos
