#include <argos3/core/utility/math/vector3.h>
#include <argos3/plugins/simulator/entities/value_checks.h>
#include <argos3/plugins/simulator/physics_engines/dynamics3d/add_on_manual.h>
#include <argos3/plugins/simulator/physics_engines/dynamics3d/dynamics3d_engine.h>
#include <argos3/plugins/simulator/physics_engines/dynamics3d/dynamics3d_plugin.h>
#include <argos3/plugins/simulator/physics_engines/dynamics3d/rigid_settings.h>

namespace argos {

/** Gravity, the same everywhere. */
class CDynamics3DGravityPlugin : public CDynamics3DPlugin {
 public:
  bool IgnoresModels() const override { return true; }
  void Init(TConfigurationNode& tree) override {
    const bool hasVector = NodeAttributeExists(tree, "vector");
    if (hasVector && NodeAttributeExists(tree, "g")) {
      THROW_ARGOSEXCEPTION(OwnerOf(tree) << ": give either \"g\", downward, or \"vector\"");
    }
    CVector3 gravity;
    if (hasVector) {
      GetNodeAttribute(tree, "vector", gravity);
    } else {
      Real g = kStandardGravity;
      GetNodeAttributeOrDefault(tree, "g", g, g);
      gravity.Set(0.0, 0.0, -g);
    }
    RequireEachIn(kAcceleration, gravity, OwnerOf(tree), "gravity");
    GetEngine().SetGravity(gravity);
  }
};

REGISTER_DYNAMICS3D_PLUGIN(
    CDynamics3DGravityPlugin, "gravity", "the authors of this project", "1.0",
    "Gravity for dynamics3d.",
    R"(Every movable body is accelerated alike. In an engine with other add-ons and without this one nothing falls; one
without any add-on has 9.81 m/s^2.
)" + AddOnXML(R"(<gravity />)", R"(<gravity g="9.81" />)") +
        R"(
ATTRIBUTES

  g       m/s^2, default 9.81, from -1e4 to 1e4: downward.
  vector  "x,y,z", m/s^2, instead of g: in any direction.
)",
    "Usable")

}  // namespace argos
