#ifndef ARGOS3_PLUGINS_VISUALIZATIONS_POVRAY_POVRAY_MODELS_H
#define ARGOS3_PLUGINS_VISUALIZATIONS_POVRAY_POVRAY_MODELS_H

#include <argos3/plugins/simulator/visualizations/scene/scene_builder.h>

#include <map>
#include <string>
#include <vector>

namespace argos {

/** The models of types of entities, looked up when a type first appears; see CPovrayModel. */
class CPovrayModels {
 public:
  /** @return valid as long as this object. */
  const CSceneBuilder::TModels& Find(const std::string& type);

  /** Texts by number. */
  const std::vector<std::string>& GetObjects() const { return m_objects; }

 private:
  std::map<std::string, CSceneBuilder::TModels> m_models;  // by type; empty: it has none
  std::vector<std::string> m_objects;
};

}  // namespace argos

#endif
