#include "text_view.h"

#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/simulator/loop_functions.h>
#include <argos3/core/simulator/simulator.h>
#include <argos3/core/simulator/space/space.h>
#include <argos3/core/utility/configuration/argos_configuration.h>

#include <iomanip>

using namespace argos;

void CTextView::Init(TConfigurationNode& t_tree) {
  std::string strFile;
  GetNodeAttribute(t_tree, "file", strFile);
  m_cFile.open(strFile.c_str());
  if (!m_cFile.good()) {
    THROW_ARGOSEXCEPTION("Can't write " << strFile);
  }
  m_cFile << std::setprecision(12);
}

void CTextView::Write() {
  CEntity::TVector& vecEntities = m_cSpace.GetRootEntityVector();
  for (size_t i = 0; i < vecEntities.size(); ++i) {
    CComposableEntity* pcEntity = dynamic_cast<CComposableEntity*>(vecEntities[i]);
    if (pcEntity == NULL || !pcEntity->HasComponent("body")) {
      continue;
    }
    const SAnchor& sOrigin = pcEntity->GetComponent<CEmbodiedEntity>("body").GetOriginAnchor();
    CRadians cZ, cY, cX;
    sOrigin.Orientation.ToEulerAngles(cZ, cY, cX);
    m_cFile << m_cSpace.GetSimulationClock() << " " << pcEntity->GetId() << " "
            << sOrigin.Position.GetX() << " " << sOrigin.Position.GetY() << " "
            << ToDegrees(cZ).GetValue() << std::endl;
  }
}

void CTextView::Execute() {
  Write();
  while (!m_cSimulator.IsExperimentFinished()) {
    m_cSimulator.UpdateSpace();
    Write();
  }
  m_cSimulator.GetLoopFunctions().PostExperiment();
}

void CTextView::Destroy() {
  m_cFile.close();
}

REGISTER_VISUALIZATION(CTextView, "text_view", "A researcher", "1.0", "Writes poses as text.",
                       "Writes the pose of each body after each tick.", "Usable");
