#include <argos3/plugins/simulator/physics_engines/robot_bodies/engine_manual.h>

namespace argos {

std::string RequiredEngineXML(const std::string& engine) {
  return "\nREQUIRED XML\n\n  <physics_engines>\n    " + engine + "\n  </physics_engines>\n";
}

std::string OptionalEngineXML(const std::string& tag, const std::string& attributes,
                              const std::string& children, const std::string& limits) {
  return "\nOPTIONAL XML\n\n  <physics_engines>\n    <" + tag + " " + attributes + ">\n" +
         children + "      <boundaries>\n" + limits + R"(        <sides>
          <vertex point="0,0" /> <vertex point="5,0" /> <vertex point="5,5" /> <vertex point="0,5" />
        </sides>
      </boundaries>
    </)" +
         tag + ">\n  </physics_engines>\n";
}

std::string PlanarFrictionXML() {
  return R"(      <friction box_linear_friction="1.49" box_angular_friction="1.49"
                cylinder_linear_friction="1.49" cylinder_angular_friction="1.49" />
)";
}

std::string VelocityLagManual() {
  return R"(  velocity_lag               share of a tick, 0 to 1, default 1 / iterations if the file gives these, else
                             0.1: time until new wheel speeds take effect. Until then robots move as in
                             the tick before, or stand if they were just placed. ARGoS 3 had this lag.
)";
}

std::string PlanarBoundariesManual() {
  return R"(  boundaries                 the region of the engine, default everything: sides/vertex@point, in m, at
                             least three, counter-clockwise, convex. A vertex may have wall="true", which
                             stops bodies at the side from there to the next vertex, or gate="id", which
                             transfers bodies that cross it to that engine (doc/space_partitioning.md).
  ghosts                     true or false, default true: robots of other engines near the border are
                             obstacles.
)";
}

}  // namespace argos
