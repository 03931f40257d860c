#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_FLIGHT_CEILING_ATTACHMENT_DEFAULT_ACTUATOR_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_FLIGHT_CEILING_ATTACHMENT_DEFAULT_ACTUATOR_H

#include <argos3/core/simulator/actuator.h>
#include <argos3/plugins/robots/generic/control_interface/ci_ceiling_attachment_actuator.h>

namespace argos {

class CEmbodiedEntity;
class CQuadRotorEntity;
class CSpace;

/** Attaches a flying robot to the ceiling, which is the upper limit of the arena. */
class CCeilingAttachmentDefaultActuator : public CSimulatedActuator,
                                          public CCI_CeilingAttachmentActuator {
 public:
  ~CCeilingAttachmentDefaultActuator() override;

  /** @throws CARGoSException if the robot has no "quadrotor" or "body". */
  void SetRobot(CComposableEntity& robot) override;
  /** Reads `reach`. */
  void Init(TConfigurationNode& tree) override;
  void Attach() override { m_wantsAttachment = true; }
  void Detach() override { m_wantsAttachment = false; }
  bool IsAttached() const override;
  void Update() override;
  void Reset() override;

 private:
  /** @return m, from the top of the body to the ceiling. */
  Real ComputeGap() const;

  CQuadRotorEntity* m_quadrotor = nullptr;
  const CEmbodiedEntity* m_body = nullptr;
  const CSpace* m_space = nullptr;
  Real m_reach = 0.05;  // m
  bool m_wantsAttachment = false;
};

}  // namespace argos

#endif
