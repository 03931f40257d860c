#include <argos3/plugins/simulator/physics_engines/dynamics3d/rigid_ghosts.h>

#include <argos3/core/simulator/geometry/body_description.h>
#include <argos3/core/simulator/physics_engine/physics_model.h>
#include <argos3/plugins/simulator/physics_engines/dynamics3d/body_builder.h>
#include <argos3/plugins/simulator/physics_engines/dynamics3d/cylinder_contacts.h>
#include <argos3/plugins/simulator/physics_engines/dynamics3d/rigid_settings.h>

#include <algorithm>
#include <cmath>

namespace argos {

namespace {

// cosine of the greatest lean of a standing robot: 20 degrees, more than on any slope that it
// climbs
constexpr Real kStands = 0.94;
// m; bodies that overlap a ghost by at most this stay asleep; greater than the overlap of contacts
// at rest
constexpr Real kRestingDepth = 1e-4;

bool IsRobot(const SRigidBody& body) {
  return body.HasDrive() || body.Source.Quadrotor != nullptr;
}

// horizontal gap, m
Real ComputeGapAcross(const SGhostCylinder& a, const SGhostCylinder& b) {
  return std::hypot(a.X - b.X, a.Y - b.Y) - a.Radius - b.Radius;
}

// vertical gap, m
Real ComputeGapUp(const SGhostCylinder& a, const SGhostCylinder& b) {
  return std::max(a.Low - b.High, b.Low - a.High);
}

}  // namespace

SGhostCylinder EncloseRobot(const SBodyDescription& description, const SRigidPose& pose) {
  const SBoundingBox box = description.ComputeBoundingBox(pose.Position, pose.Orientation);
  SGhostCylinder cylinder;
  cylinder.Low = box.MinCorner.GetZ();
  cylinder.High = box.MaxCorner.GetZ();
  if (Rotated(CVector3::Z, pose.Orientation).GetZ() >= kStands) {
    cylinder.X = pose.Position.GetX();
    cylinder.Y = pose.Position.GetY();
    cylinder.Radius = description.ComputeBoundingRadius();
    return cylinder;
  }
  const CVector3 centre = (box.MinCorner + box.MaxCorner) * 0.5;
  cylinder.X = centre.GetX();
  cylinder.Y = centre.GetY();
  for (const SShapeDescription& shape : description.Shapes) {
    const Real half = 0.5 * shape.Size.GetZ();
    const CVector3 middle = Rotated(
        shape.Offset + Rotated(CVector3(0.0, 0.0, half), shape.Orientation), pose.Orientation);
    const CVector3 offset = pose.Position + middle - centre;
    const Real around = shape.Kind == SShapeDescription::EKind::Sphere
                            ? shape.Radius
                            : std::hypot(shape.Radius, half);
    cylinder.Radius = std::max(cylinder.Radius, std::hypot(offset.GetX(), offset.GetY()) + around);
  }
  return cylinder;
}

Real ComputeGap(const SGhostCylinder& first, const SGhostCylinder& second) {
  return std::max(ComputeGapAcross(first, second), ComputeGapUp(first, second));
}

CRigidGhosts::CRigidGhosts() {
  m_face.Friction = m_cylinder.Friction = 0.0;
  m_face.Margin = kFaceMargin;
  m_face.Solids.push_back(dCreatePlane(nullptr, 0.0, 0.0, 1.0, 0.0));
  m_cylinder.Solids.push_back(dCreateCylinder(nullptr, 1.0, 1.0));
}

CRigidGhosts::~CRigidGhosts() {
  dGeomDestroy(m_face.Solids.front());
  dGeomDestroy(m_cylinder.Solids.front());
}

void CRigidGhosts::Set(const std::vector<SGhostCylinder>& ghosts) {
  m_ghosts.assign(ghosts.begin(), ghosts.end());
  m_faces.clear();
  m_obstacles.clear();
  m_low.Set(HUGE_VAL, HUGE_VAL, HUGE_VAL);
  m_high = -m_low;
  for (const SGhostCylinder& ghost : m_ghosts) {
    const CVector3 around(ghost.Radius, ghost.Radius, 0.0);
    const CVector3 low = CVector3(ghost.X, ghost.Y, ghost.Low) - around;
    const CVector3 high = CVector3(ghost.X, ghost.Y, ghost.High) + around;
    for (UInt32 axis = 0; axis < 3; ++axis) {
      m_low[axis] = std::min(m_low[axis], low[axis]);
      m_high[axis] = std::max(m_high[axis], high[axis]);
    }
  }
}

void CRigidGhosts::FindMeetings(const std::vector<SRigidBody*>& movables, Real path,
                                Real flyingPath) {
  for (SRigidBody* body : movables) {
    const Real own = body->Source.Quadrotor != nullptr ? std::max(path, flyingPath) : path;
    // the face is half-way
    const Real reach = 2.0 * own;
    bool isNear = true;
    for (UInt32 axis = 0; axis < 3; ++axis) {
      isNear = isNear && body->Low[axis] - reach <= m_high[axis] &&
               body->High[axis] + reach >= m_low[axis];
    }
    if (isNear && IsRobot(*body)) {
      FindRobotMeetings(*body, own);
    } else if (isNear) {
      FindObjectMeetings(*body, own);
    }
  }
}

void CRigidGhosts::FindRobotMeetings(SRigidBody& robot, Real path) {
  const SGhostCylinder own = EncloseRobot(*robot.Source.Description, GetRigidPose(robot));
  for (const SGhostCylinder& ghost : m_ghosts) {
    const Real gap = ComputeGap(own, ghost);
    if (gap > 2.0 * path) {
      continue;
    }
    if (ComputeGapUp(own, ghost) == gap) {
      // half-way
      const bool isAbove = own.Low - ghost.High == gap;
      const Real height = isAbove ? ghost.High + 0.5 * gap : ghost.Low - 0.5 * gap;
      const Real up = isAbove ? 1.0 : -1.0;
      m_faces.push_back({&robot, CVector3(0.0, 0.0, up), up * height});
    } else {
      const CVector3 across(own.X - ghost.X, own.Y - ghost.Y, 0.0);
      const Real distance = across.Length();
      // coincident axes determine no side
      const CVector3 normal = distance > 0.0 ? across / distance : CVector3::X;
      m_faces.push_back(
          {&robot, normal,
           normal.GetX() * ghost.X + normal.GetY() * ghost.Y + ghost.Radius + 0.5 * gap});
    }
    if (robot.Asleep && 0.5 * gap < -kRestingDepth) {
      WakeRigidBody(robot);
    }
  }
}

void CRigidGhosts::FindObjectMeetings(SRigidBody& object, Real path) {
  for (UInt32 i = 0; i < m_ghosts.size(); ++i) {
    const SGhostCylinder& ghost = m_ghosts[i];
    const Real reach = ghost.Radius + path;
    if (object.Low.GetX() > ghost.X + reach || object.High.GetX() < ghost.X - reach ||
        object.Low.GetY() > ghost.Y + reach || object.High.GetY() < ghost.Y - reach ||
        object.Low.GetZ() > ghost.High + path || object.High.GetZ() < ghost.Low - path) {
      continue;
    }
    m_obstacles.push_back({&object, i});
    if (object.Asleep && IsInside(object, ghost)) {
      WakeRigidBody(object);
    }
  }
}

void CRigidGhosts::MoveCylinder(const SGhostCylinder& ghost) const {
  const dGeomID geom = m_cylinder.Solids.front();
  dGeomCylinderSetParams(geom, ghost.Radius, ghost.High - ghost.Low);
  dGeomSetPosition(geom, ghost.X, ghost.Y, 0.5 * (ghost.Low + ghost.High));
}

bool CRigidGhosts::IsInside(const SRigidBody& object, const SGhostCylinder& ghost) const {
  constexpr int kMax = 4;
  MoveCylinder(ghost);
  for (const dGeomID solid : object.Solids) {
    dContactGeom contacts[kMax];
    const int count =
        FindContacts(solid, m_cylinder.Solids.front(), kMax, contacts, sizeof(dContactGeom));
    for (int i = 0; i < count; ++i) {
      if (contacts[i].depth > kRestingDepth) {
        return true;
      }
    }
  }
  return false;
}

}  // namespace argos
