#include <argos3/plugins/simulator/physics_engines/dynamics2d/recorded_bodies.h>

#include <argos3/core/utility/configuration/argos_exception.h>

#include <cmath>

namespace argos {

namespace {

thread_local CBodyRecording* recordingOfThread = nullptr;

cpBody& NewBody(const char* function) {
  if (recordingOfThread == nullptr) {
    THROW_ARGOSEXCEPTION(function << "() is called outside of the constructor of a model: bodies "
                                     "are recorded only while an engine constructs one");
  }
  return recordingOfThread->AddBody();
}

// written so that NaN fails too
void RequireGreaterZero(const char* function, const char* what, Real value) {
  if (!(value > 0.0)) {
    THROW_ARGOSEXCEPTION(function << "(): " << what << " must be a number > 0, found " << value);
  }
}

void RequirePointer(const char* function, const char* what, const void* pointer) {
  if (pointer == nullptr) {
    THROW_ARGOSEXCEPTION(function << "(): the " << what << " is a null pointer");
  }
}

void RequireVertices(const char* function, int count) {
  if (count < 3) {
    THROW_ARGOSEXCEPTION(function << "(): a polygon has at least 3 vertices, found " << count);
  }
}

cpShape& NewShape(const char* function, cpBody* body, cpShape::EKind kind) {
  RequirePointer(function, "body", body);
  if (body->IsDescribed) {
    THROW_ARGOSEXCEPTION(function << "() is called after the constructor of the model: the engine "
                                     "has its shapes already");
  }
  body->Shapes.push_back(std::make_unique<cpShape>());
  cpShape& shape = *body->Shapes.back();
  shape.body = body;
  shape.Kind = kind;
  return shape;
}

// twice the signed area of a polygon, and its moment about the origin times 6 per unit of mass
struct SPolygonSums {
  Real TwiceArea = 0.0;
  Real Moment = 0.0;
};

// Source: moments of a triangle with a corner at the origin, summed over the sides.
SPolygonSums SumSides(int count, const cpVect* vertices, const cpVect& offset) {
  SPolygonSums sums;
  for (int i = 0; i < count; ++i) {
    const cpVect& from = vertices[i];
    const cpVect& to = vertices[(i + 1) % count];
    const CVector2 a(from.x + offset.x, from.y + offset.y);
    const CVector2 b(to.x + offset.x, to.y + offset.y);
    const Real cross = a.CrossProduct(b);
    sums.TwiceArea += cross;
    sums.Moment += cross * (a.DotProduct(a) + a.DotProduct(b) + b.DotProduct(b));
  }
  return sums;
}

}  // namespace

void detail::RefuseCall(const char* function) {
  THROW_ARGOSEXCEPTION(function << "() cannot be recorded: a model has bodies, shapes, and one "
                                   "control that moves it (CDynamics2DDifferentialSteeringControl "
                                   "or CDynamics2DVelocityControl)");
}

CBodyRecording::CScope::CScope(CBodyRecording& recording) : m_previous(recordingOfThread) {
  recordingOfThread = &recording;
}

CBodyRecording::CScope::~CScope() {
  recordingOfThread = m_previous;
}

cpBody& CBodyRecording::AddBody() {
  m_bodies.push_back(std::make_unique<cpBody>());
  return *m_bodies.back();
}

}  // namespace argos

cpBody* cpBodyNew(cpFloat mass, cpFloat moment) {
  argos::RequireGreaterZero("cpBodyNew", "the mass (kg)", mass);
  argos::RequireGreaterZero("cpBodyNew", "the moment (kg m^2)", moment);
  cpBody& body = argos::NewBody("cpBodyNew");
  body.m = mass;
  body.i = moment;
  return &body;
}

cpBody* cpBodyNewStatic() {
  cpBody& body = argos::NewBody("cpBodyNewStatic");
  body.m = body.i = std::numeric_limits<cpFloat>::infinity();
  body.IsStatic = true;
  return &body;
}

void cpBodySetAngle(cpBody* body, cpFloat angle) {
  argos::RequirePointer("cpBodySetAngle", "body", body);
  body->a = angle;
  body->rot = {std::cos(angle), std::sin(angle)};
}

cpBody* cpSpaceAddBody(cpSpace* /*space*/, cpBody* body) {
  argos::RequirePointer("cpSpaceAddBody", "body", body);
  body->IsInSpace = true;
  return body;
}

cpShape* cpSpaceAddShape(cpSpace* /*space*/, cpShape* shape) {
  argos::RequirePointer("cpSpaceAddShape", "shape", shape);
  shape->IsInSpace = true;
  return shape;
}

cpShape* cpSpaceAddStaticShape(cpSpace* space, cpShape* shape) {
  return cpSpaceAddShape(space, shape);
}

void cpSpaceRemoveBody(cpSpace* /*space*/, cpBody* body) {
  argos::RequirePointer("cpSpaceRemoveBody", "body", body);
  body->IsInSpace = body->IsDescribed;
}

void cpSpaceRemoveShape(cpSpace* /*space*/, cpShape* shape) {
  argos::RequirePointer("cpSpaceRemoveShape", "shape", shape);
  shape->IsInSpace = shape->body->IsDescribed;
}

void cpSpaceRemoveStaticShape(cpSpace* space, cpShape* shape) {
  cpSpaceRemoveShape(space, shape);
}

cpFloat cpMomentForCircle(cpFloat mass, cpFloat innerRadius, cpFloat outerRadius, cpVect offset) {
  return mass * (0.5 * (innerRadius * innerRadius + outerRadius * outerRadius) +
                 offset.x * offset.x + offset.y * offset.y);
}

cpFloat cpMomentForBox(cpFloat mass, cpFloat width, cpFloat height) {
  return mass * (width * width + height * height) / 12.0;
}

cpFloat cpMomentForPoly(cpFloat mass, int count, const cpVect* vertices, cpVect offset) {
  const argos::SPolygonSums sums = argos::SumSides(count, vertices, offset);
  argos::RequireGreaterZero("cpMomentForPoly", "the area", std::abs(sums.TwiceArea));
  return mass * sums.Moment / (6.0 * sums.TwiceArea);
}

cpShape* cpCircleShapeNew(cpBody* body, cpFloat radius, cpVect offset) {
  argos::RequireGreaterZero("cpCircleShapeNew", "the radius (m)", radius);
  cpShape& shape = argos::NewShape("cpCircleShapeNew", body, cpShape::EKind::Circle);
  shape.Radius = radius;
  shape.Offset = offset;
  return &shape;
}

cpShape* cpBoxShapeNew(cpBody* body, cpFloat width, cpFloat height) {
  argos::RequireGreaterZero("cpBoxShapeNew", "the width (m)", width);
  argos::RequireGreaterZero("cpBoxShapeNew", "the height (m)", height);
  cpShape& shape = argos::NewShape("cpBoxShapeNew", body, cpShape::EKind::Box);
  shape.Size = {width, height};
  return &shape;
}

cpShape* cpPolyShapeNew(cpBody* body, int count, const cpVect* vertices, cpVect offset) {
  argos::RequireVertices("cpPolyShapeNew", count);
  argos::RequireGreaterZero("cpPolyShapeNew", "the area",
                            std::abs(argos::SumSides(count, vertices, offset).TwiceArea));
  cpShape& shape = argos::NewShape("cpPolyShapeNew", body, cpShape::EKind::Polygon);
  for (int i = 0; i < count; ++i) {
    shape.Vertices.emplace_back(vertices[i].x + offset.x, vertices[i].y + offset.y);
  }
  return &shape;
}
