#ifndef ARGOS3_PLUGINS_ROBOTS_PROTOTYPE_SIMULATOR_PROTOTYPE_ENTITY_H
#define ARGOS3_PLUGINS_ROBOTS_PROTOTYPE_SIMULATOR_PROTOTYPE_ENTITY_H

#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/visualization/appearance.h>

namespace argos {

class CControllableEntity;
class CEmbodiedEntity;
class CJointEquippedEntity;
struct SPrototypeAssembly;

/**
 * A robot or an object that its experiment file describes: links, joints and devices; see the
 * manual in the source.
 *
 * Each link has an anchor of its id. Links on fixed joints are one rigid part; a prototype with
 * fixed joints only is a rigid body for every engine.
 */
class CPrototypeEntity : public CComposableEntity {
 public:
  ENABLE_VTABLE();

  CPrototypeEntity();

  /** @throws CARGoSException with file and line for everything that is wrong. */
  void Init(TConfigurationNode& tree) override;
  std::string GetTypeDescription() const override { return "prototype"; }
  /** Moves the devices along with their links. */
  void UpdateComponents() override;
  const SAppearance* GetAppearance() const override { return &m_appearance; }

  CEmbodiedEntity& GetEmbodiedEntity() { return *m_body; }
  const CEmbodiedEntity& GetEmbodiedEntity() const { return *m_body; }
  /** @throws CARGoSException if all joints are fixed. */
  CJointEquippedEntity& GetJointEquippedEntity();
  /** @throws CARGoSException without the child `<controller>`. */
  CControllableEntity& GetControllableEntity();

 private:
  void InitBody(TConfigurationNode& tree);
  void InitDevices(TConfigurationNode& devices);
  template <typename COMPONENT>
  void AddDevice(TConfigurationNode& node);
  void InitProximity(TConfigurationNode& node);
  void MakeAppearance(const SPrototypeAssembly& assembly);

  SAppearance m_appearance;
  // components
  CEmbodiedEntity* m_body = nullptr;
  CJointEquippedEntity* m_joints = nullptr;
  CControllableEntity* m_controllable = nullptr;
  CEntity::TVector m_devices;
};

}  // namespace argos

#endif
