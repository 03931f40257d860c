#include <argos3/plugins/simulator/visualizations/scene/scene_builder.h>

#include <argos3/core/simulator/entity/anchor.h>
#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/controllable_entity.h>
#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/simulator/entity/existing_component.h>
#include <argos3/core/simulator/entity/floor_entity.h>
#include <argos3/core/simulator/entity/positional_entity.h>
#include <argos3/core/simulator/geometry/body_description.h>
#include <argos3/core/simulator/geometry/pose_grid.h>
#include <argos3/core/simulator/space/space.h>
#include <argos3/core/simulator/visualization/appearance.h>
#include <argos3/core/simulator/visualization/solid_part.h>
#include <argos3/core/utility/logging/argos_log.h>
#include <argos3/core/utility/math/eigen_bridge.h>
#include <argos3/plugins/simulator/entities/directional_led_equipped_entity.h>
#include <argos3/plugins/simulator/entities/led_equipped_entity.h>
#include <argos3/plugins/simulator/entities/light_entity.h>
#include <argos3/plugins/simulator/visualizations/scene/drawing_to_scene.h>
#include <argos3/plugins/simulator/visualizations/scene/led_glows.h>
#include <argos3/plugins/simulator/visualizations/scene/scene_parts.h>

#include <algorithm>
#include <cmath>

