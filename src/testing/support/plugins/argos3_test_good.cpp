// a plug-in library like a user's: it registers one controller and prints nothing
#include <argos3/core/control_interface/ci_controller.h>

using namespace argos;

class CTestGoodController : public CCI_Controller {
 public:
  void ControlStep() override { SetId(GetId() + "+"); }
};

REGISTER_CONTROLLER(CTestGoodController, "test_good_controller")
