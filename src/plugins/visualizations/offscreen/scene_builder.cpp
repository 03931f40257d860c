#include <argos3/plugins/simulator/visualizations/offscreen/scene_builder.h>

#include <argos3/core/simulator/entity/anchor.h>
#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/controllable_entity.h>
#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/simulator/entity/existing_component.h>
#include <argos3/core/simulator/entity/floor_entity.h>
#include <argos3/core/simulator/entity/positional_entity.h>
#include <argos3/core/simulator/geometry/pose_grid.h>
#include <argos3/core/simulator/space/space.h>
#include <argos3/core/simulator/visualization/appearance.h>
#include <argos3/core/utility/logging/argos_log.h>
#include <argos3/core/utility/math/eigen_bridge.h>
#include <argos3/plugins/simulator/entities/led_equipped_entity.h>
#include <argos3/plugins/simulator/entities/light_entity.h>

#include <algorithm>
#include <cmath>

namespace argos {

namespace {

constexpr char kOriginAnchor[] = "origin";
constexpr float kLEDHaloScale = 3.6f;  // radii
constexpr float kLightHaloScale = 4.5f;  // radii
constexpr SRgba kDarkLED = {46, 48, 54, 255};
constexpr SRgba kFreeRay = {36, 122, 196, 170};
constexpr SRgba kObstructedRay = {214, 52, 58, 230};
constexpr SRgba kHitPoint = {232, 40, 34, 255};
constexpr float kRayWidth = 1.4f;  // pixels
constexpr float kHitPointRadius = 0.004f;  // m
constexpr double kHighestFoot = 0.045;  // m; parts that begin above it hardly darken the ground
constexpr double kDetailShare = 0.35;  // of the volume of an entity's largest part
constexpr double kUpright = 0.999;  // cosine of the angle between a part's axis and the vertical
constexpr int kLeastGray = 160;  // of robots in quarantine
constexpr int kMaxFloorSide = 8192;  // pixels, of the texture

// on the grid, so that a replay of a recording draws the same
SPose ToVisiblePose(const SBodyPose& pose) {
  const SBodyPose snapped = SnapToPoseGrid(pose);
  return ToPose(snapped.Position, snapped.Orientation);
}

// the frame of a part
SPose ComputeAnchorPose(const SVisualPart& part, CEmbodiedEntity* body, const SPose& origin) {
  if (body == nullptr || part.Anchor == kOriginAnchor) {
    return origin;
  }
  const auto found = body->GetAnchors().find(part.Anchor);
  return found == body->GetAnchors().end() ? origin
                                           : ToVisiblePose(ComputeVisiblePose(*found->second));
}

// of the solids of robots in quarantine: differences of brightness are left, but none of colour
CColor PaleGray(const CColor& color) {
  const int brightness = (color.GetRed() + color.GetGreen() + color.GetBlue()) / 3;
  const auto gray = static_cast<UInt8>(kLeastGray + brightness / 4);
  return CColor(gray, gray, gray, color.GetAlpha());
}

// of the box around a part, m^3; LEDs are not solids
double ComputeVolume(const SVisualPart& part) {
  if (part.Kind == SVisualPart::EKind::LED) {
    return 0.0;
  }
  return part.Size.GetX() * part.Size.GetY() * part.Size.GetZ();
}

void AddSolid(EMeshKind kind, const SPose& pose, const Eigen::Vector3d& scale, float param,
              const CColor& color, bool isDetail, SScene& scene) {
  SMeshInstance instance = MakeSolid(pose, scale, color);
  instance.Param = param;
  instance.IsDetail = isDetail ? 1.0f : 0.0f;
  scene.OfKind(kind).push_back(instance);
}

void AddLED(const SVisualPart& part, const SPose& pose, const CLEDEquippedEntity* leds,
            SScene& scene) {
  SGlow glow;
  glow.Position = ToFloats(pose.Translation);
  glow.Radius = static_cast<float>(0.5 * part.Size.GetX());
  glow.Color = kDarkLED;
  if (leds != nullptr && part.LED < leds->GetNumLEDs()) {
    const CColor& color = leds->GetLEDColor(part.LED);
    if (color != CColor()) {
      glow.Color = ToRgba(color);
      glow.HaloScale = kLEDHaloScale;
    }
  }
  scene.Glows.push_back(glow);
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

int ComputeFloorSide(double length, UInt32 pixelsPerMeter) {
  const double pixels = std::ceil(length * std::max<UInt32>(pixelsPerMeter, 1) - 1e-6);
  return static_cast<int>(std::clamp<double>(pixels, 1.0, kMaxFloorSide));
}

}  // namespace

void CSceneBuilder::Build(CSpace& space, SScene& scene) {
  scene.ClearContents();
  const Eigen::Vector3d center = ToEigen(space.GetArenaCenter());
  const Eigen::Vector3d half = 0.5 * ToEigen(space.GetArenaSize());
  scene.ArenaMin = (center - half).head<2>();
  scene.ArenaMax = (center + half).head<2>();
  AddFloor(space, scene.Floor);
  for (CEntity* entity : space.GetRootEntityVector()) {
    AddEntity(*entity, scene);
  }
  if (m_showRays) {
    for (CControllableEntity* robot : space.GetControllableEntities()) {
      AddRays(*robot, scene);
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

void CSceneBuilder::AddEntity(CEntity& entity, SScene& scene) {
  const SAppearance* appearance = entity.GetAppearance();
  if (appearance == nullptr) {
    WarnUnseen(entity);
    return;
  }
  SSubject subject;
  if (auto* composable = dynamic_cast<CComposableEntity*>(&entity)) {
    subject.Body = FindExistingComponent<CEmbodiedEntity>(*composable);
    const auto* const robot = FindExistingComponent<CControllableEntity>(*composable);
    subject.IsQuarantined = robot != nullptr && robot->IsQuarantined();
    if (!subject.IsQuarantined) {
      subject.LEDs = FindExistingComponent<CLEDEquippedEntity>(*composable);
    }
    if (subject.Body != nullptr) {
      subject.Pose = ToVisiblePose(subject.Body->GetOriginAnchor());
    }
  } else if (auto* positional = dynamic_cast<CPositionalEntity*>(&entity)) {
    subject.Pose = ToVisiblePose({positional->GetPosition(), positional->GetOrientation()});
    subject.IsLight = dynamic_cast<CLightEntity*>(&entity) != nullptr;
  }
  for (const SVisualPart& part : appearance->Parts) {
    subject.LargestVolume = std::max(subject.LargestVolume, ComputeVolume(part));
  }
  for (const SVisualPart& part : appearance->Parts) {
    AddPart(part, subject, scene);
  }
  if (subject.FootprintArea > 0.0) {
    scene.ContactShadows.push_back(subject.ContactShadow);
  }
}

void CSceneBuilder::AddPart(const SVisualPart& part, SSubject& subject, SScene& scene) const {
  const SPose pose =
      ComputeAnchorPose(part, subject.Body, subject.Pose) * ToPose(part.Position, part.Orientation);
  const Eigen::Vector3d size = ToEigen(part.Size);
  if (subject.IsLight) {
    const float radius = static_cast<float>(0.5 * size.x());
    scene.Glows.push_back(
        {ToFloats(pose.Translation), radius, ToRgba(part.Color), kLightHaloScale});
    return;
  }
  const CColor color = subject.IsQuarantined ? PaleGray(part.Color) : part.Color;
  const bool isDetail = ComputeVolume(part) < kDetailShare * subject.LargestVolume;
  switch (part.Kind) {
    case SVisualPart::EKind::Box:
      AddSolid(EMeshKind::Box, pose, size, 1.0f, color, isDetail, scene);
      break;
    case SVisualPart::EKind::Cylinder:
      AddSolid(EMeshKind::Cylinder, pose, size, 1.0f, color, isDetail, scene);
      break;
    case SVisualPart::EKind::Cone:
      AddSolid(EMeshKind::Cylinder, pose, size, 0.0f, color, isDetail, scene);
      break;
    case SVisualPart::EKind::Sphere:
      AddSolid(EMeshKind::Sphere, pose, size, 1.0f, color, isDetail, scene);
      break;
    case SVisualPart::EKind::Ring:
      AddSolid(EMeshKind::Ring, pose, Eigen::Vector3d(size.x(), size.y(), size.x()),
               static_cast<float>(size.z() / size.x()), color, isDetail, scene);
      break;
    case SVisualPart::EKind::LED:
      AddLED(part, pose, subject.LEDs, scene);
      break;
  }
  const double area = size.x() * size.y();
  if (area > subject.FootprintArea && StandsOnGround(part, pose)) {
    subject.FootprintArea = area;
    subject.ContactShadow = MakeContactShadow(part, pose);
  }
}

void CSceneBuilder::AddFloor(CSpace& space, SFloorImage& image) const {
  if (!space.HasFloorEntity()) {
    image.Width = 0;
    image.Height = 0;
    return;
  }
  CFloorEntity& floor = space.GetFloorEntity();
  if (image.Width > 0 && !floor.HasChanged()) {
    return;
  }
  const CVector3& size = space.GetArenaSize();
  const CVector3 corner = space.GetArenaCenter() - size * 0.5;
  image.Width = ComputeFloorSide(size.GetX(), floor.GetPixelsPerMeter());
  image.Height = ComputeFloorSide(size.GetY(), floor.GetPixelsPerMeter());
  image.Pixels.resize(4 * static_cast<std::size_t>(image.Width) *
                      static_cast<std::size_t>(image.Height));
  std::uint8_t* pixel = image.Pixels.data();
  for (int row = 0; row < image.Height; ++row) {
    const Real y = corner.GetY() + (row + 0.5) * size.GetY() / image.Height;
    for (int column = 0; column < image.Width; ++column, pixel += 4) {
      const Real x = corner.GetX() + (column + 0.5) * size.GetX() / image.Width;
      const CColor color = floor.GetColorAtPoint(x, y);
      pixel[0] = color.GetRed();
      pixel[1] = color.GetGreen();
      pixel[2] = color.GetBlue();
      pixel[3] = 255;
    }
  }
  ++image.Version;
  floor.ClearChanged();
}

void CSceneBuilder::AddRays(CControllableEntity& robot, SScene& scene) const {
  for (const auto& [obstructed, ray] : robot.GetCheckedRays()) {
    SLine line;
    line.Start = ToFloats(ToEigen(SnapToPoseGrid(ray.GetStart())));
    line.End = ToFloats(ToEigen(SnapToPoseGrid(ray.GetEnd())));
    line.Color = obstructed ? kObstructedRay : kFreeRay;
    line.Width = kRayWidth;
    scene.Lines.push_back(line);
  }
  for (const CVector3& point : robot.GetIntersectionPoints()) {
    SGlow dot;
    dot.Position = ToFloats(ToEigen(SnapToPoseGrid(point)));
    dot.Radius = kHitPointRadius;
    dot.Color = kHitPoint;
    scene.Glows.push_back(dot);
  }
}

}  // namespace argos
