#ifndef ARGOS3_CORE_CONTROL_INTERFACE_CHANGEABLE_PARAMETERS_H
#define ARGOS3_CORE_CONTROL_INTERFACE_CHANGEABLE_PARAMETERS_H

#include <argos3/core/utility/datatypes/datatypes.h>

#include <string>
#include <vector>

namespace argos {

/**
 * A second base class of controllers and loop functions whose numbers may be changed during a run:
 * the live view shows a slider for each, and a recording contains the changes.
 *
 * @code
 * class CMyController : public argos::CCI_Controller, public argos::CChangeableParameters {
 *   TParameters ListParameters() override { return {{"speed", m_speed, 0.0, 20.0, "cm/s"}}; }
 * @endcode
 */
class CChangeableParameters {
 public:
  struct SParameter {
    std::string Name;
    Real& Value; /**< a member of the object, that lives as long as it does */
    Real Min;
    Real Max;
    std::string Unit = {};
  };
  using TParameters = std::vector<SParameter>;

  virtual ~CChangeableParameters() = default;

  /** Called between ticks, after Init(). Names are letters, digits and '_'. */
  virtual TParameters ListParameters() = 0;
  /** Called after a value was set, between ticks. */
  virtual void HandleChangedParameter(const std::string& /*name*/) {}
};

}  // namespace argos

#endif
