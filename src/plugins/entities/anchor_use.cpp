#include <argos3/plugins/simulator/entities/anchor_use.h>

#include <argos3/core/simulator/entity/entity.h>

#include <algorithm>

namespace argos {

void MountOnAnchor(SAnchor& anchor, const CEntity& user) {
  if (anchor.Index == 0) {
    return;
  }
  if (user.IsEnabled()) {
    anchor.Enable();
  }
  // Reset() keeps this use of the anchor
  if (user.IsEnabledAtStart()) {
    ++anchor.InUseCountAtStart;
  }
}

UInt32 NumberOfAnchor(std::vector<SAnchor*>& anchors, SAnchor& anchor, const CEntity& user) {
  const auto known = std::find(anchors.begin(), anchors.end(), &anchor);
  if (known != anchors.end()) {
    return static_cast<UInt32>(known - anchors.begin());
  }
  anchors.push_back(&anchor);
  MountOnAnchor(anchor, user);
  return static_cast<UInt32>(anchors.size() - 1);
}

}  // namespace argos
