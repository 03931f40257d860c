#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/simulator/geometry/body_description.h>
#include <argos3/core/simulator/physics_engine/recorded_body.h>
#include <argos3/core/simulator/simulator.h>
#include <argos3/core/utility/plugins/factory.h>
#include <argos3/core/utility/text/string_utilities.h>
#include <argos3/plugins/simulator/entities/wheeled_entity.h>
#include <argos3/plugins/simulator/physics_engines/dynamics2d/dynamics2d_engine.h>
#include <argos3/plugins/simulator/physics_engines/dynamics2d/dynamics2d_gripping.h>
#include <argos3/plugins/simulator/physics_engines/dynamics2d/dynamics2d_model.h>
#include <argos3/plugins/simulator/physics_engines/dynamics2d/dynamics2d_velocity_control.h>

#include <cmath>
#include <memory>
#include <utility>

namespace argos {

namespace {

std::string NameOf(const CDynamics2DModel& model) {
  return "the model " + DemangledName(typeid(model)) + " of \"" +
         model.GetEmbodiedEntity().GetRootEntity().GetId() + "\"";
}

CVector3 Raised(const CVector2& point) {
  return CVector3(point.GetX(), point.GetY(), 0.0);
}

}  // namespace

/** Turns the record of a model into a description. */
class CModelDescriber {
 public:
  explicit CModelDescriber(const CDynamics2DModel& model)
      : m_model(model), m_isMovable(model.GetEmbodiedEntity().IsMovable()) {}

  std::shared_ptr<const SBodyDescription> Describe() {
    if (m_model.m_parts.empty()) {
      THROW_ARGOSEXCEPTION(NameOf(m_model) << " has no body: call SetBody() or AddBody() in its "
                                              "constructor");
    }
    Real inertia = 0.0;
    for (const CDynamics2DModel::SPart& part : m_model.m_parts) {
      AddPart(part);
      inertia += part.Body->i +
                 part.Body->m * (part.Offset.x * part.Offset.x + part.Offset.y * part.Offset.y);
    }
    if (m_body.Shapes.empty()) {
      THROW_ARGOSEXCEPTION(NameOf(m_model)
                           << " has no shape: call cpSpaceAddShape() in its constructor");
    }
    m_body.IsRecorded = true;
    if (m_isMovable) {
      m_body.PlanarInertia = inertia;
    } else {
      m_body.Mass = 0.0;
    }
    m_model.Describe(m_body);
    if (m_body.Drive) {
      m_body.Drive->WheelRadius = FindWheelRadius();
    }
    return std::make_shared<const SBodyDescription>(std::move(m_body));
  }

 private:
  void AddPart(const CDynamics2DModel::SPart& part) {
    const cpBody& body = *part.Body;
    if (body.IsStatic && m_isMovable) {
      THROW_ARGOSEXCEPTION(NameOf(m_model)
                           << " has a body of cpBodyNewStatic(), but the entity is movable: use "
                              "cpBodyNew(), or make the entity immovable");
    }
    m_body.Mass += body.m;
    for (const auto& shape : body.Shapes) {
      if (shape->Gripper != nullptr) {
        AddGripper(*shape, part);
      } else if (shape->IsInSpace) {
        AddSolid(*shape, part);
      }
      m_body.Grippable = m_body.Grippable || shape->Grippable != nullptr;
    }
    if (body.Control != nullptr && m_isMovable) {
      AddControl(*body.Control, part);
    }
  }

  void AddControl(const CDynamics2DVelocityControl& control, const CDynamics2DModel::SPart& part) {
    if (m_body.HasDrive()) {
      THROW_ARGOSEXCEPTION(NameOf(m_model) << " calls AttachTo() for two bodies: its bodies are "
                                              "joined and cannot move differently");
    }
    if (part.Offset.x != 0.0 || part.Offset.y != 0.0 || part.Angle != 0.0) {
      THROW_ARGOSEXCEPTION(NameOf(m_model)
                           << " calls AttachTo() for a body with an offset: a drive "
                              "moves the body at the origin");
    }
    control.Describe(m_body);
  }

