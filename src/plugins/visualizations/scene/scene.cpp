#include <argos3/plugins/simulator/visualizations/scene/scene.h>

namespace argos {

void SScene::ClearContents() {
  for (std::vector<SMeshInstance>& instances : Meshes) {
    instances.clear();
  }
  Models.clear();
  Glows.clear();
  Markers.clear();
  Lines.clear();
  ContactShadows.clear();
  Flats.clear();
  TranslucentFlats.clear();
  Labels.clear();
  OverlayFlats.clear();
  OverlayLabels.clear();
}

}  // namespace argos
