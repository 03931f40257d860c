#ifndef ZEPPELIN_H
#define ZEPPELIN_H

#include <argos3/core/control_interface/ci_controller.h>

/** Base of the controllers of the family. */
class CZeppelin : public argos::CCI_Controller {
 public:
  void ControlStep() override;
  virtual const char* Name() const { return "zeppelin"; }
};

#endif
