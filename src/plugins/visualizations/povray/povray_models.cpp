#include <argos3/plugins/simulator/visualizations/povray/povray_models.h>

#include <argos3/core/simulator/visualization/povray_model.h>

#include <memory>

namespace argos {

const CSceneBuilder::TModels& CPovrayModels::Find(const std::string& type) {
  const auto [found, isNew] = m_models.try_emplace(type);
  if (isNew && CFactory<CPovrayModel>::Exists(type)) {
    const std::unique_ptr<CPovrayModel> model(CFactory<CPovrayModel>::New(type));
    for (const CPovrayModel::SPart& part : model->MakeParts()) {
      found->second.emplace_back(part.Anchor, m_objects.size());
      m_objects.push_back(part.Object);
    }
  }
  return found->second;
}

}  // namespace argos