namespace argos {

namespace {

constexpr double kHighestFoot = 0.045;  // m; parts that begin above it hardly darken the ground
constexpr double kDetailShare = 0.35;  // share of the volume of an entity's largest part
constexpr double kUpright = 0.999;  // cosine of the angle between a part's axis and the vertical
constexpr int kMinGray = 160;  // robots in quarantine are at least as bright

// solids of robots in quarantine keep differences of brightness, but none of colour
CColor PaleGray(const CColor& color) {
  const int brightness = (color.GetRed() + color.GetGreen() + color.GetBlue()) / 3;
  const auto gray = static_cast<UInt8>(kMinGray + brightness / 4);
  return CColor(gray, gray, gray, color.GetAlpha());
}

// @return the volume of the box around a part, m^3; LEDs are not solids
double ComputeVolume(const SVisualPart& part) {
  if (part.Kind == SVisualPart::EKind::LED) {
    return 0.0;
  }
  return part.Size.GetX() * part.Size.GetY() * part.Size.GetZ();
}

// the solids of a body whose entity has no appearance
SAppearance MakeBodyAppearance(const SBodyDescription& body) {
  constexpr CColor kBody(150, 154, 160);
  SAppearance appearance;
  for (const SShapeDescription& shape : body.Shapes) {
    appearance.Parts.push_back(MakeSolidPart(shape, kBody));
  }
  return appearance;
}

void AddSolid(EMeshKind kind, const SPose& pose, const Eigen::Vector3d& scale, float param,
              const CColor& color, EMaterial material, bool isDetail, SScene& scene) {
  SMeshInstance instance = MakeSolid(pose, scale, color);
  instance.Material = material;
  instance.Param = param;
  instance.IsDetail = isDetail ? 1.0f : 0.0f;
  scene.OfKind(kind).push_back(instance);
}

SContactShadow MakeContactShadow(const SVisualPart& part, const SPose& pose) {
  SContactShadow shadow{};
  const double halfX = 0.5 * part.Size.GetX();
  const double halfY = 0.5 * part.Size.GetY();
  const double smaller = std::min(halfX, halfY);
  shadow.Center = {static_cast<float>(pose.Translation.x()),
                   static_cast<float>(pose.Translation.y())};
  shadow.AxisX = {static_cast<float>(pose.Rotation(0, 0)), static_cast<float>(pose.Rotation(1, 0))};
  shadow.HalfExtent = {static_cast<float>(halfX), static_cast<float>(halfY)};
  shadow.CornerRadius = part.Kind == SVisualPart::EKind::Box ? 0.0f : static_cast<float>(smaller);
  // the darkening reaches about as far as the solid is high or wide
  shadow.Blur =
      static_cast<float>(std::clamp(0.6 * std::min(part.Size.GetZ(), 2.0 * smaller), 0.01, 0.1));
  return shadow;
}

bool StandsOnGround(const SVisualPart& part, const SPose& pose) {
  const bool standing = part.Kind == SVisualPart::EKind::Box ||
                        part.Kind == SVisualPart::EKind::Cylinder ||
                        part.Kind == SVisualPart::EKind::Cone;
  return standing && pose.Rotation(2, 2) > kUpright &&
         std::abs(pose.Translation.z()) < kHighestFoot;
}

// set when a library is loaded, which runs nothing
CSceneBuilder::TDrawEntity& DrawEntity() {
  static CSceneBuilder::TDrawEntity draw;
  return draw;
}

constexpr SRgba kFreeRay = {36, 122, 196, 170};
constexpr SRgba kObstructedRay = {214, 52, 58, 230};
constexpr SRgba kHitPoint = {232, 40, 34, 255};
constexpr float kRayWidth = 1.4f;  // pixels
constexpr float kHitPointRadius = 0.004f;  // m
// m; a hit is computed from its ray, and both are rounded as all that views draw
constexpr double kOnRay = 4e-6;

// rounds to the grid of recordings, so that a replay draws the same
Eigen::Vector3d ToVisible(const CVector3& point) {
  return ToEigen(SnapToPoseGrid(point));
}

bool IsOnRay(const Eigen::Vector3d& point, const Eigen::Vector3d& start,
             const Eigen::Vector3d& end) {
  const double length = (end - start).norm();
  if (length == 0.0) {
    return (point - start).norm() <= kOnRay;
  }
  const Eigen::Vector3d direction = (end - start) / length;
  const double reach = (point - start).dot(direction);
  return reach >= -kOnRay && reach <= length + kOnRay &&
         (point - start - reach * direction).norm() <= kOnRay;
}

// Adds the rays that a robot's sensors recorded, and the points that they hit. An obstructed ray
// ends at its hit; it has its full length if no hit was recorded on it.
void AddRayLines(CControllableEntity& robot, SScene& scene) {
  const std::vector<CVector3>& hits = robot.GetIntersectionPoints();
  // sensors record hits in the order of their rays, but not one for each
  size_t next = 0;
  for (const auto& [obstructed, ray] : robot.GetCheckedRays()) {
    SLine line;
    const Eigen::Vector3d start = ToVisible(ray.GetStart());
    const Eigen::Vector3d end = ToVisible(ray.GetEnd());
    line.Start = ToFloats(start);
    line.End = ToFloats(end);
    line.Color = obstructed ? kObstructedRay : kFreeRay;
    line.Width = kRayWidth;
    if (obstructed && next < hits.size() && IsOnRay(ToVisible(hits[next]), start, end)) {
      line.End = ToFloats(ToVisible(hits[next]));
      ++next;
    }
    scene.Lines.push_back(line);
  }
  for (const CVector3& point : hits) {
    SGlow dot;
    dot.Position = ToFloats(ToVisible(point));
    dot.Radius = kHitPointRadius;
    dot.Color = kHitPoint;
    scene.Glows.push_back(dot);
  }
}

}  // namespace

void CSceneBuilder::SetDrawEntity(const TDrawEntity& draw) {
  DrawEntity() = draw;
}

void CSceneBuilder::Build(CSpace& space, SScene& scene) {
  scene.ClearContents();
  m_drawing.Begin(0, 0);
  const Eigen::Vector3d center = ToEigen(space.GetArenaCenter());
  const Eigen::Vector3d half = 0.5 * ToEigen(space.GetArenaSize());
  scene.ArenaMin = (center - half).head<2>();
  scene.ArenaMax = (center + half).head<2>();
  m_floor.Update(space);
  scene.Floor = m_floor.GetImage();
  for (CEntity* entity : space.GetRootEntityVector()) {
    AddEntity(*entity, scene);
  }
  AddDrawing(m_drawing, scene);
  if (m_showRays) {
    for (CControllableEntity* robot : space.GetControllableEntities()) {
      AddRayLines(*robot, scene);
    }
  }
}

void CSceneBuilder::WarnUnseen(const CEntity& entity) {
  const std::string type = entity.GetTypeDescription();
  // the floor has colours instead of a solid
  if (dynamic_cast<const CFloorEntity*>(&entity) != nullptr || !m_unseenTypes.insert(type).second) {
    return;
  }
  LOGERR << "[WARNING] pictures do not show \"" << entity.GetId() << "\" and other entities of its "
         << "type, <" << type
         << ">: its class has no GetAppearance(); only users' drawing functions "
         << "can draw them" << std::endl;
}

void CSceneBuilder::WarnOfSolids(const CEntity& entity) {
  const std::string type = entity.GetTypeDescription();
  if (m_unseenTypes.insert(type).second) {
    LOGERR << "[WARNING] pictures show the solids of \"" << entity.GetId() << "\" and other <"
           << type << ">: the class has no GetAppearance(), and its drawing, if there is any, "
           << "consists of OpenGL calls, which have no effect" << std::endl;
  }
}

void CSceneBuilder::AddEntity(CEntity& entity, SScene& scene) {
  static const SAppearance kNone;
  const SAppearance* appearance = entity.GetAppearance();
  SSubject subject;
  if (auto* composable = dynamic_cast<CComposableEntity*>(&entity)) {
    subject.Body = FindExistingComponent<CEmbodiedEntity>(*composable);
    const auto* const robot = FindExistingComponent<CControllableEntity>(*composable);
    subject.IsRobot = robot != nullptr;
    subject.IsQuarantined = robot != nullptr && robot->IsQuarantined();
    if (!subject.IsQuarantined) {
      subject.LEDs = FindExistingComponent<CLEDEquippedEntity>(*composable);
      if (subject.LEDs == nullptr) {
        subject.DirectionalLEDs = FindExistingComponent<CDirectionalLEDEquippedEntity>(*composable);
      }
    }
    if (subject.Body != nullptr) {
      subject.Pose = ToVisiblePose(subject.Body->GetOriginAnchor());
    }
  } else if (auto* positional = dynamic_cast<CPositionalEntity*>(&entity)) {
    subject.Pose = ToVisiblePose({positional->GetPosition(), positional->GetOrientation()});
    subject.Light = dynamic_cast<CLightEntity*>(&entity);
  }
  SAppearance solids;
  if (appearance == nullptr && subject.Body != nullptr &&
      subject.Body->GetBodyDescription() != nullptr) {
    solids = MakeBodyAppearance(*subject.Body->GetBodyDescription());
    appearance = &solids;
    subject.IsDrawn = DrawEntity() && DrawEntity()(entity, m_drawing);
    if (!subject.IsDrawn) {
      WarnOfSolids(entity);
    }
  } else if (appearance == nullptr) {
    WarnUnseen(entity);
    appearance = &kNone;
  }
  for (const SVisualPart& part : appearance->Parts) {
    const double volume = ComputeVolume(part);
    if (volume > subject.LargestVolume) {
      subject.LargestVolume = volume;
      subject.LargestSize = ToEigen(part.Size);
    }
  }
  AddModels(entity, subject, scene);
  for (const SVisualPart& part : appearance->Parts) {
    AddPart(part, subject, scene);
  }
  if (subject.LEDs != nullptr) {
    AddUndeclaredLEDs(*appearance, *subject.LEDs, scene);
  }
  if (subject.FootprintArea > 0.0) {
    scene.ContactShadows.push_back(subject.ContactShadow);
  }
  if (subject.IsRobot && subject.LargestVolume > 0.0) {
    scene.Markers.push_back(
        {ToFloats(subject.Pose * Eigen::Vector3d(0.0, 0.0, 0.5 * subject.LargestSize.z())),
         static_cast<float>(0.5 * subject.LargestSize.head<2>().maxCoeff())});
  }
}

bool CSceneBuilder::HasModel(const SSubject& subject, const std::string& anchor) {
  return subject.Models != nullptr &&
         std::any_of(subject.Models->begin(), subject.Models->end(),
                     [&anchor](const auto& model) { return model.first == anchor; });
}

void CSceneBuilder::AddModels(CEntity& entity, SSubject& subject, SScene& scene) const {
  // robots in quarantine lose their colours, which models have built in
  if (!m_findModels || subject.IsQuarantined) {
    return;
  }
  subject.Models = &m_findModels(entity.GetTypeDescription());
  for (const auto& [anchor, model] : *subject.Models) {
    const SPose pose = ComputeAnchorPose(anchor, subject.Body, subject.Pose);
    scene.Models.push_back({model, ToRows(pose, Eigen::Vector3d::Ones())});
  }
}

void CSceneBuilder::AddPart(const SVisualPart& part, SSubject& subject, SScene& scene) const {
  const SPose pose = ComputeAnchorPose(part.Anchor, subject.Body, subject.Pose) *
                     ToPose(part.Position, part.Orientation);
  const Eigen::Vector3d size = ToEigen(part.Size);
  if (subject.Light != nullptr) {
    scene.Glows.push_back(MakeLampGlow(pose, size.x(), part.Color, subject.Light->GetIntensity()));
    return;
  }
  const CColor color = subject.IsQuarantined ? PaleGray(part.Color) : part.Color;
  const bool isDetail = ComputeVolume(part) < kDetailShare * subject.LargestVolume;
  if (part.Kind != SVisualPart::EKind::LED && (subject.IsDrawn || HasModel(subject, part.Anchor))) {
    return;
  }
  switch (part.Kind) {
    case SVisualPart::EKind::Box:
      AddSolid(EMeshKind::Box, pose, size, 1.0f, color, part.Material, isDetail, scene);
      break;
    case SVisualPart::EKind::Cylinder:
      AddSolid(EMeshKind::Cylinder, pose, size, 1.0f, color, part.Material, isDetail, scene);
      break;
    case SVisualPart::EKind::Cone:
      AddSolid(EMeshKind::Cylinder, pose, size, 0.0f, color, part.Material, isDetail, scene);
      break;
    case SVisualPart::EKind::Sphere:
      AddSolid(EMeshKind::Sphere, pose, size, 1.0f, color, part.Material, isDetail, scene);
      break;
    case SVisualPart::EKind::Ring:
      AddSolid(EMeshKind::Ring, pose, Eigen::Vector3d(size.x(), size.y(), size.x()),
               static_cast<float>(size.z() / size.x()), color, part.Material, isDetail, scene);
      break;
    case SVisualPart::EKind::LED:
      scene.Glows.push_back(MakeLEDGlow(
          pose, part.Size.GetX(),
          subject.LEDs != nullptr ? GetLEDColorOrBlack(subject.LEDs, part.LED)
                                  : GetLEDColorOrBlack(subject.DirectionalLEDs, part.LED)));
      break;
  }
  const double area = size.x() * size.y();
  if (area > subject.FootprintArea && StandsOnGround(part, pose)) {
    subject.FootprintArea = area;
    subject.ContactShadow = MakeContactShadow(part, pose);
  }
}

}  // namespace argos
