#include "zeppelin.h"

class CAerostat : public CZeppelin {
 public:
  const char* Name() const override { return "aerostat"; }
};

REGISTER_CONTROLLER(CAerostat, "aerostat")
