#include "zeppelin.h"

void CZeppelin::ControlStep() {
  argos::LOG << GetId() << " is an " << Name() << std::endl;
}

REGISTER_CONTROLLER(CZeppelin, "zeppelin")
