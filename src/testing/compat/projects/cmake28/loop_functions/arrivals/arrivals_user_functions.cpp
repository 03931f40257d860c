#include "arrivals_user_functions.h"

CArrivalsUserFunctions::CArrivalsUserFunctions() {
  RegisterUserFunction<CArrivalsUserFunctions, CFootBotEntity>(&CArrivalsUserFunctions::Draw);
}

void CArrivalsUserFunctions::Draw(CFootBotEntity& c_entity) {
  DrawText(CVector3(0.0, 0.0, 0.3), c_entity.GetId().c_str());
}

REGISTER_QTOPENGL_USER_FUNCTIONS(CArrivalsUserFunctions, "arrivals_user_functions")
