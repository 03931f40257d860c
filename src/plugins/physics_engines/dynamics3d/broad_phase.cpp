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

}  // namespace

void UpdateBounds(SRigidBody& body, Real path) {
  // bodies at rest touch within their skins
  const Real reach = body.RollerMargin + kSkin + path;
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

Real ComputeRimSpeed(const SRigidBody& body) {
  if (body.Body == nullptr || IsBall(body)) {
    return 0.0;
  }
  const Real turn = FromODE(dBodyGetAngularVel(body.Body)).Length();
  const CVector3 centre = FromODE(dBodyGetPosition(body.Body));
  Real rim = 0.0;
  for (size_t i = 0; turn > 0.0 && i < body.Solids.size(); ++i) {
    dReal bounds[6];  // m: least and greatest x, y and z
    dGeomGetAABB(body.Solids[i], bounds);
    const CVector3 low(bounds[0], bounds[2], bounds[4]);
    const CVector3 high(bounds[1], bounds[3], bounds[5]);
    rim = std::max(rim, ((low + high) * 0.5 - centre).Length() + 0.5 * (high - low).Length());
  }
  return turn * rim;
}

const std::vector<SRigidPair>& CBroadPhase::FindPairs(const std::vector<SRigidBody*>& movables,
                                                      const std::vector<SRigidBody*>& fixed,
                                                      Real substep, bool anticipates) {
  for (SRigidBody* body : movables) {
    if (!body->Asleep) {
      // the margin of robots is wider than their way
      const bool reaches = IsBall(*body) || (anticipates && !body->HasDrive());
      const Real speed =
          reaches ? FromODE(dBodyGetLinearVel(body->Body)).Length() + ComputeRimSpeed(*body) : 0.0;
      UpdateBounds(*body, kForesight * speed * substep);
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
  for (size_t i = 0; i < m_entries.size(); ++i) {
    const SEntry& first = m_entries[i];
    for (size_t j = i + 1; j < m_entries.size() && m_entries[j].Low <= first.High; ++j) {
      const SEntry& second = m_entries[j];
      if (second.OtherLow[0] <= first.OtherHigh[0] && first.OtherLow[0] <= second.OtherHigh[0] &&
          second.OtherLow[1] <= first.OtherHigh[1] && first.OtherLow[1] <= second.OtherHigh[1] &&
          (first.IsMovable || second.IsMovable)) {
        // always in the same order, also of bodies above each other, whose bounds are equal but for
        // rounding errors: their contacts are found by the pair
        const bool isInOrder = first.Number < second.Number;
        m_pairs.push_back(isInOrder ? SRigidPair{first.Body, second.Body}
                                    : SRigidPair{second.Body, first.Body});
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
      SEntry entry;
      entry.Body = body;
      entry.IsMovable = body->IsMovable();
      entry.Number = static_cast<UInt32>(m_entries.size());
      m_entries.push_back(entry);
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
    entry.OtherLow = {entry.Body->Low[1 - m_axis], entry.Body->Low.GetZ()};
    entry.OtherHigh = {entry.Body->High[1 - m_axis], entry.Body->High.GetZ()};
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
