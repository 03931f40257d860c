// The contacts that the solver gets, and how they are corrected where bodies turn.

#include <argos3/plugins/simulator/physics_engines/kinematics2d/kinematic_limits.h>
#include <argos3/plugins/simulator/physics_engines/kinematics2d/solids.h>

#include <algorithm>
#include <cmath>

namespace argos {

namespace {

// greatest one of the path of a pushed point, in half narrowest sides
constexpr Real kTurnError = 2e-3;
// greatest one of a lever of what turns, in half narrowest sides
constexpr Real kLeverError = 2e-2;
// over which changes of levers are measured, rad
constexpr Real kMinTurn = 1e-3;
// of which contacts are linear enough to be corrected from there, rad
constexpr Real kLongestTurn = 0.4;

// How a lever changes while a body turns, m/rad. @param find  the lever for another motion.
template <typename FIND>
Real ComputeBend(const STwist& twist, Real lever, FIND&& find) {
  const Real change = std::copysign(std::max(std::abs(twist.Turn), kMinTurn), twist.Turn);
  return (lever - find(STwist{twist.X, twist.Y, twist.Turn - change})) / change;
}

// the point of a contact in the frame of a footprint, m
SPlanarVector FindInFrame(const SFootprint& place, const SSeparation& contact) {
  return RotateIntoFrame(place, contact.PointX - place.X, contact.PointY - place.Y);
}

// How far the points of a body leave their chords on the way, m: twice the sagitta, because others
// turn, too. Less than a step, so that none passes another.
Real ComputeArcDepth(const SSolid& solid, const STwist& twist) {
  return std::min(0.25 * twist.Turn * twist.Turn * solid.BoundingRadius,
                  kSolidStep * solid.NarrowestHalf);
}

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

void CSolids::AddLink(const CPushSolver::SContact& contact, const SSeparation& found,
                      const SSide& pushing, const SSide& pushed) {
  // a robot that pushes gives way by itself
  const bool isPush = contact.Pushing != CPushSolver::kNone && pushing.Footprint == kNone;
  const Real tolerance = (isPush ? kTurnError : 0.25 * kSolidTolerance) *
                         m_solids[m_slotOf[pushed.Footprint]].NarrowestHalf;
  const SFootprint place = Displace(m_footprints[pushed.Footprint], pushed.Image.X, pushed.Image.Y);
  m_links.push_back({m_solver.AddContact(contact), FindInFrame(place, found), pushing, pushed,
                     std::min(0.0, found.Gap + contact.Least), tolerance});
}

// The solver takes rotations as linear. Where that is wrong, contacts get the gap at the end of the
// motion that it has found, the normal half-way, and the levers of the end: sequential quadratic
// programming. A lever half-way would let a body turn on beyond where its friction holds it.
void CSolids::Solve() {
  m_solver.Solve([this](UInt32 contact) {
    const auto link =
        std::lower_bound(m_links.begin(), m_links.end(), contact,
                         [](const SLink& a, UInt32 number) { return a.Contact < number; });
    return link != m_links.end() && link->Contact == contact && Correct(*link);
  });
}

// @return true if the solver has to go on.
bool CSolids::Correct(SLink& link) {
  const STwist pushing = ComputeTwist(link.Pushing);
  const STwist pushed = ComputeTwist(link.Pushed);
  // bodies that do not turn move as the contact says, or, if they are round, farther apart
  if (pushing.Turn == 0.0 && pushed.Turn == 0.0 && !link.IsCorrected) {
    return false;
  }
  CPushSolver::SContact contact = m_solver.GetContact(link.Contact);
  const auto computeMotion = [&] {
    return Dot(contact.Normal, pushed.GetStep() - pushing.GetStep()) +
           contact.LeverPushed * pushed.Turn - contact.LeverPushing * pushing.Turn;
  };
  const Real expected = link.Planned + computeMotion() - contact.Least;
  const Real force = m_solver.GetForce(link.Contact);
  if (force == 0.0 && !link.IsCorrected &&
      expected > link.Planned + ComputeTurnError(link, pushing, pushed)) {
    return false;
  }
  const SSeparation end = FindAt(link, pushing, pushed, 1.0);
  const Real leverPushing = ComputeLeverAtEnd(link.Pushing, pushing, end);
  const Real leverPushed = ComputeLeverAtEnd(link.Pushed, pushed, end);
  const bool isGapOff = std::abs(end.Gap - expected) > link.Tolerance &&
                        std::min(end.Gap, expected) <= link.Planned + link.Tolerance;
  const Real tolerance = kLeverError * m_solids[m_slotOf[link.Pushed.Footprint]].NarrowestHalf;
  const bool isLeverOff =
      force > 0.0 && (std::abs(leverPushing - contact.LeverPushing) > tolerance ||
                      std::abs(leverPushed - contact.LeverPushed) > tolerance);
  if (!isGapOff && !isLeverOff && !link.IsCorrected) {
    return false;
  }
  link.IsCorrected = true;
  const SSeparation middle = FindAt(link, pushing, pushed, 0.5);
  contact.Normal = middle.GetNormal();
  const auto findPushed = [&](const STwist& twist) {
    return ComputeLeverAtEnd(link.Pushed, twist, FindAt(link, pushing, twist, 1.0));
  };
  const auto findPushing = [&](const STwist& twist) {
    return ComputeLeverAtEnd(link.Pushing, twist, FindAt(link, twist, pushed, 1.0));
  };
  const bool isTurned = link.Pushing.Footprint != kNone && force > 0.0;
  contact.BendPushing = isTurned ? ComputeBend(pushing, leverPushing, findPushing) : 0.0;
  contact.BendPushed = force > 0.0 ? ComputeBend(pushed, leverPushed, findPushed) : 0.0;
  contact.LeverPushing = leverPushing;
  contact.LeverPushed = leverPushed;
  contact.Least = link.Planned - end.Gap + computeMotion();
  m_solver.SetContact(link.Contact, contact);
  return true;
}

// The contact of two sides after a share of their motions: of two, the one at the same corner. As a
// body turns, another one of its sides may face the other body, with one corner in common.
SSeparation CSolids::FindAt(const SLink& link, const STwist& pushing, const STwist& pushed,
                            Real share) const {
  const SFootprint place = ComputePlace(link.Pushed, pushed, share);
  SSeparation contacts[2];
  const int count = FindContacts(ComputePlace(link.Pushing, pushing, share), place, contacts);
  if (count == 1) {
    return contacts[0];
  }
  const auto computeChange = [&](const SSeparation& contact) {
    return SquareLength(FindInFrame(place, contact) - link.Point);
  };
  return contacts[computeChange(contacts[0]) <= computeChange(contacts[1]) ? 0 : 1];
}

// The solver knows the end of a motion. On the way, the corners of what turns leave their chords,
// for example into the wall along which they slide.
// @return true if the bodies overlap nothing, or, on the way, by no more than that.
bool CSolids::AreFree(std::span<const SMember> members, bool isOnWay, const CDiscSwarm& discs) {
  return std::all_of(members.begin(), members.end(), [&](const SMember& member) {
    const SSolid& solid = m_solids[member.Slot];
    GatherObstacles(solid, 0.0, discs);
    return IsFree(solid, solid.Pose, isOnWay ? ComputeArcDepth(solid, solid.Twist) : 0.0, false);
  });
}

// By how much a gap may be less than the contact says, at most, m.
Real CSolids::ComputeTurnError(const SLink& link, const STwist& pushing,
                               const STwist& pushed) const {
  const auto computePath = [this](const SSide& side, const STwist& twist) {
    return side.Footprint != kNone ? ComputeLength(m_solids[m_slotOf[side.Footprint]], twist)
                                   : std::hypot(twist.X, twist.Y);
  };
  return (computePath(link.Pushing, pushing) + computePath(link.Pushed, pushed)) *
         (std::abs(pushing.Turn) + std::abs(pushed.Turn));
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
  const STwist& found = m_solver.GetTwist(solid.Number);
  const Real negligible = kNegligibleStep * solid.NarrowestHalf;
  // what friction holds stays to the bit; most bodies of a pile that is held are far below that
  if (std::abs(found.X) + std::abs(found.Y) + std::abs(found.Turn) * solid.BoundingRadius <=
      0.5 * negligible) {
    return STwist();
  }
  STwist twist = Shortened(solid, found, ComputeFarthest(solid));
  twist.Turn = std::clamp(twist.Turn, -kLongestTurn, kLongestTurn);
  // a round body that is pushed in its middle does not turn, whatever the rounding of its lever
  if (std::abs(twist.Turn) * solid.BoundingRadius <= negligible) {
    twist.Turn = 0.0;
  }
  return ComputeLength(solid, twist) > negligible ? twist : STwist();
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
  return Displace(Transform(m_shapes[side.Footprint], Moved(solid.Pose, twist, share)),
                  side.Image.X, side.Image.Y);
}

// @param contact  at the end of the motion.
Real CSolids::ComputeLeverAtEnd(const SSide& side, const STwist& twist,
                                const SSeparation& contact) const {
  if (side.Footprint == kNone) {
    return 0.0;
  }
  const SPlanarPose& start = m_solids[m_slotOf[side.Footprint]].Pose;
  return (contact.PointX - start.X - side.Image.X - twist.X) * contact.NormalY -
         (contact.PointY - start.Y - side.Image.Y - twist.Y) * contact.NormalX;
}

}  // namespace argos
