#include <argos3/plugins/simulator/physics_engines/dynamics3d/upright_body.h>

#include <argos3/core/simulator/geometry/body_description.h>
#include <argos3/plugins/simulator/physics_engines/dynamics3d/body_builder.h>
#include <argos3/plugins/simulator/physics_engines/dynamics3d/rigid_motion.h>
#include <argos3/plugins/simulator/physics_engines/dynamics3d/rigid_settings.h>

#include <algorithm>
#include <cmath>

namespace argos {

namespace {

using EShape = SShapeDescription::EKind;

// feet of an object at most
constexpr size_t kMaxFeet = 8;
// Robots that press each other lean a little as long as they are not upright bodies: by so many
// times kFreeLean and kFreeHeight, and so many times as fast as others they may begin to stand.
constexpr Real kRobotSlack = 30.0;
constexpr Real kRobotTurnSlack = 5.0;
// share of a lean and of a height above the floor that is left after a tick
constexpr Real kRestOfLean = 0.5;
// of the solver for all feet of an object at once: it converges below 2
constexpr Real kStepOfFeet = 1.5;
// sine of half a lean, and m, that are roundings
constexpr Real kNoLean = 1e-7;

bool IsUprightSolid(const SShapeDescription& shape) {
  return shape.Kind != EShape::Sphere && shape.Kind != EShape::Hull && IsUpright(shape);
}

// The solids of robots begin above their casters.
Real LiftOf(const SRigidBody& body) {
  return body.HasDrive() ? kClearance * body.WheelRadius : 0.0;
}

void ListParts(SRigidBody& body) {
  const SBodyDescription& description = *body.Source.Description;
  const std::vector<SFootprint> footprints = DescribeFootprints(description, SPlanarPose());
  for (size_t i = 0; i < footprints.size(); ++i) {
    const SShapeDescription& shape = description.Shapes[i];
    const Real low = shape.Offset.GetZ();
    body.UprightParts.push_back(
        {footprints[i], std::max(low, LiftOf(body)), low + shape.Size.GetZ()});
  }
}

struct SPlace {
  Real X, Y;
};

// Corners of the base of an object, or four points of a round one.
void AddFeet(const SRigidBody& rigid, SUprightBody& body, std::vector<SUprightSupport>& supports) {
  const SFootprint& base = rigid.UprightParts.front().Footprint;
  const auto add = [&](Real x, Real y) {
    SUprightSupport& foot = supports.emplace_back();
    foot.X = base.X + base.Cos * x - base.Sin * y - body.OffsetX;
    foot.Y = base.Y + base.Sin * x + base.Cos * y - body.OffsetY;
  };
  body.Radius = base.Radius;
  if (base.Radius > 0.0) {
    add(base.Radius, 0.0);
    add(0.0, base.Radius);
    add(-base.Radius, 0.0);
    add(0.0, -base.Radius);
  } else if (base.Polygon != nullptr) {
    for (const CVector2& corner : *base.Polygon) {
      add(corner.GetX(), corner.GetY());
    }
  } else {
    add(base.HalfX, base.HalfY);
    add(-base.HalfX, base.HalfY);
    add(-base.HalfX, -base.HalfY);
    add(base.HalfX, -base.HalfY);
  }
}

void AddWheels(const SRigidBody& rigid, const SRollGround& ground, SUprightBody& body,
               std::vector<SUprightSupport>& supports) {
  const SBodyDescription& description = *rigid.Source.Description;
  const SDifferentialDriveDescription& drive = *description.Drive;
  dMass mass;
  dBodyGetMass(rigid.Wheels.front(), &mass);
  for (size_t i = 0; i < rigid.Wheels.size(); ++i) {
    SUprightSupport& wheel = supports.emplace_back();
    wheel.X = -body.OffsetX;
    wheel.Y = (i == 0 ? 0.5 : -0.5) * drive.InterwheelDistance - body.OffsetY;
    wheel.Load = 0.5 * kWheelLoad * description.Mass * ground.Gravity;
    wheel.MotorLimit = std::min(0.5 * drive.MaxForce, drive.MaxTorque / drive.InterwheelDistance);
    wheel.Rim = mass.I[0] / (rigid.WheelRadius * rigid.WheelRadius);
    wheel.Target = rigid.Source.Drive.GetWheels()[i];
    wheel.Spin = dJointGetHingeAngleRate(rigid.Axles[i]) * rigid.WheelRadius;
  }
}

// The loads that balance the weight at a place: linear in the place of the foot, and none pulls.
void DistributeLoad(SUprightSupport* feet, UInt32 count, Real weight, Real x, Real y) {
  Real middleX = 0.0;
  Real middleY = 0.0;
  for (UInt32 i = 0; i < count; ++i) {
    middleX += feet[i].X / count;
    middleY += feet[i].Y / count;
  }
  Real xx = 0.0;
  Real xy = 0.0;
  Real yy = 0.0;
  for (UInt32 i = 0; i < count; ++i) {
    const Real dx = feet[i].X - middleX;
    const Real dy = feet[i].Y - middleY;
    xx += dx * dx;
    xy += dx * dy;
    yy += dy * dy;
  }
  const Real determinant = xx * yy - xy * xy;
  const Real offX = x - middleX;
  const Real offY = y - middleY;
  const Real slopeX = (yy * offX - xy * offY) / determinant;
  const Real slopeY = (xx * offY - xy * offX) / determinant;
  Real sum = 0.0;
  for (UInt32 i = 0; i < count; ++i) {
    const Real share =
        1.0 / count + slopeX * (feet[i].X - middleX) + slopeY * (feet[i].Y - middleY);
    feet[i].Load = std::max(0.0, share);
    sum += feet[i].Load;
  }
  for (UInt32 i = 0; i < count; ++i) {
    feet[i].Load *= weight / sum;
  }
}

// Is a place, from the centre of mass, within the feet, or between the casters?
bool IsSupported(const SUprightBody& body, const SUprightSupport* supports, Real x, Real y) {
  if (body.Kind != SUprightBody::EKind::Object) {
    // casters are in front, behind and on both sides of the origin
    const SRigidBody& rigid = *body.Rigid;
    const auto& casters = rigid.Rollers;
    const Real fromX = x + body.OffsetX;
    const Real fromY = y + body.OffsetY;
    const auto reach = [&](size_t caster, UInt32 axis) {
      return std::abs(casters[caster].Offset[axis] + rigid.CentreOfMass[axis]);
    };
    return std::abs(fromX) / reach(fromX > 0.0 ? 2 : 3, 0) +
               std::abs(fromY) / reach(fromY > 0.0 ? 4 : 5, 1) <=
           1.0;
  }
  if (body.Radius > 0.0) {
    return x * x + y * y <= body.Radius * body.Radius;
  }
  for (UInt32 i = 0; i < body.NumSupports; ++i) {
    const SUprightSupport& a = supports[i];
    const SUprightSupport& b = supports[(i + 1) % body.NumSupports];
    if ((b.X - a.X) * (y - a.Y) - (b.Y - a.Y) * (x - a.X) < 0.0) {
      return false;
    }
  }
  return true;
}

void SetTargetOfPlanarDrive(SUprightBody& body, Real substep) {
  const SRigidBody& rigid = *body.Rigid;
  const SPlanarDriveDescription& drive = *rigid.Source.Description->PlanarDrive;
  const SDriveCommand command = rigid.Source.Drive.Read();
  SPlanarPose start = body.Pose;
  const SArc arc = FollowArc(start, command, substep);
  const Real cosine = arc.End.HalfCos * arc.End.HalfCos - arc.End.HalfSin * arc.End.HalfSin;
  const Real sine = 2.0 * arc.End.HalfSin * arc.End.HalfCos;
  // the origin follows the arc, and the centre of mass turns about it
  body.TargetX =
      (arc.DX + (cosine - body.Cos()) * body.OffsetX - (sine - body.Sin()) * body.OffsetY) /
      substep;
  body.TargetY =
      (arc.DY + (sine - body.Sin()) * body.OffsetX + (cosine - body.Cos()) * body.OffsetY) /
      substep;
  body.TargetW = command.YawRate;
  body.ForceLimit = drive.MaxForce * substep;
  body.TorqueLimit = drive.MaxTorque * substep;
}

// A lean and a height above the floor fade from tick to tick, so that nothing jumps.
void ReadLean(SUprightBody& body, const SRigidPose& pose, const SRollGround& ground) {
  const CQuaternion heading(body.Pose.HalfCos, 0.0, 0.0, body.Pose.HalfSin);
  const CQuaternion lean = heading.Inverse() * pose.Orientation;
  const auto fade = [](Real value) {
    return std::abs(value) > kNoLean ? kRestOfLean * value : 0.0;
  };
  body.LeanX = fade(lean.GetX());
  body.LeanY = fade(lean.GetY());
  const Real bottom = body.Rigid->HasDrive() ? 0.0 : body.Rigid->UprightParts.front().Low;
  const Real floor = ground.Height - bottom;
  body.OriginZ = floor + fade(pose.Position.GetZ() - floor);
}

// of the distances of supports from the centre of mass, m^2
Real AddUpSquares(const SUprightBody& body, const SUprightSupport* supports) {
  Real sum = 0.0;
  for (UInt32 i = 0; i < body.NumSupports; ++i) {
    sum += supports[i].X * supports[i].X + supports[i].Y * supports[i].Y;
  }
  return sum;
}

// Wheels and feet start with the impulses of the last substep; what rests, without any.
void ApplyLastFriction(SUprightBody& body, SUprightSupport* supports) {
  const bool rests =
      body.VX == 0.0 && body.VY == 0.0 && body.W == 0.0 && body.Kind == SUprightBody::EKind::Object;
  for (UInt32 i = 0; i < body.NumSupports; ++i) {
    SUprightSupport& at = supports[i];
    const Real length = std::sqrt(at.Impulse1 * at.Impulse1 + at.Impulse2 * at.Impulse2);
    Real share = length > at.Grip ? at.Grip / length : 1.0;
    share = rests ? 0.0 : share;
    at.Impulse1 *= share;
    at.Impulse2 *= share;
    body.DriveX += at.Impulse1 * at.EX - at.Impulse2 * at.EY;
    body.DriveY += at.Impulse1 * at.EY + at.Impulse2 * at.EX;
    body.DriveTurn += at.Impulse1 * at.Lever1 + at.Impulse2 * at.Lever2;
  }
  body.Push(body.DriveX, body.DriveY, body.DriveTurn);
}

}  // namespace

bool AreSolidsUpright(const SRigidBody& body) {
  const auto& shapes = body.Source.Description->Shapes;
  return std::all_of(shapes.begin(), shapes.end(), IsUprightSolid);
}

bool CanStand(SRigidBody& body) {
  if (!body.UprightParts.empty()) {
    return true;
  }
  const SBodyDescription& description = *body.Source.Description;
  const auto& shapes = description.Shapes;
  if (body.Source.Quadrotor != nullptr || description.Articulation != nullptr ||
      !AreSolidsUpright(body)) {
    return false;
  }
  const bool hasFeet = shapes.size() == 1 && (shapes.front().Vertices == nullptr ||
                                              shapes.front().Vertices->size() <= kMaxFeet);
  if (!body.HasDrive() && !hasFeet) {
    return false;
  }
  ListParts(body);
  return true;
}

bool StandsUpright(const SRigidBody& body, const SRollGround& ground) {
  if (body.IsGripped || body.TurretBody != nullptr || dBodyIsKinematic(body.Body) != 0) {
    return false;
  }
  // robots lean on the springs of their wheels
  const Real factor = body.HasDrive() ? kRobotSlack : 1.0;
  const dReal* const q = dBodyGetQuaternion(body.Body);
  // the sine of half the lean
  const Real lean = 0.5 * kFreeLean * factor;
  if (q[1] * q[1] + q[2] * q[2] > lean * lean) {
    return false;
  }
  const SRigidPose pose = GetRigidPose(body);
  const Real bottom = body.HasDrive() ? 0.0 : body.UprightParts.front().Low;
  if (std::abs(pose.Position.GetZ() + bottom - ground.Height) > kFreeHeight * factor) {
    return false;
  }
  const dReal* const turn = dBodyGetAngularVel(body.Body);
  const Real fastest = kFreeTurn * std::min(factor, kRobotTurnSlack);
  const dReal* const velocity = dBodyGetLinearVel(body.Body);
  return turn[0] * turn[0] + turn[1] * turn[1] <= fastest * fastest &&
         std::abs(velocity[2]) <= kFreeSpeed * std::min(factor, kRobotTurnSlack) &&
         FromODE(dBodyGetForce(body.Body)) == CVector3() &&
         FromODE(dBodyGetTorque(body.Body)) == CVector3();
}

void LoadUpright(SRigidBody& rigid, const SRollGround& ground, SUprightBody& body,
                 std::vector<SUprightSupport>& supports) {
  const SRigidPose pose = GetRigidPose(rigid);
  const SJointMass mass = AddUpParts(rigid);
  const CVector3 centre = rigid.CentreOfMass + mass.Offset;
  body.Rigid = &rigid;
  body.SupportX = rigid.Pressure[0];
  body.SupportY = rigid.Pressure[1];
  body.OffsetX = centre.GetX();
  body.OffsetY = centre.GetY();
  body.Pose = MakePlanarPose(pose.Position, pose.Orientation);
  ReadLean(body, pose, ground);
  body.Height = body.OriginZ + centre.GetZ() - ground.Height;
  const Real cosine = body.Cos();
  const Real sine = body.Sin();
  body.Pose.X += cosine * body.OffsetX - sine * body.OffsetY;
  body.Pose.Y += sine * body.OffsetX + cosine * body.OffsetY;
  body.Mass = mass.Mass;
  body.Inertia = mass.Inertia.ZZ;
  body.InverseMass = 1.0 / body.Mass;
  body.InverseInertia = 1.0 / body.Inertia;
  const dReal* const velocity = dBodyGetLinearVel(rigid.Body);
  body.W = dBodyGetAngularVel(rigid.Body)[2];
  const CVector3& arm = mass.Offset;
  body.VX = velocity[0] - body.W * (sine * arm.GetX() + cosine * arm.GetY());
  body.VY = velocity[1] + body.W * (cosine * arm.GetX() - sine * arm.GetY());
  body.FirstSupport = static_cast<UInt32>(supports.size());
  if (rigid.HasWheels()) {
    body.Kind = SUprightBody::EKind::Wheels;
    AddWheels(rigid, ground, body, supports);
  } else if (rigid.HasPlanarDrive()) {
    body.Kind = SUprightBody::EKind::PlanarDrive;
  } else {
    AddFeet(rigid, body, supports);
  }
  body.NumSupports = static_cast<UInt8>(supports.size() - body.FirstSupport);
  if (body.Kind == SUprightBody::EKind::Object) {
    DistributeLoad(&supports[body.FirstSupport], body.NumSupports, mass.Mass * ground.Gravity,
                   rigid.Pressure[0], rigid.Pressure[1]);
  }
}

void StoreUpright(const SUprightBody& body, const std::vector<SUprightSupport>& supports) {
  SRigidBody& rigid = *body.Rigid;
  const Real cosine = body.Cos();
  const Real sine = body.Sin();
  SRigidPose pose;
  pose.Position.Set(body.Pose.X - cosine * body.OffsetX + sine * body.OffsetY,
                    body.Pose.Y - sine * body.OffsetX - cosine * body.OffsetY, body.OriginZ);
  pose.Orientation = CQuaternion(body.Pose.HalfCos, 0.0, 0.0, body.Pose.HalfSin);
  if (body.LeanX != 0.0 || body.LeanY != 0.0) {
    const Real square = body.LeanX * body.LeanX + body.LeanY * body.LeanY;
    pose.Orientation =
        pose.Orientation * CQuaternion(std::sqrt(1.0 - square), body.LeanX, body.LeanY, 0.0);
  }
  SRigidMotion motion;
  motion.AngularVelocity.SetZ(body.W);
  const Real armX = rigid.CentreOfMass.GetX() - body.OffsetX;
  const Real armY = rigid.CentreOfMass.GetY() - body.OffsetY;
  motion.Velocity.Set(body.VX - body.W * (sine * armX + cosine * armY),
                      body.VY + body.W * (cosine * armX - sine * armY), 0.0);
  for (size_t i = 0; rigid.HasWheels() && i < rigid.Wheels.size(); ++i) {
    motion.WheelSpins[i] = supports[body.FirstSupport + i].Spin / rigid.WheelRadius;
  }
  rigid.Pressure = {body.SupportX, body.SupportY};
  PlaceRigidBody(rigid, pose, motion);
}

void StartUprightSubstep(SUprightBody& body, SUprightSupport* supports, const SRollGround& ground,
                         Real substep) {
  body.StartX = body.VX;
  body.StartY = body.VY;
  body.StartW = body.W;
  body.DriveX = body.DriveY = body.DriveTurn = 0.0;
  body.LowX = body.LowY = body.HighX = body.HighY = 0.0;
  body.Highest = 0.0;
  body.Lowest = HUGE_VAL;
  if (body.Kind == SUprightBody::EKind::PlanarDrive) {
    SetTargetOfPlanarDrive(body, substep);
    return;
  }
  SPlanarPose pose = body.Pose;
  const bool hasWheels = body.Kind == SUprightBody::EKind::Wheels;
  if (hasWheels && body.W != 0.0) {
    // wheels roll along their direction half-way through the substep
    const Real quarter = 0.25 * body.W * substep;
    Turn(pose, std::cos(quarter), std::sin(quarter));
  }
  const Real cosine = pose.HalfCos * pose.HalfCos - pose.HalfSin * pose.HalfSin;
  const Real sine = 2.0 * pose.HalfSin * pose.HalfCos;
  const Real ofFeet = hasWheels ? 0.0 : body.InverseInertia * AddUpSquares(body, supports);
  for (UInt32 i = 0; i < body.NumSupports; ++i) {
    SUprightSupport& support = supports[i];
    const Real armX = cosine * support.X - sine * support.Y;
    const Real armY = sine * support.X + cosine * support.Y;
    if (hasWheels) {
      support.EX = cosine;
      support.EY = sine;
      support.StartSpin = support.Spin;
      support.Motor = support.MotorLimit * substep;
      support.Own = (support.Target - support.StartSpin) * support.Rim;
    }
    support.Lever1 = armX * support.EY - armY * support.EX;
    support.Lever2 = armX * support.EX + armY * support.EY;
    // by the greatest eigenvalue of the changes of speeds for impulses of 1 at all together
    const Real turning = body.InverseInertia * (armX * armX + armY * armY);
    support.Share = hasWheels ? 0.5 / std::max(body.InverseMass, turning)
                              : kStepOfFeet / std::max(body.NumSupports * body.InverseMass, ofFeet);
    support.Grip = support.Load * body.Rigid->Friction * ground.Friction * substep;
  }
  if (hasWheels) {
    // the middle of the axle moves along the first direction only
    const SUprightSupport& left = supports[0];
    body.TargetW = (supports[1].Target - left.Target) / (supports[1].Lever1 - left.Lever1);
    const Real along = left.Target - body.TargetW * left.Lever1;
    const Real across = -body.TargetW * left.Lever2;
    body.TargetX = along * left.EX - across * left.EY;
    body.TargetY = along * left.EY + across * left.EX;
  }
  ApplyLastFriction(body, supports);
}

// Contacts act between their lowest and highest points, where they tilt the body least: all at one
// height if they have one in common.
bool BalanceUpright(SUprightBody& body, SUprightSupport* supports, const SRollGround& ground,
                    Real substep) {
  const Real changeX = body.Mass * (body.VX - body.StartX);
  const Real changeY = body.Mass * (body.VY - body.StartY);
  const bool isCommon = body.Highest <= body.Lowest && body.Lowest < HUGE_VAL;
  SPlace low{body.LowX, body.LowY};
  SPlace high{body.HighX, body.HighY};
  if (isCommon) {
    const SPlace side{changeX - body.DriveX, changeY - body.DriveY};
    low = {body.Highest * side.X, body.Highest * side.Y};
    high = {body.Lowest * side.X, body.Lowest * side.Y};
  }
  low = {low.X - body.Height * changeX, low.Y - body.Height * changeY};
  high = {high.X - body.Height * changeX, high.Y - body.Height * changeY};
  const SPlace range{high.X - low.X, high.Y - low.Y};
  const Real square = range.X * range.X + range.Y * range.Y;
  const Real share =
      square > 0.0 ? std::clamp(-(low.X * range.X + low.Y * range.Y) / square, 0.0, 1.0) : 0.0;
  const Real scale = 1.0 / (body.Mass * ground.Gravity * substep);
  const SPlace world{scale * (low.X + share * range.X), scale * (low.Y + share * range.Y)};
  const Real x = body.Cos() * world.X + body.Sin() * world.Y;
  const Real y = body.Cos() * world.Y - body.Sin() * world.X;
  if (!IsSupported(body, supports, x, y)) {
    return false;
  }
  body.SupportX = x;
  body.SupportY = y;
  if (body.Kind == SUprightBody::EKind::Object) {
    DistributeLoad(supports, body.NumSupports, ground.Gravity * body.Mass, x, y);
  }
  return true;
}

}  // namespace argos
