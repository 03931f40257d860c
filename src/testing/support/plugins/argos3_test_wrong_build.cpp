// claims to be compiled against other headers
#define ARGOS_BUILD_ID "api=0;real=float;string=new;containers=release"
#include <argos3/core/control_interface/ci_controller.h>

class CTestWrongBuildController : public argos::CCI_Controller {};

REGISTER_CONTROLLER(CTestWrongBuildController, "test_wrong_build_controller")
