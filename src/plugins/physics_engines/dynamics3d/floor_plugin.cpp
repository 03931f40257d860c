#include <argos3/plugins/simulator/entities/value_checks.h>
#include <argos3/plugins/simulator/physics_engines/dynamics3d/add_on_manual.h>
#include <argos3/plugins/simulator/physics_engines/dynamics3d/dynamics3d_engine.h>
#include <argos3/plugins/simulator/physics_engines/dynamics3d/dynamics3d_plugin.h>

namespace argos {

/** An endless horizontal plane that holds up what is above it. */
class CDynamics3DFloorPlugin : public CDynamics3DPlugin {
 public:
  bool IgnoresModels() const override { return true; }
  void Init(TConfigurationNode& tree) override {
    Real height = 0.0;
    Real friction = 1.0;
    GetNodeAttributeOrDefault(tree, "height", height, height);
    GetNodeAttributeOrDefault(tree, "friction", friction, friction);
    RequireNotNegative(friction, OwnerOf(tree), "attribute \"friction\"");
    GetEngine().AddGroundPlane(height, friction);
  }
};

REGISTER_DYNAMICS3D_PLUGIN(
    CDynamics3DFloorPlugin, "floor", "the authors of this project", "1.0",
    "A floor for dynamics3d.",
    R"(An endless horizontal plane. Everything below its surface is solid. An engine without any add-on has one at z = 0,
or at the bottom of its region if that is a wall.
)" + AddOnXML(R"(<floor />)", R"(<floor height="0" friction="1" />)") +
        R"(
ATTRIBUTES

  height    m, default 0.
  friction  >= 0, default 1: Coulomb's coefficient; that of a contact is the product of this and the body's.
)",
    "Usable")

}  // namespace argos
