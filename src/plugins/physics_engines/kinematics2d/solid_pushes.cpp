// The robots that drive against objects: their pushes, and how others push them back.

#include <argos3/plugins/simulator/physics_engines/kinematics2d/disc_swarm.h>
#include <argos3/plugins/simulator/physics_engines/kinematics2d/kinematic_limits.h>
#include <argos3/plugins/simulator/physics_engines/kinematics2d/solids.h>

#include <algorithm>
#include <cmath>

namespace argos {

namespace {

// A robot is pushed back if it moves by more than this share of its planned step against it.
constexpr Real kPushedBack = 1e-6;
// of the key of a disc in the solver; that of a solid is its slot
constexpr UInt32 kDiscKey = 1U << 31;

}  // namespace

void CSolids::AddPushesOfDiscs(UInt32 slot, const CDiscSwarm& discs) {
  const SSolid& solid = m_solids[slot];
  m_nearDiscs.clear();
  discs.ForDiscsNear(solid.Pose.X, solid.Pose.Y, solid.BoundingRadius,
                     [this](UInt32 disc) { m_nearDiscs.push_back(disc); });
  std::sort(m_nearDiscs.begin(), m_nearDiscs.end());
  for (const UInt32 disc : m_nearDiscs) {
    const SPlanarPose pose = discs.GetPoseNear(disc, solid.Pose.X, solid.Pose.Y);
    const SPlanarVector step = discs.GetPlannedStep(disc);
    for (size_t pushed = solid.FirstFootprint; pushed < solid.FirstFootprint + solid.NumFootprints;
         ++pushed) {
      const SSeparation contact =
          SeparateFromFootprint(pose.X, pose.Y, discs.GetRadius(disc), step, m_footprints[pushed]);
      const Real planned = Dot(contact.GetNormal(), step);
      if (planned > 0.0 && planned - contact.Gap > kNegligibleStep * solid.NarrowestHalf) {
        const UInt32 number = AddDiscToSolver(disc, discs);
        const SSide side = {.Disc = number,
                            .Place = {pose.X, pose.Y, 1.0, 0.0, 0.0, 0.0, discs.GetRadius(disc)}};
        AddPush(slot, contact, planned - contact.Gap, number, 0.0, side,
                static_cast<UInt32>(pushed));
        m_pushes.push_back({slot, disc});
      }
    }
  }
}

void CSolids::AddPushesOfSolids(UInt32 slot) {
  const SSolid& solid = m_solids[slot];
  for (UInt32 number = 0; number < m_solids.size() && m_numDriven > 0; ++number) {
    const SSolid& robot = m_solids[number];
    const Real reach = ComputeLength(robot, robot.Twist);
    const Real dx = m_period.X.Shorten(robot.Pose.X - solid.Pose.X);
    const Real dy = m_period.Y.Shorten(robot.Pose.Y - solid.Pose.Y);
    if (robot.IsPassive() ||
        std::hypot(dx, dy) > robot.BoundingRadius + solid.BoundingRadius + reach) {
      continue;
    }
    AddPushesOfSolid(slot, number);
  }
}

// @param number  slot of the robot.
void CSolids::AddPushesOfSolid(UInt32 slot, UInt32 number) {
  const SSolid& solid = m_solids[slot];
  const SSolid& robot = m_solids[number];
  const SPlanarVector image = FindImage(robot.Pose.X, robot.Pose.Y, solid);
  for (size_t pushing = robot.FirstFootprint; pushing < robot.FirstFootprint + robot.NumFootprints;
       ++pushing) {
    for (size_t pushed = solid.FirstFootprint; pushed < solid.FirstFootprint + solid.NumFootprints;
         ++pushed) {
      SSeparation contacts[2];
      const int count = FindContacts(Displace(m_footprints[pushing], image.X, image.Y),
                                     m_footprints[pushed], contacts);
      for (int i = 0; i < count; ++i) {
        const Real lever = ComputeLever(robot, contacts[i], image);
        const Real planned =
            Dot(contacts[i].GetNormal(), robot.Twist.GetStep()) + lever * robot.Twist.Turn;
        if (planned > 0.0 && planned - contacts[i].Gap > kNegligibleStep * solid.NarrowestHalf) {
          AddPush(slot, contacts[i], planned - contacts[i].Gap, AddRobotToSolver(number), lever,
                  {.Footprint = static_cast<UInt32>(pushing), .Image = image},
                  static_cast<UInt32>(pushed));
          m_pushes.push_back({slot, kSolidRobot | number});
        }
      }
    }
  }
}

// @param need  by which the robot would enter the body, m. @param robot  its number in the solver.
// @param lever  of the contact about the robot's origin, m.
void CSolids::AddPush(UInt32 slot, const SSeparation& contact, Real need, UInt32 robot, Real lever,
                      const SSide& pushing, UInt32 pushed) {
  m_farthest = std::max(m_farthest, need);
  AddLink({robot, AddToSolver(slot), contact.GetNormal(), lever,
           ComputeLever(m_solids[slot], contact), -contact.Gap},
          contact, pushing, {.Footprint = pushed});
}

bool CSolids::IsPush(UInt32 slot, UInt32 robot) const {
  return std::binary_search(m_pushes.begin(), m_pushes.end(), SPush{slot, robot});
}

// Adds an object to the solver, if it is not in it. @return its number there.
UInt32 CSolids::AddToSolver(UInt32 slot) {
  SSolid& solid = m_solids[slot];
  if (solid.Number == CPushSolver::kNone) {
    solid.Number = m_solver.AddBody(STwist(), solid.Friction.Force, solid.Friction.Torque,
                                    solid.SquaredGyration, slot);
    m_pushed.push_back(slot);
  }
  return solid.Number;
}

// The same for a robot that is a disc. Contacts have no friction, so nothing turns it.
UInt32 CSolids::AddDiscToSolver(UInt32 disc, const CDiscSwarm& discs) {
  m_numberOfDisc.resize(discs.GetSize(), CPushSolver::kNone);
  UInt32& number = m_numberOfDisc[disc];
  if (number == CPushSolver::kNone) {
    const SPlanarVector step = discs.GetPlannedStep(disc);
    const Real radius = discs.GetRadius(disc);
    number = m_solver.AddBody({step.X, step.Y, 0.0}, discs.GetMaxForce(disc),
                              CPushSolver::kUnlimited, radius * radius, kDiscKey | disc);
    m_pushers.push_back({disc, true, number, STwist()});
  }
  return number;
}

// The same for a robot that is not a disc. It turns as its wheels do.
UInt32 CSolids::AddRobotToSolver(UInt32 slot) {
  SSolid& robot = m_solids[slot];
  if (robot.Number == CPushSolver::kNone) {
    robot.Number = m_solver.AddBody(robot.Twist, robot.MaxForce, CPushSolver::kUnlimited,
                                    robot.SquaredGyration, slot);
    m_pushers.push_back({slot, false, robot.Number, STwist()});
  }
  return robot.Number;
}

// After the solver: the steps of the bodies in it.
void CSolids::TakeTwists(const CDiscSwarm& discs) {
  m_members.clear();
  for (const UInt32 slot : m_pushed) {
    m_members.push_back({m_solver.GetIsland(m_solids[slot].Number), slot, m_solids[slot].Pose});
    // limited to the distance within which others search for it
    SSolid& solid = m_solids[slot];
    solid.Twist = ComputeTwist(solid);
    solid.Number = CPushSolver::kNone;
    // the rest of a deep overlap is corrected in the next ticks
    solid.IsFresh =
        solid.IsFresh && ComputeLength(solid, solid.Twist) > kSolidTolerance * solid.NarrowestHalf;
  }
  for (SPusher& pusher : m_pushers) {
    const STwist& twist = m_solver.GetTwist(pusher.Number);
    SPlanarVector planned = {};
    STwist back = twist;
    if (pusher.IsDisc) {
      planned = discs.GetPlannedStep(pusher.Slot);
      m_numberOfDisc[pusher.Slot] = CPushSolver::kNone;
    } else {
      SSolid& robot = m_solids[pusher.Slot];
      planned = robot.Twist.GetStep();
      back = Shortened(robot, twist, ComputeFarthest(robot));
      robot.Number = CPushSolver::kNone;
    }
    if (Dot(twist.GetStep(), planned) < -kPushedBack * SquareLength(planned)) {
      pusher.Back = back;
    }
  }
}

// Moves a robot that others push back, as far as there is space; then it has made its step. Robots
// that do not move, or are near one of another engine, are not pushed back. @return the share that
// it has moved.
Real CSolids::PushBack(const SPusher& pusher, CDiscSwarm& discs) {
  const Real length = std::hypot(pusher.Back.X, pusher.Back.Y);
  if (length == 0.0) {
    return 1.0;
  }
  if (!pusher.IsDisc) {
    SSolid& robot = m_solids[pusher.Slot];
    robot.Twist = STwist();
    robot.HasMoved = true;
    return Move(robot, pusher.Back, discs);
  }
  const Real most = std::min(1.0, discs.GetRoomBack(pusher.Slot) / length);
  const SPlanarVector step = most * pusher.Back.GetStep();
  const Real share = ComputeFreeShare(pusher.Slot, step, discs);
  discs.PushBack(pusher.Slot, share * step);
  return most * share;
}

// The share of a step that a disc can make without touching anything.
Real CSolids::ComputeFreeShare(UInt32 disc, const SPlanarVector& step, const CDiscSwarm& discs) {
  const SPlanarPose pose = discs.GetPose(disc);
  const Real radius = discs.GetRadius(disc);
  const Real reach = radius + std::hypot(step.X, step.Y);
  Real share = 1.0;
  const auto limit = [&](const SSeparation& separation) {
    const Real approach = Dot(separation.GetNormal(), step);
    if (approach > separation.Gap && approach > 0.0) {
      share = std::min(share, std::max(0.0, separation.Gap) / approach);
    }
  };
  m_wallCells.Find(m_grid, pose.X, pose.Y, reach, m_found);
  for (const UInt32 wall : m_found) {
    limit(SeparateFromFootprint(pose.X, pose.Y, radius, step, m_wallCells.GetFootprint(wall)));
  }
  FindSolidsNear(pose.X, pose.Y, reach);
  for (const UInt32 footprint : m_found) {
    const SPlanarPose& other = m_solids[m_slotOf[footprint]].Pose;
    const SPlanarVector image = FindNearestImage(m_period, other.X, other.Y, pose.X, pose.Y);
    limit(SeparateFromFootprint(pose.X, pose.Y, radius, step,
                                Displace(m_solidCells.GetFootprint(footprint), image.X, image.Y)));
  }
  discs.ForDiscsNear(pose.X, pose.Y, reach, [&](UInt32 other) {
    if (other != disc) {
      const SPlanarPose there = discs.GetPoseNear(other, pose.X, pose.Y);
      limit(SeparateDiscs({there.X - pose.X, there.Y - pose.Y}, {-step.X, -step.Y},
                          radius + discs.GetRadius(other)));
    }
  });
  return share;
}

}  // namespace argos
