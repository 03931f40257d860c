#include <argos3/core/simulator/entity/anchor.h>

#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/simulator/entity/robots_code.h>

#include <algorithm>

namespace argos {

SAnchor::SAnchor(CEmbodiedEntity& body, const std::string& id, UInt32 index,
                 const CVector3& offsetPosition, const CQuaternion& offsetOrientation,
                 const CVector3& position, const CQuaternion& orientation)
    : SBodyPose{position, orientation},
      Body(body),
      Id(id),
      Index(index),
      OffsetPosition(offsetPosition),
      OffsetOrientation(offsetOrientation) {}

void SAnchor::Enable() {
  CRobotsCode::CheckOwn(Body, "SAnchor::Enable()");
  if (InUseCount++ == 0) {
    auto& enabled = Body.m_vecEnabledAnchors;
    enabled.push_back(this);
    // sorted by index, independent of the order of Enable() calls
    std::ranges::sort(enabled, {}, &SAnchor::Index);
    // the pose was not kept current so far
    if (Index != 0) {
      FollowOrigin();
    }
  }
}

void SAnchor::Disable() {
  CRobotsCode::CheckOwn(Body, "SAnchor::Disable()");
  if (InUseCount == 0) {
    return;
  }
  if (Index == 0 && InUseCount == 1) {
    THROW_ARGOSEXCEPTION("the origin anchor of body \"" << Body.GetContext() << Body.GetId()
                                                        << "\" cannot be disabled");
  }
  if (--InUseCount == 0) {
    auto& enabled = Body.m_vecEnabledAnchors;
    enabled.erase(std::find(enabled.begin(), enabled.end(), this));
  }
}

void SAnchor::ReturnToStart() {
  while (InUseCount < InUseCountAtStart) {
    Enable();
  }
  // the origin anchor is always in use
  const UInt32 least = Index == 0 ? std::max<UInt32>(InUseCountAtStart, 1) : InUseCountAtStart;
  while (InUseCount > least) {
    Disable();
  }
}

void SAnchor::FollowOrigin() {
  const SAnchor& origin = Body.GetOriginAnchor();
  Position = OffsetPosition;
  Position.Rotate(origin.Orientation);
  Position += origin.Position;
  Orientation = origin.Orientation * OffsetOrientation;
}

SBodyPose ComputeVisiblePose(const SAnchor& anchor) {
  if (anchor.InUseCount > 0) {
    return anchor;
  }
  return Compose(anchor.Body.GetOriginAnchor(), {anchor.OffsetPosition, anchor.OffsetOrientation});
}

}  // namespace argos
