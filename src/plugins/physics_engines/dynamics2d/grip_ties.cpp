#include <argos3/plugins/simulator/physics_engines/dynamics2d/grip_ties.h>

#include <argos3/plugins/simulator/physics_engines/dynamics2d/drive_motion.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace argos {

namespace {

// shares: of its greatest impulse, with which a drive slips (one that wins by more than kBalance
// does not); of the sum of impulses, the rest in a balance, and what may be across the line of the
// pull
constexpr Real kSlips = 0.999;
constexpr Real kBalance = 1e-3;
constexpr Real kAcross = 1e-2;

constexpr UInt32 kNone = std::numeric_limits<UInt32>::max();

}  // namespace

void CGripTies::Reserve(size_t robots) {
  m_slots.reserve(robots);
  m_parents.reserve(robots);
  m_isLoaded.reserve(robots);
  m_members.reserve(robots);
}

// @return kNone if the robot is in no grip with another one.
UInt32 CGripTies::NumberOf(UInt32 slot) const {
  const auto found = std::lower_bound(m_slots.begin(), m_slots.end(), slot);
  return found != m_slots.end() && *found == slot ? static_cast<UInt32>(found - m_slots.begin())
                                                  : kNone;
}

// A group is what grips connect; its root is the robot with the lowest slot.
void CGripTies::FindGroups(const CPlanarGrips& grips) {
  const auto forPairs = [&](auto&& visit) {
    grips.ForEachHold([&](const SManipulator& each) {
      if (each.Held.Handle->Kind == EPlanarKind::Driven) {
        visit(each.Owner.Handle->Slot, each.Held.Handle->Slot);
      }
    });
  };
  m_slots.clear();
  forPairs([this](UInt32 holder, UInt32 held) {
    m_slots.push_back(holder);
    m_slots.push_back(held);
  });
  std::sort(m_slots.begin(), m_slots.end());
  m_slots.erase(std::unique(m_slots.begin(), m_slots.end()), m_slots.end());
  ResetForest(m_parents, m_slots.size());
  forPairs(
      [this](UInt32 holder, UInt32 held) { Connect(m_parents, NumberOf(holder), NumberOf(held)); });
  m_members.resize(m_slots.size());
  for (UInt32 number = 0; number < m_slots.size(); ++number) {
    m_members[number] = number;
    m_parents[number] = FindRootOf(m_parents, number);
  }
  std::sort(m_members.begin(), m_members.end(), [this](UInt32 a, UInt32 b) {
    return m_parents[a] != m_parents[b] ? m_parents[a] < m_parents[b] : a < b;
  });
}

// Groups that hold objects, or that something else pressed.
void CGripTies::FindLoaded(const CPlanarGrips& grips, const std::vector<SGripTouch>& touches) {
  m_isLoaded.assign(m_slots.size(), 0);
  grips.ForEachHold([this](const SManipulator& each) {
    const UInt32 holder = NumberOf(each.Owner.Handle->Slot);
    if (holder != kNone && each.Held.Handle->Kind != EPlanarKind::Driven) {
      m_isLoaded[m_parents[holder]] = 1;
    }
  });
  for (const SGripTouch& touch : touches) {
    const UInt32 robot = NumberOf(touch.Slot);
    const UInt32 other = NumberOf(touch.Other);
    if (robot != kNone && (other == kNone || m_parents[other] != m_parents[robot])) {
      m_isLoaded[m_parents[robot]] = 1;
    }
  }
}

void CGripTies::Settle(CPlanarStore& store, const CPlanarGrips& grips,
                       const std::vector<SGripTouch>& touches) {
  FindGroups(grips);
  FindLoaded(grips, touches);
  for (size_t begin = 0, end = 0; begin < m_members.size(); begin = end) {
    const UInt32 root = m_parents[m_members[begin]];
    while (end < m_members.size() && m_parents[m_members[end]] == root) {
      ++end;
    }
    if (m_isLoaded[root] == 0) {
      const SPlanarVector change = ComputeChange(store, begin, end);
      for (size_t i = begin; i < end; ++i) {
        SPlanarVelocity& velocity = store.GetDriven(m_slots[m_members[i]]).Velocity;
        velocity.X += change.X;
        velocity.Y += change.Y;
      }
    }
  }
}

// @return zero if the group is not balanced. Along the line of the pull its speed may be anything
// between what those want that pull back, and what those want that pull on.
SPlanarVector CGripTies::ComputeChange(const CPlanarStore& store, size_t begin, size_t end) const {
  const auto bodyOf = [&](size_t i) -> const SDrivenBody& {
    return store.GetDriven()[m_slots[m_members[i]]];
  };
  const Real first = std::hypot(bodyOf(begin).PullX, bodyOf(begin).PullY);
  if (!(first > kSlips)) {
    return {0.0, 0.0};
  }
  const SPlanarVector axis = {bodyOf(begin).PullX / first, bodyOf(begin).PullY / first};
  SPlanarVector rest = {0.0, 0.0};
  Real sum = 0.0;
  Real mass = 0.0;
  Real momentum = 0.0;
  Real wantedMomentum = 0.0;
  Real slowest = -HUGE_VAL;
  Real fastest = HUGE_VAL;
  for (size_t i = begin; i < end; ++i) {
    const SDrivenBody& body = bodyOf(i);
    const SDrivenKind& kind = *body.Kind;
    const SPlanarVector pull = {body.PullX, body.PullY};
    const Real share = std::hypot(pull.X, pull.Y);
    if (!(share > kSlips) || std::abs(Cross(axis, pull)) > kAcross * share) {
      return {0.0, 0.0};
    }
    const SPlanarVelocity target = ComputeTarget(body, store.GetSettings());
    const Real wanted = Dot(axis, {target.X, target.Y});
    if (Dot(axis, pull) > 0.0) {
      fastest = std::min(fastest, wanted);
    } else {
      slowest = std::max(slowest, wanted);
    }
    const Real most = kind.Mass * kind.MaxSpeedChange;
    rest.X += most * body.PullX;
    rest.Y += most * body.PullY;
    sum += most * share;
    mass += kind.Mass;
    momentum += kind.Mass * Dot(axis, {body.Velocity.X, body.Velocity.Y});
    wantedMomentum += kind.Mass * wanted;
  }
  if (std::hypot(rest.X, rest.Y) > kBalance * sum || slowest > fastest) {
    return {0.0, 0.0};
  }
  const Real change = std::clamp(wantedMomentum / mass, slowest, fastest) - momentum / mass;
  return {change * axis.X, change * axis.Y};
}

}  // namespace argos
