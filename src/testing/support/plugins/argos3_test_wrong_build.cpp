// claims to be compiled with another option and against other headers of the core
#define ARGOS_BUILD_ID std::string("real=float;string=new;containers=release;core=000000000000")
#include <argos3/core/control_interface/ci_controller.h>

class CTestWrongBuildController : public argos::CCI_Controller {};

REGISTER_CONTROLLER(CTestWrongBuildController, "test_wrong_build_controller")
