// loaded only by the test that loads all libraries of a folder
#include <argos3/core/control_interface/ci_controller.h>

class CTestOneOfAllController : public argos::CCI_Controller {};

REGISTER_CONTROLLER(CTestOneOfAllController, "test_one_of_all_controller")
