#ifndef USER_PLUGINS_H
#define USER_PLUGINS_H

/* One plug-in of each kind as users of ARGoS 3 write them: a component, a robot, a sensor, an
   actuator, a medium, an engine and a visualization. */

#include <argos3/core/control_interface/ci_actuator.h>
#include <argos3/core/control_interface/ci_sensor.h>
#include <argos3/core/simulator/actuator.h>
#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/controllable_entity.h>
#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/simulator/medium/medium.h>
#include <argos3/core/simulator/physics_engine/physics_engine.h>
#include <argos3/core/simulator/physics_engine/physics_model.h>
#include <argos3/core/simulator/sensor.h>
#include <argos3/core/simulator/simulator.h>
#include <argos3/core/simulator/space/space.h>
#include <argos3/core/simulator/visualization/visualization.h>

namespace argos {

class CUserHornEntity : public CEntity {
 public:
  ENABLE_VTABLE();
  CUserHornEntity(CComposableEntity* pc_parent) : CEntity(pc_parent), m_fVolume(0.0) {}
  CUserHornEntity(CComposableEntity* pc_parent, const std::string& str_id)
      : CEntity(pc_parent, str_id), m_fVolume(0.0) {}
  virtual ~CUserHornEntity() {}
  virtual void Init(TConfigurationNode& t_tree) { CEntity::Init(t_tree); }
  virtual void Reset() { m_fVolume = 0.0; }
  virtual void Destroy() {}
  virtual void Update() { ++m_unUpdates; }
  virtual void SetEnabled(bool b_enabled) { CEntity::SetEnabled(b_enabled); }
  virtual std::string GetTypeDescription() const { return "horn"; }
  Real GetVolume() const { return m_fVolume; }
  void SetVolume(Real f_volume) { m_fVolume = f_volume; }
  UInt32 GetUpdates() const { return m_unUpdates; }

 private:
  Real m_fVolume;
  UInt32 m_unUpdates = 0;
};

class CUserRobotEntity : public CComposableEntity {
 public:
  ENABLE_VTABLE();
  CUserRobotEntity();
  CUserRobotEntity(const std::string& str_id, const std::string& str_controller_id,
                   const CVector3& c_position = CVector3(),
                   const CQuaternion& c_orientation = CQuaternion());
  virtual void Init(TConfigurationNode& t_tree);
  virtual void Reset();
  virtual void Destroy();
  virtual void UpdateComponents();
  virtual std::string GetTypeDescription() const { return "user-robot"; }
  CControllableEntity& GetControllableEntity() { return *m_pcControllableEntity; }
  CEmbodiedEntity& GetEmbodiedEntity() { return *m_pcEmbodiedEntity; }
  CUserHornEntity& GetHorn() { return *m_pcHorn; }

 private:
  CControllableEntity* m_pcControllableEntity;
  CEmbodiedEntity* m_pcEmbodiedEntity;
  CUserHornEntity* m_pcHorn;
};

class CCI_UserHornActuator : virtual public CCI_Actuator {
 public:
  virtual ~CCI_UserHornActuator() {}
  virtual void Blow(Real f_volume) = 0;
#ifdef ARGOS_WITH_LUA
  virtual void CreateLuaState(lua_State*) {}
#endif
};

class CCI_UserEarSensor : virtual public CCI_Sensor {
 public:
  virtual ~CCI_UserEarSensor() {}
  Real GetReading() const { return m_fReading; }
#ifdef ARGOS_WITH_LUA
  virtual void CreateLuaState(lua_State*) {}
  virtual void ReadingsToLuaState(lua_State*) {}
#endif
 protected:
  Real m_fReading = 0.0;
};

class CUserMedium : public CMedium {
 public:
  virtual ~CUserMedium() {}
  virtual void Init(TConfigurationNode& t_tree) { CMedium::Init(t_tree); }
  virtual void Reset() { m_unUpdates = 0; }
  virtual void Destroy() {}
  virtual void PostSpaceInit() { m_bReady = true; }
  virtual void Update() { ++m_unUpdates; }
  UInt32 m_unUpdates = 0;
  bool m_bReady = false;
};

class CUserModel : public CPhysicsModel {
 public:
  CUserModel(CPhysicsEngine& c_engine, CEmbodiedEntity& c_entity);
  virtual ~CUserModel() {}
  virtual void UpdateEntityStatus() { CPhysicsModel::UpdateEntityStatus(); }
  virtual void UpdateFromEntityStatus() {}
  virtual void UpdatePhysics() {
    m_cPosition += CVector3(0.1, 0.0, 0.0) * GetEngine().GetPhysicsClockTick();
  }
  virtual void MoveTo(const CVector3& c_position, const CQuaternion& c_orientation);
  virtual void CalculateBoundingBox();
  virtual void CalculateAnchors() { CPhysicsModel::CalculateAnchors(); }
  virtual bool IsCollidingWithSomething() const { return false; }
  void UpdateOriginAnchor(SAnchor& s_anchor);
  void Restart();

 private:
  CVector3 m_cPosition;
  CQuaternion m_cOrientation;
};

class CUserEngine : public CPhysicsEngine {
 public:
  virtual ~CUserEngine() {}
  virtual void Init(TConfigurationNode& t_tree);
  virtual void Reset();
  virtual void Destroy();
  virtual void Update();
  virtual void PostSpaceInit() {}
  virtual bool IsPointContained(const CVector3& c_point) {
    return CPhysicsEngine::IsPointContained(c_point);
  }
  virtual size_t GetNumPhysicsModels() { return m_tPhysicsModels.size(); }
  virtual bool AddEntity(CEntity& c_entity);
  virtual bool RemoveEntity(CEntity& c_entity);
  virtual void ScheduleEntityForTransfer(CEmbodiedEntity& c_entity) {
    CPhysicsEngine::ScheduleEntityForTransfer(c_entity);
  }
  virtual void TransferEntities() { CPhysicsEngine::TransferEntities(); }
  virtual void CheckIntersectionWithRay(TEmbodiedEntityIntersectionData& t_data,
                                        const CRay3& c_ray) const;

 private:
  CPhysicsModel::TMap m_tPhysicsModels;
};

class CUserVisualization : public CVisualization {
 public:
  virtual ~CUserVisualization() {}
  virtual void Init(TConfigurationNode& t_tree);
  virtual void Reset() {}
  virtual void Destroy() {}
  virtual void Execute();
  UInt32 m_unFrames = 0;
};

}  // namespace argos

#endif
