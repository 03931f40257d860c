#include "zeppelin.h"

class CAirship : public CZeppelin {
 public:
  const char* Name() const override { return "airship"; }
};

REGISTER_CONTROLLER(CAirship, "airship")
