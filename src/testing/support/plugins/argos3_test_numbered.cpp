// Built several times, each time as a library with its own labels, which contain ARGOS_TEST_NUMBER.
// The classes have equal names in all libraries, but are different classes.

#include <argos3/core/control_interface/ci_controller.h>
#include <argos3/core/simulator/entity/positional_entity.h>
#include <argos3/core/simulator/space/space_operations.h>
#include <argos3/testing/support/toy_world.h>

#include <chrono>
#include <thread>

#define ARGOS_TEST_TEXT_EXPANDED(NUMBER) #NUMBER
#define ARGOS_TEST_TEXT(NUMBER) ARGOS_TEST_TEXT_EXPANDED(NUMBER)
#define ARGOS_TEST_LABEL(NAME) NAME ARGOS_TEST_TEXT(ARGOS_TEST_NUMBER)

namespace argos {

namespace {

/* Drives a toy robot along x; the number of the library is the speed in cm/s. */
class CNumberedController : public CCI_Controller {
 public:
  void Init(TConfigurationNode&) override {
    m_drive = GetActuator<CCI_ToyDriveActuator>("toy_drive");
  }
  void ControlStep() override {
    m_drive->SetVelocity(CVector3(0.01 * ARGOS_TEST_NUMBER, 0.0, 0.0));
  }

 private:
  CCI_ToyDriveActuator* m_drive = nullptr;
};

class CNumberedMarker : public CPositionalEntity {
 public:
  ENABLE_VTABLE()
  CNumberedMarker() : CPositionalEntity(nullptr) {}
  std::string GetTypeDescription() const override { return ARGOS_TEST_LABEL("test-marker-"); }
};

REGISTER_CONTROLLER(CNumberedController, ARGOS_TEST_LABEL("test_numbered_controller_"))

// Delays the second registration: a look-up that finds the first label but not the second has seen
// a partly loaded library.
[[maybe_unused]] const bool kHasSlept = [] {
  std::this_thread::sleep_for(std::chrono::milliseconds(50));
  return true;
}();

REGISTER_ENTITY(CNumberedMarker, ARGOS_TEST_LABEL("test-marker-"), "", "", "A place for tests.", "",
                "")
REGISTER_STANDARD_SPACE_OPERATIONS_ON_ENTITY(CNumberedMarker)

}  // namespace

}  // namespace argos
