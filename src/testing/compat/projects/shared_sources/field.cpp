#include "field.h"

#include "gatherer.h"

#include <iostream>

using namespace argos;

int CField::NumFields = 0;

void CField::Init(TConfigurationNode&) {
  ++NumFields;
  for (auto& it : GetSpace().GetEntitiesByType("controller")) {
    CControllableEntity& cEntity = *any_cast<CControllableEntity*>(it.second);
    dynamic_cast<CGatherer&>(cEntity.GetController()).SetField(*this);
  }
}

void CField::PostExperiment() {
  // the log is written when it is flushed, after what is printed at once
  LOG << m_unReports << ", " << NumFields << std::endl;
  std::cout << "reports of robots, fields" << std::endl;
}

REGISTER_LOOP_FUNCTIONS(CField, "field")
