// The contacts that the solver gets, and how they are corrected where bodies turn.

#include <argos3/plugins/simulator/physics_engines/kinematics2d/kinematic_limits.h>
#include <argos3/plugins/simulator/physics_engines/kinematics2d/solids.h>

#include <algorithm>
#include <cmath>

namespace argos {

namespace {

// of the solution in a tick
constexpr int kCorrections = 2;
// greatest one of the path of a pushed point, in half narrowest sides
constexpr Real kTurnError = 2e-3;
// of which contacts are linear enough to be corrected from there, rad
constexpr Real kLongestTurn = 0.2;

}  // namespace

SPlanarPose Moved(const SPlanarPose& pose, const STwist& twist, Real share) {
  SPlanarPose moved = pose;
  moved.X += share * twist.X;
  moved.Y += share * twist.Y;
  if (twist.Turn != 0.0) {
    const Real half = 0.5 * share * twist.Turn;
    Turn(moved, std::cos(half), std::sin(half));
  }
  return moved;
}

SFootprint Transform(const SFootprint& footprint, const SPlanarPose& pose) {
  return PlaceFootprint(footprint, pose.X, pose.Y,
                        pose.HalfCos * pose.HalfCos - pose.HalfSin * pose.HalfSin,
                        2.0 * pose.HalfSin * pose.HalfCos);
}

void CSolids::AddLink(const CPushSolver::SContact& contact, int point, const SSide& pushing,
                      const SSide& pushed, Real gap) {
  // a robot that pushes gives way by itself
  const bool isPush = contact.Pushing != CPushSolver::kNone && pushing.Footprint == kNone;
  const Real tolerance = (isPush ? kTurnError : 0.25 * kSolidTolerance) *
                         m_solids[m_slotOf[pushed.Footprint]].NarrowestHalf;
  m_links.push_back({m_solver.AddContact(contact), point, pushing, pushed, gap,
                     std::min(0.0, gap + contact.Least), tolerance});
}

// The solver takes rotations as linear. Where that is wrong, contacts get the gap at the end of the
// motion that it has found, and the normal half-way: the rule of the midpoint, solved by sequential
// quadratic programming.
void CSolids::Solve() {
  m_solver.Solve();
  for (int i = 0; i < kCorrections; ++i) {
    bool isDue = false;
    for (SLink& link : m_links) {
      isDue |= Correct(link);
    }
    if (!isDue) {
      break;
    }
    m_solver.Solve();
  }
}

// @return true if the solver has to solve again.
bool CSolids::Correct(SLink& link) {
  CPushSolver::SContact contact = m_solver.GetContact(link.Contact);
  const STwist pushing = ComputeTwist(link.Pushing);
  const STwist pushed = ComputeTwist(link.Pushed);
  const auto computeMotion = [&] {
    return contact.NormalX * (pushed.X - pushing.X) + contact.NormalY * (pushed.Y - pushing.Y) +
           contact.LeverPushed * pushed.Turn - contact.LeverPushing * pushing.Turn;
  };
  // bodies that do not turn move as the contact says, or, if they are round, farther apart
  if (pushing.Turn == 0.0 && pushed.Turn == 0.0) {
    return false;
  }
  const Real expected = link.Planned + computeMotion() - contact.Least;
  const auto findAt = [&](Real share) {
    SSeparation contacts[2];
    const int count = FindContacts(ComputePlace(link.Pushing, pushing, share),
                                   ComputePlace(link.Pushed, pushed, share), contacts);
    return contacts[std::min(link.Point, count - 1)];
  };
  const Real gap = findAt(1.0).Gap;
  if (std::abs(gap - expected) <= link.Tolerance ||
      std::min(gap, expected) > link.Planned + link.Tolerance) {
    return false;
  }
  const SSeparation middle = findAt(0.5);
  contact.NormalX = middle.NormalX;
  contact.NormalY = middle.NormalY;
  contact.LeverPushing = ComputeLeverHalfway(link.Pushing, pushing, middle);
  contact.LeverPushed = ComputeLeverHalfway(link.Pushed, pushed, middle);
  contact.Least = link.Planned - gap + computeMotion();
  m_solver.SetContact(link.Contact, contact);
  return true;
}

STwist CSolids::ComputeTwist(const SSide& side) const {
  if (side.Footprint != kNone) {
    return ComputeTwist(m_solids[m_slotOf[side.Footprint]]);
  }
  return side.Disc != CPushSolver::kNone ? m_solver.GetTwist(side.Disc) : STwist();
}

// What the solver has found, if it is more than rounding errors, limited to the distance within
// which others search for the body.
STwist CSolids::ComputeTwist(const SSolid& solid) const {
  STwist twist = Shortened(solid, m_solver.GetTwist(solid.Number), ComputeFarthest(solid));
  twist.Turn = std::clamp(twist.Turn, -kLongestTurn, kLongestTurn);
  // what friction holds stays to the bit
  return ComputeLength(solid, twist) > kNegligibleStep * solid.NarrowestHalf ? twist : STwist();
}

// A side after a share of its motion.
SFootprint CSolids::ComputePlace(const SSide& side, const STwist& twist, Real share) const {
  if (side.Footprint == kNone) {
    SFootprint place = side.Place;
    place.X += share * twist.X;
    place.Y += share * twist.Y;
    return place;
  }
  const SSolid& solid = m_solids[m_slotOf[side.Footprint]];
  return Transform(m_shapes[side.Footprint], Moved(solid.Pose, twist, share));
}

Real CSolids::ComputeLeverHalfway(const SSide& side, const STwist& twist,
                                  const SSeparation& contact) const {
  if (side.Footprint == kNone) {
    return 0.0;
  }
  const SPlanarPose& start = m_solids[m_slotOf[side.Footprint]].Pose;
  return (contact.PointX - start.X - 0.5 * twist.X) * contact.NormalY -
         (contact.PointY - start.Y - 0.5 * twist.Y) * contact.NormalX;
}

}  // namespace argos
