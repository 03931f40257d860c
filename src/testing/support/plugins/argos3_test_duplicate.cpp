// registers a label that another library registers too
#include <argos3/core/control_interface/ci_controller.h>

class CTestDuplicateController : public argos::CCI_Controller {};

REGISTER_CONTROLLER(CTestDuplicateController, "test_good_controller");
