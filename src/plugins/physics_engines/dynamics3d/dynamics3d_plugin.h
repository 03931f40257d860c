#ifndef ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS3D_DYNAMICS3D_PLUGIN_H
#define ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS3D_DYNAMICS3D_PLUGIN_H

#include <argos3/core/utility/configuration/base_configurable_resource.h>
#include <argos3/core/utility/plugins/factory.h>

namespace argos {

class CDynamics3DEngine;
class CDynamics3DModel;

/**
 * An add-on of a dynamics3d engine: a child of its element in the experiment file, by label.
 *
 * SetEngine() is called first, then Init(). Models are registered and unregistered as bodies enter
 * and leave the engine. Update() is called before every substep, by the thread that runs the
 * engine, and may read the engine's models (CDynamics3DModel) and apply forces to them. It must not
 * depend on addresses, threads or other engines.
 */
class CDynamics3DPlugin : public CBaseConfigurableResource {
 public:
  void Init(TConfigurationNode& /*tree*/) override {}
  void Reset() override {}
  void Destroy() override {}

  virtual void SetEngine(CDynamics3DEngine& engine) { m_engine = &engine; }
  /** Called after a body was added to the engine. This and the next two do nothing by default. */
  virtual void RegisterModel(CDynamics3DModel& /*model*/) {}
  virtual void UnregisterModel(CDynamics3DModel& /*model*/) {}
  virtual void Update() {}
  /**
   * @return true if the add-on neither applies forces nor reads models in Update(). Only if all
   * add-ons of an engine do, may its robots roll without being stepped by ODE where they can touch
   * nothing; see the README beside this file.
   */
  virtual bool IgnoresModels() const { return false; }

 protected:
  CDynamics3DEngine& GetEngine() const { return *m_engine; }

 private:
  CDynamics3DEngine* m_engine = nullptr;  // not owned
};

}  // namespace argos

#define REGISTER_DYNAMICS3D_PLUGIN(CLASSNAME, LABEL, AUTHOR, VERSION, BRIEF_DESCRIPTION,   \
                                   LONG_DESCRIPTION, STATUS)                               \
  REGISTER_SYMBOL(CDynamics3DPlugin, CLASSNAME, LABEL, AUTHOR, VERSION, BRIEF_DESCRIPTION, \
                  LONG_DESCRIPTION, STATUS)

#ifndef ARGOS_WITHOUT_COMPANIONS
#include <argos3/core/simulator/simulator.h>
#include <argos3/plugins/simulator/physics_engines/dynamics3d/dynamics3d_engine.h>
#endif

#endif
