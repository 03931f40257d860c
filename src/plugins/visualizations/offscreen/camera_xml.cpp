#include <argos3/plugins/simulator/visualizations/offscreen/camera_xml.h>

#include <argos3/core/utility/logging/argos_log.h>
#include <argos3/core/utility/math/eigen_bridge.h>
#include <argos3/core/utility/math/vector3.h>

namespace argos {

namespace {

constexpr Real kDefaultFocalLength = 20.0;  // mm

// reaching an element marks it as read, so the warning about unused elements would not list it
void WarnOfUnknownElement(const TConfigurationNode& node, const std::string& parent,
                          const std::vector<std::string>& known) {
  LOGERR << "[WARNING] " << node.GetLocation() << ": <" << node.Value()
         << "> has no meaning inside <" << parent << "> and is ignored"
         << DidYouMean(node.Value(), known) << std::endl;
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
                "to be on its left"
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

}  // namespace

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
      ReadTimeline(*child, timeline);
    } else {
      WarnOfUnknownElement(*child, "camera", {"placements", "timeline"});
    }
  }
}

}  // namespace argos
