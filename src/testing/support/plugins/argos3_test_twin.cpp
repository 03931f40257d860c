// a class with the name of one of argos3_test_good.cpp, under another label
#include <argos3/core/control_interface/ci_controller.h>

class CTestGoodController : public argos::CCI_Controller {
 public:
  void ControlStep() override { SetId(GetId() + "-"); }

#ifdef ARGOS_TEST_MEMBERS
  int Members[ARGOS_TEST_MEMBERS] = {};
#endif
};

REGISTER_CONTROLLER(CTestGoodController, ARGOS_TEST_LABEL)