  void AddSolid(const cpShape& shape, const CDynamics2DModel::SPart& part) {
    if (shape.sensor != 0) {
      THROW_ARGOSEXCEPTION(NameOf(m_model)
                           << " adds a sensor with cpSpaceAddShape(): engines have sensing shapes "
                              "only for grippers (CDynamics2DGripper)");
    }
    SShapeDescription solid;
    CVector2 offset;
    switch (shape.Kind) {
      case cpShape::EKind::Circle:
        solid = SShapeDescription::Cylinder(shape.Radius, part.Height);
        offset.Set(shape.Offset.x, shape.Offset.y);
        break;
      case cpShape::EKind::Box:
        solid = SShapeDescription::Box(CVector3(shape.Size.x, shape.Size.y, part.Height));
        break;
      case cpShape::EKind::Polygon:
        solid = DescribePolygon(shape.Vertices, part.Height);
        offset = CVector2(solid.Offset.GetX(), solid.Offset.GetY());
        break;
    }
    solid.Offset = Raised(Locate(offset, part));
    if (part.Angle != 0.0) {
      solid.Orientation.FromAngleAxis(CRadians(part.Angle), CVector3::Z);
    }
    m_body.Shapes.push_back(solid);
  }

  SShapeDescription DescribePolygon(const std::vector<CVector2>& vertices, Real height) const {
    try {
      return SShapeDescription::Prism(vertices, height);
    } catch (std::exception& error) {
      THROW_ARGOSEXCEPTION_NESTED(NameOf(m_model) << ": the shape of cpPolyShapeNew() is no solid",
                                  error);
    }
  }

  void AddGripper(const cpShape& shape, const CDynamics2DModel::SPart& part) {
    if (shape.Kind != cpShape::EKind::Circle) {
      THROW_ARGOSEXCEPTION(NameOf(m_model) << ": the shape of a CDynamics2DGripper must be one of "
                                              "cpCircleShapeNew()");
    }
    const CGripperEquippedEntity& entity = shape.Gripper->GetGripperEntity();
    SGripperDescription gripper;
    gripper.Offset = Raised(Locate(CVector2(shape.Offset.x, shape.Offset.y), part));
    gripper.Offset.SetZ(entity.GetInitOffset().GetZ());
    gripper.Direction = entity.GetInitDirection();
    gripper.SensorRadius = shape.Radius;
    m_body.Gripper = gripper;
  }

  static CVector2 Locate(CVector2 point, const CDynamics2DModel::SPart& part) {
    if (part.Angle != 0.0) {
      point.Rotate(CRadians(part.Angle));
    }
    return point + CVector2(part.Offset.x, part.Offset.y);
  }

  // reads the entity's wheels, if it has any
  Real FindWheelRadius() const {
    auto& root = static_cast<CComposableEntity&>(m_model.m_cEmbodiedEntity.GetRootEntity());
    if (root.HasComponent("wheels")) {
      const Real radius = root.GetComponent<CWheeledEntity>("wheels").GetWheelRadius(0);
      if (radius > 0.0) {
        return radius;
      }
    }
    return m_body.AssumeWheelRadius();
  }

  const CDynamics2DModel& m_model;
  bool m_isMovable;
  SBodyDescription m_body;
};

/** A user's model, and the bodies that it has recorded. */
class CRecordedDynamics2DBody : public CRecordedBody {
 public:
  CRecordedDynamics2DBody(std::shared_ptr<CDynamics2DEngine> standIn, CBodyRecording recording,
                          std::unique_ptr<CDynamics2DModel> model)
      : m_standIn(std::move(standIn)),
        m_recording(std::move(recording)),
        m_model(std::move(model)),
        m_description(CModelDescriber(*m_model).Describe()) {
    const CEmbodiedEntity& entity = m_model->GetEmbodiedEntity();
    for (const CDynamics2DModel::SPart& part : m_model->m_parts) {
      part.Body->IsDescribed = true;
      part.Body->Drive = entity.IsMovable() ? part.Body->Control : nullptr;
      m_control = part.Body->Drive != nullptr ? part.Body->Drive : m_control;
      for (const auto& shape : part.Body->Shapes) {
        m_gripper = shape->Gripper != nullptr ? shape->Gripper : m_gripper;
        m_grippable = shape->Grippable != nullptr ? shape->Grippable : m_grippable;
      }
    }
    m_model->PlaceParts(entity.GetOriginAnchor().Position, entity.GetOriginAnchor().Orientation);
  }

  std::shared_ptr<const SBodyDescription> GetDescription() const override { return m_description; }
  CDriveSource GetDrive() const override {
    return m_control != nullptr ? m_control->GetSource() : CDriveSource();
  }

