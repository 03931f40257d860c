// The part of CUprightCrowd that finds which bodies are upright in a tick, and what they may meet.

#include <argos3/plugins/simulator/physics_engines/dynamics3d/upright_crowd.h>

#include <argos3/core/simulator/geometry/body_description.h>
#include <argos3/plugins/simulator/physics_engines/dynamics3d/body_builder.h>
#include <argos3/plugins/simulator/physics_engines/dynamics3d/key_table.h>
#include <argos3/plugins/simulator/physics_engines/dynamics3d/rigid_ghosts.h>
#include <argos3/plugins/simulator/physics_engines/dynamics3d/rigid_settings.h>

#include <algorithm>
#include <bit>
#include <cmath>

namespace argos {

namespace {

// m: solids whose heights overlap by less do not touch only sideways
constexpr Real kThin = 1e-3;
// places of the hash table for each pair, at least
constexpr size_t kMemoryRoom = 2;

SFootprint CoverBounds(const SRigidBody& body) {
  const CVector3 sides = body.High - body.Low;
  return {0.5 * (body.Low.GetX() + body.High.GetX()),
          0.5 * (body.Low.GetY() + body.High.GetY()),
          1.0,
          0.0,
          0.5 * sides.GetX(),
          0.5 * sides.GetY(),
          0.0};
}

void LayGrid(const std::vector<SFootprint>& footprints, Real reach, CFramedGrid& grid,
             CCellLists& cells) {
  SPlanarArea area = SPlanarArea::Empty();
  Real sum = 0.0;
  for (const SFootprint& footprint : footprints) {
    area.Include(footprint.X, footprint.Y);
    sum += ComputeExtent(footprint);
  }
  const size_t count = footprints.size();
  grid.Cover(area, 2.0 * (sum / static_cast<Real>(count) + reach), CFramedGrid::AimedCells(count));
  cells.List(grid, footprints, 0.0);
}

}  // namespace

void CUprightCrowd::StartTick(const SBodies& bodies, const std::optional<SRollGround>& ground,
                              Real reach) {
  Remember();
  m_bodies.clear();
  m_supports.clear();
  m_parts.clear();
  m_footprints.clear();
  m_pairs.clear();
  m_ground = ground;
  m_reach = reach;
  for (SRigidBody* body : bodies.Active) {
    body->IsUpright = false;
  }
  const bool isUsed = m_settings.Upright && ground && m_settings.Restitution == 0.0 &&
                      m_settings.Stepper == SRigidSettings::EStepper::Mixed;
  if (!isUsed || std::all_of(bodies.Active.begin(), bodies.Active.end(),
                             [](const SRigidBody* body) { return body->Asleep; })) {
    return;
  }
  ListBodies(bodies);
  if (m_bodies.empty()) {
    return;
  }
  if (m_haveFixedChanged) {
    ListFixed(bodies.Fixed);
    m_haveFixedChanged = false;
  }
  FindPairs();
  SelectClusters();
  Recall();
}

void CUprightCrowd::ListBodies(const SBodies& bodies) {
  for (SRigidBody* body : bodies.Active) {
    if (body->TippingTime <= 0.0 && CanStand(*body) && StandsUpright(*body, *m_ground)) {
      AddBody(*body);
    } else {
      AddOther(*body);
    }
  }
  for (const SGhostCylinder& ghost : bodies.Ghosts) {
    AddGhost(ghost);
  }
}

void CUprightCrowd::AddBody(SRigidBody& rigid) {
  const UInt32 number = static_cast<UInt32>(m_bodies.size());
  SUprightBody& body = m_bodies.emplace_back();
  const SRigidPose pose = GetRigidPose(rigid);
  body.Rigid = &rigid;
  body.Pose = MakePlanarPose(pose.Position, pose.Orientation);
  body.FirstPart = static_cast<UInt32>(m_parts.size());
  body.NumParts = static_cast<UInt32>(rigid.UprightParts.size());
  for (const SUprightPart& part : rigid.UprightParts) {
    m_parts.push_back(
        {number, &rigid, true, pose.Position.GetZ() + part.Low, pose.Position.GetZ() + part.High});
    m_footprints.emplace_back();
  }
  PlaceParts(body, 0.0, 0.0);
}

void CUprightCrowd::AddOther(const SRigidBody& body) {
  m_parts.push_back({kNone, &body, false, body.Low.GetZ(), body.High.GetZ()});
  m_footprints.push_back(CoverBounds(body));
}

void CUprightCrowd::AddGhost(const SGhostCylinder& ghost) {
  m_parts.push_back({kNone, nullptr, false, ghost.Low, ghost.High});
  m_footprints.push_back({ghost.X, ghost.Y, 1.0, 0.0, 0.0, 0.0, ghost.Radius});
}

void CUprightCrowd::ListFixed(const std::vector<SRigidBody*>& fixed) {
  m_fixedParts.clear();
  m_fixedFootprints.clear();
  for (SRigidBody* body : fixed) {
    const CQuaternion& turn = body->Fixed.Orientation;
    if (turn.GetX() != 0.0 || turn.GetY() != 0.0 || !AreSolidsUpright(*body)) {
      m_fixedParts.push_back({kNone, body, false, body->Low.GetZ(), body->High.GetZ()});
      m_fixedFootprints.push_back(CoverBounds(*body));
      continue;
    }
    AppendFootprints(*body->Source.Description, MakePlanarPose(body->Fixed.Position, turn),
                     m_fixedFootprints);
    for (const SShapeDescription& shape : body->Source.Description->Shapes) {
      const Real low = body->Fixed.Position.GetZ() + shape.Offset.GetZ();
      m_fixedParts.push_back({kNone, body, true, low, low + shape.Size.GetZ()});
    }
  }
  m_fixedCells.Clear();
  if (!m_fixedFootprints.empty()) {
    LayGrid(m_fixedFootprints, m_reach, m_fixedGrid, m_fixedCells);
  }
}

// @param offsetX, offsetY  of the pose from the origin, frame of the body, m.
void CUprightCrowd::PlaceParts(const SUprightBody& body, Real offsetX, Real offsetY) {
  const Real cosine = body.Cos();
  const Real sine = body.Sin();
  const Real x = body.Pose.X - cosine * offsetX + sine * offsetY;
  const Real y = body.Pose.Y - sine * offsetX - cosine * offsetY;
  for (UInt32 i = 0; i < body.NumParts; ++i) {
    m_footprints[body.FirstPart + i] =
        PlaceFootprint(body.Rigid->UprightParts[i].Footprint, x, y, cosine, sine);
  }
}

void CUprightCrowd::FindPairs() {
  ResetForest(m_clusters, m_bodies.size());
  m_isOut.assign(m_bodies.size(), 0);
  m_tips.assign(m_bodies.size(), 0);
  LayGrid(m_footprints, m_reach, m_grid, m_cells);
  for (const SUprightBody& body : m_bodies) {
    for (UInt32 part = body.FirstPart; part < body.FirstPart + body.NumParts; ++part) {
      PairWithOthers(part);
      PairWithFixed(part);
    }
  }
}

void CUprightCrowd::PairWithOthers(UInt32 part) {
  const SFootprint& own = m_footprints[part];
  const UInt32 body = m_parts[part].Body;
  const Real ownReach = GetReachOf(own.Radius > 0.0);
  m_cells.Find(m_grid, own.X, own.Y, ComputeExtent(own) + ownReach + kTurningReach * m_reach,
               m_found);
  for (const UInt32 other : m_found) {
    const UInt32 partner = m_parts[other].Body;
    if (partner == body || (partner != kNone && partner < body)) {
      continue;
    }
    const ETouch touch = JudgeHeights(m_parts[part], m_parts[other]);
    const SFootprint& of = m_footprints[other];
    if (touch == ETouch::Never || ComputeGap(own, of) > ownReach + GetReachOf(of.Radius > 0.0)) {
      continue;
    }
    if (touch == ETouch::Otherwise) {
      m_isOut[body] = 1;
    }
    if (partner != kNone) {
      Connect(m_clusters, body, partner);
      AddPair(part, other, false);
    }
  }
}

void CUprightCrowd::PairWithFixed(UInt32 part) {
  const SFootprint& own = m_footprints[part];
  const UInt32 body = m_parts[part].Body;
  if (m_fixedCells.IsEmpty()) {
    return;
  }
  const Real reach = GetReachOf(own.Radius > 0.0);
  m_fixedCells.Find(m_fixedGrid, own.X, own.Y, ComputeExtent(own) + reach + kFaceMargin, m_found);
  for (const UInt32 other : m_found) {
    const ETouch touch = JudgeHeights(m_parts[part], m_fixedParts[other]);
    if (touch == ETouch::Never ||
        ComputeGap(own, m_fixedFootprints[other]) > reach + m_fixedParts[other].Rigid->Margin) {
      continue;
    }
    if (touch == ETouch::Otherwise) {
      m_isOut[body] = 1;
    } else {
      AddPair(part, other, true);
    }
  }
}

// How may a part of an upright body touch another solid above it, below it or beside it?
CUprightCrowd::ETouch CUprightCrowd::JudgeHeights(const SPart& own, const SPart& other) const {
  const Real floor = m_ground->Height;
  if (!other.IsUpright) {
    return other.Low - m_reach <= own.High && other.High + m_reach >= floor ? ETouch::Otherwise
                                                                            : ETouch::Never;
  }
  if (other.Low >= own.High || other.High <= floor + kFreeHeight) {
    return ETouch::Never;
  }
  // what is lower than the solids of a robot is in the way of its wheels
  const Real overlap = std::min(own.High, other.High) - std::max(own.Low, other.Low);
  return overlap > kThin ? ETouch::Sideways : ETouch::Otherwise;
}

void CUprightCrowd::AddPair(UInt32 partA, UInt32 partB, bool isFixed) {
  const SPart& a = m_parts[partA];
  const SPart& b = isFixed ? m_fixedParts[partB] : m_parts[partB];
  SPair& pair = m_pairs.emplace_back();
  pair.A = a.Body;
  pair.B = isFixed ? kNone : b.Body;
  pair.PartA = partA;
  pair.PartB = partB;
  pair.Low = std::max(a.Low, b.Low) - m_ground->Height;
  pair.High = std::min(a.High, b.High) - m_ground->Height;
  pair.Margin = isFixed ? b.Rigid->Margin : 0.0;
  pair.Friction = a.Rigid->Friction * b.Rigid->Friction;
  const UInt32 ownA = partA - m_bodies[pair.A].FirstPart;
  const UInt32 ownB = isFixed ? partB : partB - m_bodies[pair.B].FirstPart;
  pair.Key = ComputePairKey(a.Rigid->Serial, b.Rigid->Serial, (UInt64(ownA) << 32) + ownB);
  pair.Normals = pair.Tangents = {};
}

// Clusters in which all bodies are upright, and one is awake.
void CUprightCrowd::SelectClusters() {
  constexpr UInt8 kOut = 1;
  constexpr UInt8 kAwake = 2;
  std::vector<UInt8>& state = m_tips;  // by root
  for (UInt32 i = 0; i < m_bodies.size(); ++i) {
    UInt8& of = state[FindRootOf(m_clusters, i)];
    of = static_cast<UInt8>(of | (m_isOut[i] != 0 ? kOut : 0) |
                            (m_bodies[i].Rigid->Asleep ? 0 : kAwake));
  }
  for (UInt32 i = 0; i < m_bodies.size(); ++i) {
    const bool isIn = state[FindRootOf(m_clusters, i)] == kAwake;
    m_isOut[i] = isIn ? 0 : 1;
    m_bodies[i].Rigid->IsUpright = isIn;
  }
  m_pairs.erase(std::remove_if(m_pairs.begin(), m_pairs.end(),
                               [this](const SPair& pair) { return m_isOut[pair.A] != 0; }),
                m_pairs.end());
  m_tips.assign(m_bodies.size(), 0);
  for (UInt32 i = 0; i < m_bodies.size(); ++i) {
    if (m_isOut[i] != 0) {
      continue;
    }
    SUprightBody& body = m_bodies[i];
    LoadUpright(*body.Rigid, *m_ground, body, m_supports);
    bool isDisc = body.NumParts == 1;
    for (UInt32 part = body.FirstPart; part < body.FirstPart + body.NumParts; ++part) {
      const SFootprint& footprint = m_footprints[part];
      const Real distance = std::hypot(footprint.X - body.Pose.X, footprint.Y - body.Pose.Y);
      body.Extent = std::max(body.Extent, distance + ComputeExtent(footprint));
      isDisc = isDisc && footprint.Radius > 0.0 && distance < kThin;
    }
    body.Sweep = isDisc ? 0.0 : body.Extent;
  }
}

// Stores the forces of the pairs of this tick in a hash table.
void CUprightCrowd::Remember() {
  if (m_pairs.empty()) {
    m_memory.clear();
    return;
  }
  const size_t size = std::bit_ceil(kMemoryRoom * m_pairs.size() + 1);
  m_memory.assign(size, {});
  for (const SPair& pair : m_pairs) {
    if (pair.Normals[0] == 0.0 && pair.Normals[1] == 0.0) {
      continue;
    }
    size_t place = pair.Key & (size - 1);
    while (m_memory[place].Key != 0) {
      place = (place + 1) & (size - 1);
    }
    m_memory[place] = {pair.Key, pair.Normals, pair.Tangents};
  }
}

void CUprightCrowd::Recall() {
  const size_t size = m_memory.size();
  for (SPair& pair : m_pairs) {
    for (size_t place = pair.Key & (size - 1); size > 0 && m_memory[place].Key != 0;
         place = (place + 1) & (size - 1)) {
      if (m_memory[place].Key == pair.Key) {
        pair.Normals = m_memory[place].Normals;
        pair.Tangents = m_memory[place].Tangents;
        break;
      }
    }
  }
}

}  // namespace argos
