#include <argos3/plugins/simulator/physics_engines/kinematics2d/solids.h>

#include <argos3/core/simulator/geometry/body_description.h>
#include <argos3/plugins/simulator/physics_engines/kinematics2d/disc_swarm.h>
#include <argos3/plugins/simulator/physics_engines/kinematics2d/kinematic_limits.h>

#include <algorithm>
#include <cmath>

namespace argos {

namespace {

// greatest number of passes over the pushed bodies, because one may block another
constexpr int kPasses = 16;
// how often a step that is too long is halved
constexpr int kHalvings = 8;

SFootprint MakeDisc(const SPlanarPose& pose, Real radius) {
  return {pose.X, pose.Y, 1.0, 0.0, 0.0, 0.0, radius};
}

// radius of the circle around the origin of a body that contains a footprint in its frame, m
Real ComputeReach(const SFootprint& footprint) {
  if (footprint.Polygon == nullptr) {
    return std::hypot(footprint.X, footprint.Y) + ComputeExtent(footprint);
  }
  Real reach = 0.0;
  for (const CVector2& corner : *footprint.Polygon) {
    const SPlanarVector place = RotateOutOfFrame(footprint, corner.GetX(), corner.GetY());
    reach = std::max(reach, std::hypot(footprint.X + place.X, footprint.Y + place.Y));
  }
  return reach;
}

bool IsNear(const SSolid& solid, const SFootprint& footprint, Real margin) {
  const Real reach = solid.BoundingRadius + ComputeExtent(footprint) + margin;
  const Real dx = footprint.X - solid.Pose.X;
  const Real dy = footprint.Y - solid.Pose.Y;
  return dx * dx + dy * dy <= reach * reach;
}

// The motion that a contact requires of two bodies, m: at most @p most of an overlap. Gaps and
// overlaps within half of the tolerance count as 0: to open or close them would take many sweeps.
Real ComputeLeast(Real gap, Real narrowestHalf, Real most) {
  return std::abs(gap) <= 0.5 * kSolidTolerance * narrowestHalf ? 0.0 : std::min(-gap, most);
}

}  // namespace

Real ComputeLever(const SSolid& solid, const SSeparation& contact, const SPlanarVector& image) {
  return (contact.PointX - solid.Pose.X - image.X) * contact.NormalY -
         (contact.PointY - solid.Pose.Y - image.Y) * contact.NormalX;
}

Real ComputeLength(const SSolid& solid, const STwist& twist) {
  return std::hypot(twist.X, twist.Y) + std::abs(twist.Turn) * solid.BoundingRadius;
}

STwist Shortened(const SSolid& solid, const STwist& twist, Real longest) {
  const Real length = ComputeLength(solid, twist);
  if (length <= longest) {
    return twist;
  }
  const Real scale = longest / length;
  return {scale * twist.X, scale * twist.Y, scale * twist.Turn};
}

void CSolids::Reserve(size_t solids) {
  m_solids.reserve(solids);
  m_generations.Reserve(solids);
  m_shapes.reserve(2 * solids);
  m_footprints.reserve(2 * solids);
  m_slotOf.reserve(2 * solids);
  m_found.reserve(256);
  m_pushed.reserve(solids);
  m_nearDiscs.reserve(256);
  m_pushers.reserve(256);
  m_links.reserve(256);
  m_members.reserve(solids);
  m_pushes.reserve(256);
  m_obstacles.reserve(256);
  m_ghosts.reserve(256);
}

void CSolids::Add(const SKinematicOwner& owner, const SBodyDescription& description,
                  const SPlanarPose& pose, const CDriveSource& drive,
                  const SGroundFriction& friction) {
  *owner.Handle = {EKinematicKind::Solid, static_cast<UInt32>(m_solids.size()),
                   m_generations.Add()};
  SSolid& solid = m_solids.emplace_back();
  solid.Owner = owner;
  solid.FirstFootprint = m_shapes.size();
  AppendFootprints(description, SPlanarPose(), m_shapes);
  solid.NumFootprints = m_shapes.size() - solid.FirstFootprint;
  m_footprints.resize(m_shapes.size());
  m_slotOf.resize(m_shapes.size(), owner.Handle->Slot);
  for (size_t i = solid.FirstFootprint; i < m_shapes.size(); ++i) {
    solid.BoundingRadius = std::max(solid.BoundingRadius, ComputeReach(m_shapes[i]));
  }
  solid.NarrowestHalf = ComputeNarrowestHalf(description);
  solid.SquaredGyration = description.GetPlanarInertia() / description.Mass;
  solid.Friction = friction;
  if (drive) {
    solid.Drive = drive;
    solid.MaxForce = description.GetDriveLimits().MaxForce;
    ++m_numDriven;
  }
  Place(solid, pose);
}

void CSolids::Remove(const SKinematicHandle& handle) {
  m_generations.Check(handle);
  const UInt32 slot = handle.Slot;
  const SSolid gone = m_solids[slot];
  *gone.Owner.Handle = SKinematicHandle();
  m_numDriven -= gone.IsPassive() ? 0 : 1;
  const UInt32 generation = m_generations.Remove(slot);
  if (slot + 1 != m_solids.size()) {
    m_solids[slot] = m_solids.back();
    m_solids[slot].Owner.Handle->Slot = slot;
    m_solids[slot].Owner.Handle->Generation = generation;
  }
  m_solids.pop_back();
  // the lists of footprints are dense
  for (auto* list : {&m_shapes, &m_footprints}) {
    const auto first = list->begin() + static_cast<std::ptrdiff_t>(gone.FirstFootprint);
    list->erase(first, first + static_cast<std::ptrdiff_t>(gone.NumFootprints));
  }
  m_slotOf.resize(m_shapes.size());
  for (UInt32 i = 0; i < m_solids.size(); ++i) {
    SSolid& solid = m_solids[i];
    if (solid.FirstFootprint > gone.FirstFootprint) {
      solid.FirstFootprint -= gone.NumFootprints;
    }
    std::fill_n(m_slotOf.begin() + static_cast<std::ptrdiff_t>(solid.FirstFootprint),
                solid.NumFootprints, i);
  }
  ++m_generation;
}

void CSolids::SetPose(const SKinematicHandle& handle, const SPlanarPose& pose) {
  SSolid& solid = Get(handle);
  solid.IsFresh = true;
  Place(solid, pose);
}

void CSolids::Place(SSolid& solid, const SPlanarPose& pose) {
  solid.Pose = pose;
  for (size_t i = 0; i < solid.NumFootprints; ++i) {
    m_footprints[solid.FirstFootprint + i] = Transform(m_shapes[solid.FirstFootprint + i], pose);
  }
  ++m_generation;
}

void CSolids::Plan(const SSubstep& substep) {
  for (SSolid& solid : m_solids) {
    solid.Twist = STwist();
    if (solid.IsPassive()) {
      continue;
    }
    const SDriveCommand ordered = solid.Drive.Read();
    if (!ordered.IsFinite()) {
      throw SBadDriveCommand{solid.Owner.Body, solid.Drive};
    }
    const SDriveCommand command =
        ordered.Limited(kMaxStep * solid.NarrowestHalf / substep.Duration);
    const SDriveCommand& last = solid.LastCommand;
    const SArc arc = FollowArcs(solid.Pose, last, command, substep.Duration, substep.LateShare);
    solid.Arc = arc.End;
    const Real meanYawRate = command.YawRate + substep.LateShare * (last.YawRate - command.YawRate);
    solid.Twist = {arc.DX, arc.DY, meanYawRate * substep.Duration};
    if (substep.IsLast) {
      solid.LastCommand = command;
    }
  }
}

void CSolids::Step(CDiscSwarm& discs) {
  if (m_solids.empty()) {
    return;
  }
  m_solver.Clear();
  m_links.clear();
  m_pushed.clear();
  m_pushers.clear();
  m_pushes.clear();
  m_farthest = 0.0;
  if (!m_ghosts.empty()) {
    BuildGrid();
  }
  m_ghostCells.List(m_grid, m_ghosts, 0.0);
  FindPushed(discs);
  if (m_pushed.empty() && m_numDriven == 0) {
    return;
  }
  ListAll();
  // the list grows, because neighbours of pushed bodies are added
  for (size_t i = 0; i < m_pushed.size(); ++i) {
    AddNeighbours(m_pushed[i], discs);
  }
  Solve();
  m_solver.Remember();
  TakeTwists(discs);
  MoveTogether(discs);
  bool hasProgress = true;
  for (int pass = 0; pass < kPasses && hasProgress; ++pass) {
    hasProgress = MovePushed(discs);
  }
  for (SSolid& solid : m_solids) {
    if (!solid.IsPassive()) {
      StepDriven(solid, discs);
      solid.IsFresh = false;
    }
  }
}

// Moves the bodies of each island together, because one may have to make space for another that
// makes space for it: two boxes that turn face to face.
void CSolids::MoveTogether(const CDiscSwarm& discs) {
  std::sort(m_members.begin(), m_members.end(), [](const SMember& a, const SMember& b) {
    return std::tie(a.Island, a.Slot) < std::tie(b.Island, b.Slot);
  });
  for (size_t first = 0; first < m_members.size();) {
    size_t end = first;
    while (end < m_members.size() && m_members[end].Island == m_members[first].Island) {
      ++end;
    }
    MoveIsland(std::span(m_members).subspan(first, end - first), discs);
    first = end;
  }
}

// Moves an island as far as there is space; its bodies keep what is left of their twists.
void CSolids::MoveIsland(std::span<const SMember> members, const CDiscSwarm& discs) {
  const auto countSteps = [this](const SMember& member) {
    const SSolid& solid = m_solids[member.Slot];
    return std::ceil(ComputeLength(solid, solid.Twist) / (kSolidStep * solid.NarrowestHalf));
  };
  const auto placeAt = [&](Real share) {
    for (const SMember& member : members) {
      SSolid& solid = m_solids[member.Slot];
      Place(solid, Moved(member.Start, solid.Twist, share));
    }
  };
  Real steps = 0.0;
  for (const SMember& member : members) {
    steps = std::max(steps, countSteps(member));
  }
  Real made = 0.0;
  for (Real step = 1.0; step <= steps; ++step) {
    placeAt(step / steps);
    if (AreFree(members, false, discs)) {
      made = step;
    } else if (step == steps || !AreFree(members, true, discs)) {
      placeAt(made / steps);
      break;
    }
  }
  const Real left = steps > 0.0 ? 1.0 - made / steps : 1.0;
  for (const SMember& member : members) {
    SSolid& solid = m_solids[member.Slot];
    solid.Twist = {left * solid.Twist.X, left * solid.Twist.Y, left * solid.Twist.Turn};
    solid.HasMoved |= left < 1.0;
  }
}

// Moves the pushed bodies by what is left of their twists, those that are farthest from the robots
// first, because they make space for the others. @return true if another pass may move them on.
bool CSolids::MovePushed(CDiscSwarm& discs) {
  bool hasMoved = false;
  bool isBlocked = false;
  const auto take = [&](STwist& twist, Real share) {
    if (twist.X != 0.0 || twist.Y != 0.0 || twist.Turn != 0.0) {
      hasMoved |= share > 0.0;
      isBlocked |= share < 1.0;
      const Real left = 1.0 - share;
      twist = {left * twist.X, left * twist.Y, left * twist.Turn};
    }
  };
  for (SPusher& pusher : m_pushers) {
    take(pusher.Back, PushBack(pusher, discs));
  }
  for (size_t i = m_pushed.size(); i-- > 0;) {
    SSolid& solid = m_solids[m_pushed[i]];
    take(solid.Twist, Move(solid, solid.Twist, discs));
  }
  return hasMoved && isBlocked;
}

// Longest path of a body in this tick, m, including the correction of overlaps.
Real CSolids::ComputeFarthest(const SSolid& solid) const {
  const Real planned = solid.IsPassive() ? m_farthest : ComputeLength(solid, solid.Twist);
  return 2.0 * planned + 2.0 * kSolidStep * solid.NarrowestHalf;
}

// Builds the grid, if it does not fit the number of solids.
void CSolids::BuildGrid() {
  if (m_solidsOfGrid <= 2 * m_solids.size() && m_solids.size() <= 2 * m_solidsOfGrid) {
    return;
  }
  Real widest = 0.0;
  SPlanarArea area = SPlanarArea::Empty();
  for (const SSolid& solid : m_solids) {
    widest = std::max(widest, solid.BoundingRadius);
    area.Include(solid.Pose.X, solid.Pose.Y);
  }
  m_grid.Cover(area, 2.0 * widest, CFramedGrid::AimedCells(m_solids.size()));
  m_solidsOfGrid = m_solids.size();
  m_wallsChanged = true;
}

// Lists walls and solids by cells; solids by all cells that they may reach in this tick.
void CSolids::ListAll() {
  BuildGrid();
  Real reach = 0.0;
  for (const SSolid& solid : m_solids) {
    reach = std::max(reach, ComputeFarthest(solid));
  }
  if (m_wallsChanged) {
    m_wallsChanged = false;
    m_wallCells.List(m_grid, m_walls, 0.0);
  }
  m_solidCells.List(m_grid, m_footprints, reach);
}

void CSolids::SetWalls(std::span<const SFootprint> walls) {
  m_walls = walls;
  m_wallsChanged = true;
}

// Finds the objects that robots push directly, and objects that were placed since the last tick.
void CSolids::FindPushed(const CDiscSwarm& discs) {
  for (UInt32 slot = 0; slot < m_solids.size(); ++slot) {
    if (m_solids[slot].IsPassive()) {
      AddPushesOfDiscs(slot, discs);
      AddPushesOfSolids(slot);
      FindGhostOverlaps(slot);
      if (m_solids[slot].IsFresh) {
        AddToSolver(slot);
      }
    }
  }
}

// Adds the contacts of a pushed body with its neighbours.
void CSolids::AddNeighbours(UInt32 slot, const CDiscSwarm& discs) {
  SSolid& solid = m_solids[slot];
  const Real margin = 2.0 * m_farthest + kSolidTolerance * solid.NarrowestHalf;
  const Real reach = solid.BoundingRadius + margin;
  const Real most = kSolidStep * solid.NarrowestHalf;
  m_wallCells.Find(m_grid, solid.Pose.X, solid.Pose.Y, reach, m_found);
  for (const UInt32 wall : m_found) {
    if (IsNear(solid, m_wallCells.GetFootprint(wall), margin)) {
      AddObstacle(solid, m_wallCells.GetFootprint(wall), most);
    }
  }
  m_ghostCells.Find(m_grid, solid.Pose.X, solid.Pose.Y, reach, m_found);
  for (const UInt32 ghost : m_found) {
    // the whole overlap, because a ghost moves on in the next tick
    AddObstacle(solid, m_ghostCells.GetFootprint(ghost), m_farthest);
  }
  m_nearDiscs.clear();
  discs.ForDiscsNear(solid.Pose.X, solid.Pose.Y, solid.BoundingRadius + margin,
                     [this](UInt32 disc) { m_nearDiscs.push_back(disc); });
  std::sort(m_nearDiscs.begin(), m_nearDiscs.end());
  for (const UInt32 disc : m_nearDiscs) {
    // one that pushes the body has a contact already
    if (!IsPush(slot, disc)) {
      AddObstacle(
          solid,
          MakeDisc(discs.GetPoseNear(disc, solid.Pose.X, solid.Pose.Y), discs.GetRadius(disc)),
          most);
    }
  }
  FindSolidsNear(solid.Pose.X, solid.Pose.Y, reach);
  for (UInt32& footprint : m_found) {
    footprint = m_slotOf[footprint];
  }
  std::sort(m_found.begin(), m_found.end());
  m_found.erase(std::unique(m_found.begin(), m_found.end()), m_found.end());
  for (const UInt32 i : m_found) {
    SSolid& other = m_solids[i];
    const Real dx = m_period.X.Shorten(other.Pose.X - solid.Pose.X);
    const Real dy = m_period.Y.Shorten(other.Pose.Y - solid.Pose.Y);
    if (i == slot || std::hypot(dx, dy) > other.BoundingRadius + solid.BoundingRadius + margin) {
      continue;
    }
    const SPlanarVector image = FindImage(other.Pose.X, other.Pose.Y, solid);
    if (!other.IsPassive()) {
      for (const SFootprint& footprint : FootprintsOf(other)) {
        if (!IsPush(slot, kSolidRobot | i)) {
          AddObstacle(solid, Displace(footprint, image.X, image.Y), most);
        }
      }
    } else if (other.Number == CPushSolver::kNone || other.Number > solid.Number) {
      AddToSolver(i);
      AddSolidNeighbour(solid, other);
    }
  }
}

// Adds the contacts of two bodies that may both be pushed.
void CSolids::AddSolidNeighbour(SSolid& solid, SSolid& other) {
  const SPlanarVector image = FindImage(other.Pose.X, other.Pose.Y, solid);
  for (size_t a = solid.FirstFootprint; a < solid.FirstFootprint + solid.NumFootprints; ++a) {
    for (size_t b = other.FirstFootprint; b < other.FirstFootprint + other.NumFootprints; ++b) {
      SSeparation contacts[2];
      const int count =
          FindContacts(m_footprints[a], Displace(m_footprints[b], image.X, image.Y), contacts);
      for (int i = 0; i < count; ++i) {
        const Real narrowest = std::min(solid.NarrowestHalf, other.NarrowestHalf);
        const Real most = kSolidStep * narrowest;
        AddLink({solid.Number, other.Number, contacts[i].GetNormal(),
                 ComputeLever(solid, contacts[i]), ComputeLever(other, contacts[i], image),
                 ComputeLeast(contacts[i].Gap, narrowest, most)},
                contacts[i], {.Footprint = static_cast<UInt32>(a)},
                {.Footprint = static_cast<UInt32>(b), .Image = image});
      }
    }
  }
}

// Adds the contacts of a body with a fixed obstacle. Of an overlap, at most @p most (m) is
// corrected in a tick.
void CSolids::AddObstacle(const SSolid& solid, const SFootprint& footprint, Real most) {
  for (size_t mine = solid.FirstFootprint; mine < solid.FirstFootprint + solid.NumFootprints;
       ++mine) {
    SSeparation contacts[2];
    const int count = FindContacts(footprint, m_footprints[mine], contacts);
    for (int i = 0; i < count; ++i) {
      AddLink({CPushSolver::kNone, solid.Number, contacts[i].GetNormal(), 0.0,
               ComputeLever(solid, contacts[i]),
               ComputeLeast(contacts[i].Gap, solid.NarrowestHalf, most)},
              contacts[i], {.Place = footprint}, {.Footprint = static_cast<UInt32>(mine)});
    }
  }
}

// The same of the circle around a robot with a face half-way to a ghost.
void CSolids::AddFace(const SSolid& solid, const SFootprint& face, Real most) {
  SSeparation contacts[2];
  const int count = FindContacts(face, MakeDisc(solid.Pose, solid.BoundingRadius), contacts);
  for (int i = 0; i < count; ++i) {
    m_solver.AddContact({CPushSolver::kNone, solid.Number, contacts[i].GetNormal(), 0.0,
                         ComputeLever(solid, contacts[i]),
                         ComputeLeast(contacts[i].Gap, solid.NarrowestHalf, most)});
  }
}

// A robot that is not a disc follows its drive, slides along obstacles, or stops.
void CSolids::StepDriven(SSolid& solid, const CDiscSwarm& discs) {
  const Real length = ComputeLength(solid, solid.Twist);
  if (length == 0.0 && !solid.IsFresh) {
    return;
  }
  GatherObstacles(solid, 2.0 * length, discs);
  m_solver.Clear();
  m_links.clear();
  solid.Number = m_solver.AddBody(solid.Twist, 0.0, 0.0, solid.SquaredGyration);
  for (const SObstacle& obstacle : m_obstacles) {
    const Real most = kSolidStep * solid.NarrowestHalf;
    if (obstacle.IsFace) {
      AddFace(solid, obstacle.Footprint, most);
    } else {
      AddObstacle(solid, obstacle.Footprint, most);
    }
  }
  Solve();
  STwist twist = Shortened(solid, m_solver.GetTwist(solid.Number), ComputeFarthest(solid));
  solid.Number = CPushSolver::kNone;
  const bool isFree =
      twist.X == solid.Twist.X && twist.Y == solid.Twist.Y && twist.Turn == solid.Twist.Turn;
  // the remainder of a blocked step is tried without rotation
  if (Move(solid, twist, discs) < 1.0) {
    twist.Turn = 0.0;
    Move(solid, twist, discs);
  } else if (isFree) {
    Place(solid, solid.Arc);
  }
}

// Collects the obstacles near a body.
void CSolids::GatherObstacles(const SSolid& solid, Real margin, const CDiscSwarm& discs) {
  m_obstacles.clear();
  const auto add = [&](const SFootprint& footprint, bool isFace = false) {
    if (IsNear(solid, footprint, margin)) {
      SObstacle& obstacle = m_obstacles.emplace_back(SObstacle{footprint, isFace});
      obstacle.Gap = ComputeGapTo(solid, solid.Pose, obstacle);
    }
  };
  const Real reach = solid.BoundingRadius + margin;
  m_wallCells.Find(m_grid, solid.Pose.X, solid.Pose.Y, reach, m_found);
  for (const UInt32 wall : m_found) {
    add(m_wallCells.GetFootprint(wall));
  }
  m_nearDiscs.clear();
  discs.ForDiscsNear(solid.Pose.X, solid.Pose.Y, reach,
                     [this](UInt32 disc) { m_nearDiscs.push_back(disc); });
  // their order within cells depends on threads
  std::sort(m_nearDiscs.begin(), m_nearDiscs.end());
  for (const UInt32 disc : m_nearDiscs) {
    add(MakeDisc(discs.GetPoseNear(disc, solid.Pose.X, solid.Pose.Y), discs.GetRadius(disc)));
  }
  FindSolidsNear(solid.Pose.X, solid.Pose.Y, reach);
  for (const UInt32 footprint : m_found) {
    const SSolid& other = m_solids[m_slotOf[footprint]];
    if (&other != &solid) {
      const SPlanarVector image = FindImage(other.Pose.X, other.Pose.Y, solid);
      add(Displace(m_solidCells.GetFootprint(footprint), image.X, image.Y));
    }
  }
  if (solid.IsPassive()) {
    m_ghostCells.Find(m_grid, solid.Pose.X, solid.Pose.Y, reach, m_found);
    for (const UInt32 ghost : m_found) {
      add(m_ghostCells.GetFootprint(ghost));
    }
  }
  for (const SFace& face : m_faces) {
    if (&Get(face.Robot) == &solid) {
      add(face.Footprint, true);
    }
  }
}

// Moves a body along a twist as far as there is space. @return the share that it has moved.
Real CSolids::Move(SSolid& solid, const STwist& twist, const CDiscSwarm& discs) {
  const Real length = ComputeLength(solid, twist);
  if (!(length > kNegligibleStep * solid.NarrowestHalf)) {
    return 1.0;
  }
  GatherObstacles(solid, length, discs);
  const auto steps = static_cast<UInt32>(std::ceil(length / (kSolidStep * solid.NarrowestHalf)));
  const Real stepShare = 1.0 / steps;
  const SPlanarPose start = solid.Pose;
  Real share = 0.0;
  bool isFree = true;
  for (UInt32 step = 0; step < steps && isFree; ++step) {
    const Real planned = step + 1 == steps ? 1.0 : (step + 1) * stepShare;
    isFree = IsFree(solid, Moved(start, twist, planned), 0.0, true);
    if (isFree) {
      share = planned;
    }
  }
  Real part = 0.5 * stepShare;
  for (int halving = 0; halving < kHalvings && !isFree; ++halving, part *= 0.5) {
    if (IsFree(solid, Moved(start, twist, share + part), 0.0, true)) {
      share += part;
    }
  }
  if (share > 0.0) {
    Place(solid, Moved(start, twist, share));
    solid.HasMoved = true;
  }
  return share;
}

// @param depth  of an overlap that is allowed besides the tolerance, m.
// @return true if a body at that pose overlaps no gathered obstacle, or none deeper than before,
// if that is allowed.
bool CSolids::IsFree(const SSolid& solid, const SPlanarPose& pose, Real depth,
                     bool allowsOld) const {
  const Real tolerance = kSolidTolerance * solid.NarrowestHalf + depth;
  return std::all_of(m_obstacles.begin(), m_obstacles.end(), [&](const SObstacle& obstacle) {
    const Real gap = ComputeGapTo(solid, pose, obstacle);
    return gap >= -tolerance || (allowsOld && gap >= obstacle.Gap);
  });
}

// The gap between the body at that pose and an obstacle, m.
Real CSolids::ComputeGapTo(const SSolid& solid, const SPlanarPose& pose,
                           const SObstacle& obstacle) const {
  if (obstacle.IsFace) {
    return ComputeGap(MakeDisc(pose, solid.BoundingRadius), obstacle.Footprint);
  }
  Real gap = HUGE_VAL;
  for (size_t i = 0; i < solid.NumFootprints; ++i) {
    const SFootprint mine = Transform(m_shapes[solid.FirstFootprint + i], pose);
    gap = std::min(gap, ComputeGap(mine, obstacle.Footprint));
  }
  return gap;
}

}  // namespace argos
