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
 * SetEngine() comes first, then Init(). Models come and go as bodies do; Update() is called before
 * every substep, by the thread that runs the engine, and may read and push the engine's models
 * (CDynamics3DModel). It must not depend on addresses, threads or other engines.
 */
class CDynamics3DPlugin : public CBaseConfigurableResource {
 public:
  void Init(TConfigurationNode& /*tree*/) override {}
  void Reset() override {}
  void Destroy() override {}

  virtual void SetEngine(CDynamics3DEngine& engine) { m_engine = &engine; }
  /** A body has been added to the engine. Does nothing by default, as the next two. */
  virtual void RegisterModel(CDynamics3DModel& /*model*/) {}
  virtual void UnregisterModel(CDynamics3DModel& /*model*/) {}
  virtual void Update() {}

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

#endif
