#ifndef BEETLE_ENTITY_H
#define BEETLE_ENTITY_H

namespace argos {
class CControllableEntity;
class CEmbodiedEntity;
class CWheeledEntity;
}  // namespace argos

#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/embodied_entity.h>

#include <string>

namespace argos {

static const Real BEETLE_RADIUS = 0.06;  // m
static const Real BEETLE_HEIGHT = 0.05;  // m
static const Real BEETLE_MASS = 0.4;  // kg
static const Real BEETLE_WHEEL_RADIUS = 0.02;  // m
static const Real BEETLE_WHEEL_DISTANCE = 0.08;  // m
static const Real BEETLE_MAX_FORCE = 1.5;  // N
static const Real BEETLE_MAX_TORQUE = 1.5;  // N m

/* A small round robot on two wheels. */
class CBeetleEntity : public CComposableEntity {
 public:
  ENABLE_VTABLE();

 public:
  CBeetleEntity();
  CBeetleEntity(const std::string& str_id, const std::string& str_controller_id,
                const CVector3& c_position = CVector3(),
                const CQuaternion& c_orientation = CQuaternion());

  virtual void Init(TConfigurationNode& t_tree);
  virtual void Reset();
  virtual void UpdateComponents();

  inline CControllableEntity& GetControllableEntity() { return *m_pcControllableEntity; }
  inline CEmbodiedEntity& GetEmbodiedEntity() { return *m_pcEmbodiedEntity; }
  inline CWheeledEntity& GetWheeledEntity() { return *m_pcWheeledEntity; }

  virtual std::string GetTypeDescription() const { return "beetle"; }

 private:
  void AddWheels();

  CControllableEntity* m_pcControllableEntity;
  CEmbodiedEntity* m_pcEmbodiedEntity;
  CWheeledEntity* m_pcWheeledEntity;
};

}  // namespace argos

#endif
