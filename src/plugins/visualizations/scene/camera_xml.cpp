#include <argos3/plugins/simulator/visualizations/scene/camera_xml.h>

#include <argos3/core/simulator/space/space.h>
#include <argos3/core/utility/configuration/single_element.h>
#include <argos3/core/utility/logging/argos_log.h>
#include <argos3/core/utility/math/eigen_bridge.h>
#include <argos3/core/utility/math/vector3.h>
#include <argos3/plugins/simulator/entities/value_checks.h>

#include <algorithm>

namespace argos {

namespace {

constexpr Real kDefaultFocalLength = 20.0;  // mm

// reaching an element marks it as read, so the warning about unused elements would not list it
void WarnOfUnknownElement(const TConfigurationNode& node, const std::string& parent,
                          const std::vector<std::string>& known) {
  LOGERR << "[WARNING] " << OwnerOf(node) << " has no meaning inside <" << parent
         << "> and is ignored" << DidYouMean(node.Value(), known) << std::endl;
}

void ReadPlacement(TConfigurationNode& node, CCameraTimeline& timeline) {
  // files written for older versions use idx
  const bool isOld = !NodeAttributeExists(node, "index") && NodeAttributeExists(node, "idx");
  UInt32 slot = 0;
  GetNodeAttribute(node, isOld ? "idx" : "index", slot);
  CVector3 position;
  CVector3 lookAt;
  GetNodeAttribute(node, "position", position);
  GetNodeAttribute(node, "look_at", lookAt);
  SCameraPlacement placement;
  placement.Position = ToEigen(position);
  placement.LookAt = ToEigen(lookAt);
  GetNodeAttributeOrDefault(node, "lens_focal_length", placement.FocalLength, kDefaultFocalLength);
  GetNodeAttributeOrDefault(node, "orthographic_height", placement.OrthographicHeight, 0.0);
  const Eigen::Vector3d forward = placement.LookAt - placement.Position;
  if (NodeAttributeExists(node, "up")) {
    CVector3 up;
    GetNodeAttribute(node, "up", up);
    placement.Up = ToEigen(up);
  } else if (forward.norm() > 0.0) {
    placement.Up = ComputeDefaultUp(forward);
    if (IsVertical(forward)) {
      LOGERR << "[WARNING] " << node.GetLocation()
             << ": the camera looks straight up or down and has no \"up\"; the world's +y is taken "
                "to be on its left; with up=\"0,1,0\", +x is on its right"
             << std::endl;
    }
  }
  try {
    // checks the placement
    const CCamera camera(placement, 1.0);
    timeline.SetPlacement(slot, placement);
  } catch (CARGoSException& ex) {
    THROW_ARGOSEXCEPTION_NESTED(node.GetLocation() << ": <placement> " << slot << " is not valid",
                                ex);
  }
}

void ReadPlacements(TConfigurationNode& node, CCameraTimeline& timeline) {
  TConfigurationNodeIterator child;
  for (child = child.begin(&node); child != child.end(); ++child) {
    if (child->Value() == "placement") {
      ReadPlacement(*child, timeline);
    } else {
      WarnOfUnknownElement(*child, "placements", {"placement"});
    }
  }
}

void ReadTimelineStep(TConfigurationNode& node, CCameraTimeline& timeline) {
  if (node.Value() == "interpolate") {
    timeline.InterpolateFromLastKeyframe();
  } else if (node.Value() == "keyframe") {
    UInt32 slot = 0;
    SKeyframe keyframe;
    GetNodeAttribute(node, "placement", slot);
    GetNodeAttribute(node, "step", keyframe.Step);
    keyframe.Placement = slot;
    timeline.AddKeyframe(keyframe);
  } else {
    WarnOfUnknownElement(node, "timeline", {"keyframe", "interpolate"});
  }
}

void ReadTimeline(TConfigurationNode& node, CCameraTimeline& timeline) {
  UInt32 loop = 0;
  GetNodeAttributeOrDefault(node, "loop", loop, 0u);
  timeline.SetLoop(loop);
  TConfigurationNodeIterator child;
  for (child = child.begin(&node); child != child.end(); ++child) {
    try {
      ReadTimelineStep(*child, timeline);
    } catch (CARGoSException& ex) {
      THROW_ARGOSEXCEPTION_NESTED(
          child->GetLocation() << ": <" << child->Value() << "> cannot be part of the timeline",
          ex);
    }
  }
}

// attributes of <camera> that describe placement 0
const std::vector<std::string>& GetViewAttributes() {
  static const std::vector<std::string> names = {
      "view", "fit", "projection", "margin", "lens_focal_length", "reach"};
  return names;
}

[[noreturn]] void ThrowAt(const TConfigurationNode& camera, const std::string& attribute,
                          const std::string& problem) {
  THROW_ARGOSEXCEPTION(camera.GetLocation()
                       << ": <camera>: attribute \"" << attribute << "\": " << problem);
}

// one of two words; true: the second one
bool ReadChoice(TConfigurationNode& camera, const std::string& attribute, const std::string& first,
                const std::string& second) {
  std::string text;
  GetNodeAttributeOrDefault(camera, attribute, text, first);
  if (text != first && text != second) {
    std::string problem = "\"" + text + "\" is not valid; choose \"";
    problem += first + "\" or \"";
    problem += second + "\"" + DidYouMean(text, {first, second});
    ThrowAt(camera, attribute, problem);
  }
  return text == second;
}

void ReadPositive(TConfigurationNode& camera, const std::string& attribute, double& value) {
  GetNodeAttributeOrDefault(camera, attribute, value, value);
  if (!(value > 0.0)) {
    ThrowAt(camera, attribute, "it must be positive");
  }
}

SView ReadView(TConfigurationNode& camera) {
  std::string name;
  GetNodeAttributeOrDefault(camera, "view", name, std::string("oblique"));
  SView view;
  try {
    view = SView::FromName(name);
  } catch (CARGoSException& ex) {
    THROW_ARGOSEXCEPTION_NESTED(
        camera.GetLocation() << ": <camera>: attribute \"view\" is not valid", ex);
  }
  view.IsOrthographic = ReadChoice(camera, "projection", "perspective", "orthographic");
  ReadPositive(camera, "lens_focal_length", view.FocalLength);
  return view;
}

void CheckFollowed(TConfigurationNode& camera, CSpace& space, const std::string& id) {
  if (FindPosition(space, id).has_value()) {
    return;
  }
  std::vector<std::string> known;
  for (const CEntity* root : space.GetRootEntityVector()) {
    known.push_back(root->GetId());
  }
  const bool exists = std::find(known.begin(), known.end(), id) != known.end();
  std::string problem = exists ? "this entity has no position: \"" : "there is no entity \"";
  problem += id + "\"";
  problem += DidYouMean(id, known);
  ThrowAt(camera, "follow", problem);
}

void ReadCameraAttributes(TConfigurationNode& camera, CSpace& space, SCameraSettings& settings) {
  if (NodeAttributeExists(camera, "follow")) {
    GetNodeAttribute(camera, "follow", settings.Followed);
    CheckFollowed(camera, space, settings.Followed);
  }
  if (settings.Timeline.IsSet(0)) {
    for (const std::string& name : GetViewAttributes()) {
      if (NodeAttributeExists(camera, name)) {
        ThrowAt(camera, name,
                "it describes placement 0, which is also given as a <placement>; keep one of both");
      }
    }
    return;
  }
  settings.View = ReadView(camera);
  settings.Fit = ReadChoice(camera, "fit", "arena", "contents") ? SCameraSettings::EFit::Contents
                                                                : SCameraSettings::EFit::Arena;
  GetNodeAttributeOrDefault(camera, "margin", settings.Margin, settings.Margin);
  if (!(settings.Margin >= 0.0)) {
    ThrowAt(camera, "margin", "it must not be negative");
  }
  if (NodeAttributeExists(camera, "reach") && settings.Followed.empty()) {
    ThrowAt(camera, "reach", "it needs \"follow\", the entity that it is around");
  }
  ReadPositive(camera, "reach", settings.Reach);
}

}  // namespace

void ReadCameraSettings(TConfigurationNode& visualization, CSpace& space,
                        SCameraSettings& settings) {
  ReadCamera(visualization, settings.Timeline);
  if (!NodeExists(visualization, "camera")) {
    settings.View = SView::FromName("oblique");
    return;
  }
  TConfigurationNode& camera = GetNode(visualization, "camera");
  ReadCameraAttributes(camera, space, settings);
  if (settings.View.has_value()) {
    // the projection is known, the rest when the first frame is drawn
    SCameraPlacement placement;
    placement.OrthographicHeight = settings.View->IsOrthographic ? 1.0 : 0.0;
    settings.Timeline.SetPlacement(0, placement);
  }
  try {
    settings.Timeline.CheckGlides();
  } catch (CARGoSException& ex) {
    THROW_ARGOSEXCEPTION_NESTED(camera.GetLocation() << ": <camera> is not valid", ex);
  }
}

void ReadCamera(TConfigurationNode& visualization, CCameraTimeline& timeline) {
  if (!NodeExists(visualization, "camera")) {
    return;
  }
  TConfigurationNode& camera = GetNode(visualization, "camera");
  TConfigurationNodeIterator child;
  for (child = child.begin(&camera); child != child.end(); ++child) {
    if (child->Value() == "placements") {
      ReadPlacements(*child, timeline);
    } else if (child->Value() == "placement") {
      ReadPlacement(*child, timeline);
    } else if (child->Value() == "timeline") {
      CheckIsSingle(*child);
      ReadTimeline(*child, timeline);
    } else {
      WarnOfUnknownElement(*child, "camera", {"placements", "timeline"});
    }
  }
}

}  // namespace argos
