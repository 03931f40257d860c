#include <argos3/plugins/simulator/physics_engines/dynamics3d/broad_phase.h>

#include <argos3/core/utility/configuration/argos_exception.h>
#include <argos3/plugins/simulator/physics_engines/dynamics3d/rigid_settings.h>

#include <algorithm>

namespace argos {

namespace {

// x or y: the axis along which the bodies are spread more
UInt32 ChooseAxis(const std::vector<SRigidBody*>& movables) {
  Real sum[2] = {0.0, 0.0};
  Real squares[2] = {0.0, 0.0};
  for (const SRigidBody* body : movables) {
    for (UInt32 axis = 0; axis < 2; ++axis) {
      sum[axis] += body->Low[axis];
      squares[axis] += body->Low[axis] * body->Low[axis];
    }
  }
  const Real count = static_cast<Real>(std::max<size_t>(movables.size(), 1));
  const Real alongX = squares[0] - sum[0] * sum[0] / count;
  const Real alongY = squares[1] - sum[1] * sum[1] / count;
  return alongX >= alongY ? 0 : 1;
}

bool Overlap(const SRigidBody& a, const SRigidBody& b, UInt32 axis) {
  return a.Low[axis] <= b.High[axis] && b.Low[axis] <= a.High[axis];
}

}  // namespace

void UpdateBounds(SRigidBody& body) {
  // bodies at rest touch within their skins
  const Real reach = body.RollerMargin + kSkin;
  const CVector3 margin(reach, reach, reach);
  for (size_t i = 0; i < body.Solids.size(); ++i) {
    dReal bounds[6];  // m: least and greatest x, y and z
    dGeomGetAABB(body.Solids[i], bounds);
    const CVector3 low = CVector3(bounds[0], bounds[2], bounds[4]) - margin;
    const CVector3 high = CVector3(bounds[1], bounds[3], bounds[5]) + margin;
    for (UInt32 axis = 0; axis < 3; ++axis) {
      body.Low[axis] = i == 0 ? low[axis] : std::min(body.Low[axis], low[axis]);
      body.High[axis] = i == 0 ? high[axis] : std::max(body.High[axis], high[axis]);
    }
  }
}

const std::vector<SRigidPair>& CBroadPhase::FindPairs(const std::vector<SRigidBody*>& movables,
                                                      const std::vector<SRigidBody*>& fixed) {
  for (SRigidBody* body : movables) {
    if (!body->Asleep) {
      UpdateBounds(*body);
    }
  }
  if (m_isChanged) {
    m_axis = ChooseAxis(movables);
    List(movables, fixed);
  }
  ARGOS_ASSERT(IsListOf(movables, fixed), "bodies were added or removed without MarkChanged()");
  Sort();
  m_isChanged = false;

  m_pairs.clear();
  const UInt32 other = 1 - m_axis;
  for (size_t i = 0; i < m_entries.size(); ++i) {
    SRigidBody& first = *m_entries[i].Body;
    for (size_t j = i + 1; j < m_entries.size() && m_entries[j].Low <= m_entries[i].High; ++j) {
      SRigidBody& second = *m_entries[j].Body;
      if ((first.IsMovable() || second.IsMovable()) && Overlap(first, second, other) &&
          Overlap(first, second, 2)) {
        m_pairs.push_back({&first, &second});
      }
    }
  }
  return m_pairs;
}

void CBroadPhase::List(const std::vector<SRigidBody*>& movables,
                       const std::vector<SRigidBody*>& fixed) {
  m_entries.clear();
  for (const auto* bodies : {&movables, &fixed}) {
    for (SRigidBody* body : *bodies) {
      m_entries.push_back({0.0, 0.0, body, static_cast<UInt32>(m_entries.size())});
    }
  }
}

// @return true if the entries are of these bodies, which are compared by address.
bool CBroadPhase::IsListOf(const std::vector<SRigidBody*>& movables,
                           const std::vector<SRigidBody*>& fixed) const {
  return m_entries.size() == movables.size() + fixed.size() &&
         std::all_of(m_entries.begin(), m_entries.end(), [&](const SEntry& entry) {
           return entry.Body == (entry.Number < movables.size()
                                     ? movables[entry.Number]
                                     : fixed[entry.Number - movables.size()]);
         });
}

// By insertion, unless bodies have changed: from one substep to the next the order hardly changes.
void CBroadPhase::Sort() {
  for (SEntry& entry : m_entries) {
    entry.Low = entry.Body->Low[m_axis];
    entry.High = entry.Body->High[m_axis];
  }
  const auto comesBefore = [](const SEntry& a, const SEntry& b) {
    return a.Low < b.Low || (a.Low == b.Low && a.Number < b.Number);
  };
  if (m_isChanged) {
    std::sort(m_entries.begin(), m_entries.end(), comesBefore);
    return;
  }
  for (size_t i = 1; i < m_entries.size(); ++i) {
    const SEntry entry = m_entries[i];
    size_t place = i;
    for (; place > 0 && comesBefore(entry, m_entries[place - 1]); --place) {
      m_entries[place] = m_entries[place - 1];
    }
    m_entries[place] = entry;
  }
}

}  // namespace argos
