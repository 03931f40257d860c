#include <argos3/plugins/simulator/physics_engines/dynamics2d/grip_ties.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace argos {

namespace {

// shares: of its greatest impulse, with which a drive slips (one that wins by more than kBalance
// does not); of the sum of impulses, the rest in a balance, and what may be across the line of the
// pull
constexpr float kSlips = 0.999F;
constexpr float kBalance = 1e-3F;
constexpr float kAcross = 1e-2F;

}  // namespace

void CGripTies::Reserve(size_t active) {
  m_parents.reserve(active);
  m_holdsObject.reserve(active);
  m_changes.reserve(active);
  m_members.reserve(active);
}

// A group is what grips connect; its root is the robot with the lowest number.
void CGripTies::FindGroups(CPlanarStore& store, const CActiveSet& active,
                           const CPlanarGrips& grips) {
  const size_t count = active.GetBodies().size();
  ResetForest(m_parents, count);
  m_holdsObject.assign(count, 0);
  m_changes.assign(count, b2Vec2_zero);
  grips.ForEachHold([&](const SManipulator& each) {
    const UInt32 holder = store.GetDriven(*each.Owner.Handle).ActiveNumber;
    if (each.Held.Handle->Kind != EPlanarKind::Driven) {
      m_holdsObject[holder] = 1;
      return;
    }
    Connect(m_parents, holder, store.GetDriven(*each.Held.Handle).ActiveNumber);
  });
  m_members.clear();
  for (UInt32 number = 0; number < count; ++number) {
    if (active.GetRobot(active.GetBodies()[number]).NumGrips > 0) {
      m_members.push_back(number);
      m_parents[number] = FindRootOf(m_parents, number);
    }
  }
  std::sort(m_members.begin(), m_members.end(), [this](UInt32 a, UInt32 b) {
    return m_parents[a] != m_parents[b] ? m_parents[a] < m_parents[b] : a < b;
  });
}

void CGripTies::Settle(CPlanarStore& store, const CActiveSet& active, const CPlanarGrips& grips) {
  FindGroups(store, active, grips);
  for (size_t begin = 0, end = 0; begin < m_members.size(); begin = end) {
    const UInt32 root = m_parents[m_members[begin]];
    while (end < m_members.size() && m_parents[m_members[end]] == root) {
      ++end;
    }
    if (end - begin > 1 && !TouchesOthers(active, begin, end)) {
      m_changes[root] = ComputeChange(store, active, begin, end);
    }
  }
  const auto change = [this](b2Body& body, UInt32 number) {
    const b2Vec2& by = m_changes[m_parents[number]];
    if (by != b2Vec2_zero) {
      body.SetLinearVelocity(body.GetLinearVelocity() + by);
    }
  };
  for (const UInt32 number : m_members) {
    change(*active.GetBodies()[number].Body, number);
  }
  grips.ForEachHold([&](const SManipulator& each) {
    if (each.TurretBody != nullptr) {
      change(*each.TurretBody, store.GetDriven(*each.Owner.Handle).ActiveNumber);
    }
  });
}

bool CGripTies::TouchesOthers(const CActiveSet& active, size_t begin, size_t end) const {
  const auto isMember = [&](const b2Body* body) {
    return std::any_of(m_members.begin() + static_cast<std::ptrdiff_t>(begin),
                       m_members.begin() + static_cast<std::ptrdiff_t>(end),
                       [&](UInt32 number) { return active.GetBodies()[number].Body == body; });
  };
  for (size_t i = begin; i < end; ++i) {
    if (m_holdsObject[m_members[i]] != 0) {
      return true;
    }
    const b2Body& body = *active.GetBodies()[m_members[i]].Body;
    for (const b2ContactEdge* edge = body.GetContactList(); edge != nullptr; edge = edge->next) {
      if (edge->contact->IsTouching() && !isMember(edge->other)) {
        return true;
      }
    }
  }
  return false;
}

// @return zero if the group is not balanced. Along the line of the pull its speed may be anything
// between what those want that pull back, and what those want that pull on.
b2Vec2 CGripTies::ComputeChange(const CPlanarStore& store, const CActiveSet& active, size_t begin,
                                size_t end) const {
  const float perTick = static_cast<float>(1.0 / store.GetSettings().Tick);
  b2Vec2 axis = active.GetBodies()[m_members[begin]].Pull;
  axis.Normalize();
  b2Vec2 rest = b2Vec2_zero;
  float sum = 0.0F;
  float mass = 0.0F;
  float momentum = 0.0F;
  float wantedMomentum = 0.0F;
  float slowest = -HUGE_VALF;
  float fastest = HUGE_VALF;
  for (size_t i = begin; i < end; ++i) {
    const SActiveBody& each = active.GetBodies()[m_members[i]];
    const SDrivenKind& kind = *active.GetRobot(each).Kind;
    const float most = static_cast<float>(kind.Mass) * store.ToUnits(kind.MaxSpeedChange);
    const float pull = each.Pull.Length();
    if (!(pull > kSlips * most) || std::abs(b2Cross(axis, each.Pull)) > kAcross * pull) {
      return b2Vec2_zero;
    }
    const float wanted = perTick * b2Dot(axis, b2Vec2(each.StepX, each.StepY));
    if (b2Dot(axis, each.Pull) > 0.0F) {
      fastest = std::min(fastest, wanted);
    } else {
      slowest = std::max(slowest, wanted);
    }
    rest += each.Pull;
    sum += pull;
    mass += static_cast<float>(kind.Mass);
    momentum += static_cast<float>(kind.Mass) * b2Dot(axis, each.Body->GetLinearVelocity());
    wantedMomentum += static_cast<float>(kind.Mass) * wanted;
  }
  if (rest.Length() > kBalance * sum || slowest > fastest) {
    return b2Vec2_zero;
  }
  return (std::clamp(wantedMomentum / mass, slowest, fastest) - momentum / mass) * axis;
}

}  // namespace argos