  void StartTick(Real tick) override {
    m_model->UpdateFromEntityStatus();
    if (m_control != nullptr) {
      m_control->UpdateCommand(tick);
    }
  }

  void FinishTick(Real tick) override {
    const SAnchor& origin = m_model->GetEmbodiedEntity().GetOriginAnchor();
    for (CDynamics2DModel::SPart& part : m_model->m_parts) {
      // negative, until the new place is known
      part.Body->v = {-part.Body->p.x, -part.Body->p.y};
      part.Body->w = -part.Body->a;
    }
    m_model->PlaceParts(origin.Position, origin.Orientation);
    for (CDynamics2DModel::SPart& part : m_model->m_parts) {
      cpBody& body = *part.Body;
      body.v = {(body.v.x + body.p.x) / tick, (body.v.y + body.p.y) / tick};
      body.w = std::remainder(body.w + body.a, 2.0 * ARGOS_PI) / tick;
    }
    if (m_gripper != nullptr) {
      m_gripper->SetGrippee(FindGrippee());
    }
    m_model->UpdateEntityStatus();
  }

  void MoveTo(const CVector3& position, const CQuaternion& orientation) override {
    m_model->MoveTo(position, orientation);
  }
  void Reset() override { m_model->Reset(); }

 private:
  // the grippable that describes what the gripper holds, if a user's model does
  CDynamics2DGrippable* FindGrippee() const {
    CGripperEquippedEntity& entity = m_gripper->GetGripperEntity();
    if (!entity.IsGripping() || entity.GetGrippedEntity().GetPhysicsModelsNum() == 0) {
      return nullptr;
    }
    auto* const held =
        dynamic_cast<CDescribedBodyModel*>(&entity.GetGrippedEntity().GetPhysicsModel(size_t(0)));
    auto* const recorded =
        held != nullptr ? dynamic_cast<CRecordedDynamics2DBody*>(held->GetRecordedBody()) : nullptr;
    return recorded != nullptr ? recorded->m_grippable : nullptr;
  }

  std::shared_ptr<CDynamics2DEngine> m_standIn;  // null if the model is in its own engine
  CBodyRecording m_recording;  // outlives the model
  std::unique_ptr<CDynamics2DModel> m_model;
  std::shared_ptr<const SBodyDescription> m_description;
  CDynamics2DVelocityControl* m_control = nullptr;  // of the model
  CDynamics2DGripper* m_gripper = nullptr;  // of the model
  CDynamics2DGrippable* m_grippable = nullptr;  // of the model
};

/**
 * Describes the bodies of entities for which users have registered a model for dynamics2d
 * (REGISTER_STANDARD_DYNAMICS2D_OPERATIONS_ON_ENTITY), in every engine.
 *
 * A model needs an engine of its type. In other engines, one that has no bodies stands in.
 */
class CDynamics2DRecorder : public CBodyRecorder {
 public:
  std::unique_ptr<CRecordedBody> Record(CDescribedBodyEngine& engine, CEntity& root) override;

 private:
  // made when it is necessary; models refer to it
  std::shared_ptr<CDynamics2DEngine> m_standIn;
};

std::unique_ptr<CRecordedBody> CDynamics2DRecorder::Record(CDescribedBodyEngine& engine,
                                                           CEntity& root) {
  if (!CDynamics2DEngine::HasUserModel(root)) {
    return nullptr;
  }
  std::shared_ptr<CDynamics2DEngine> standIn;
  auto* own = dynamic_cast<CDynamics2DEngine*>(&engine);
  if (own == nullptr) {
    if (m_standIn == nullptr) {
      const CSimulator::CScope scope(engine.GetContext().Simulator);
      m_standIn = std::make_shared<CDynamics2DEngine>();
      m_standIn->SetId(engine.GetId());
    }
    standIn = m_standIn;
    own = standIn.get();
  }
  CBodyRecording recording;
  std::unique_ptr<CDynamics2DModel> model;
  {
    const CBodyRecording::CScope scope(recording);
    model = own->MakeUserModel(root);
  }
  return std::make_unique<CRecordedDynamics2DBody>(std::move(standIn), std::move(recording),
                                                   std::move(model));
}

REGISTER_BODY_RECORDER(CDynamics2DRecorder, "dynamics2d",
                       "Describes bodies by users' models for dynamics2d.")

}  // namespace argos
