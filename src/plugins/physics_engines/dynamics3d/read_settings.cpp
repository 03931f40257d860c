#include <argos3/plugins/simulator/physics_engines/dynamics3d/read_settings.h>

#include <argos3/plugins/simulator/entities/value_checks.h>
#include <argos3/plugins/simulator/physics_engines/dynamics3d/rigid_settings.h>

#include <string>

namespace argos {

namespace {

// sweeps; more would never end
constexpr UInt32 kMaxSolverIterations = 1000;

// reads an optional number in [low, high]
void ReadInRange(TConfigurationNode& node, const std::string& attribute, Real low, Real high,
                 Real& value) {
  GetNodeAttributeOrDefault(node, attribute, value, value);
  if (!(value >= low && value <= high)) {
    THROW_ARGOSEXCEPTION(OwnerOf(node) << ": \"" << attribute << "\" must be a number in [" << low
                                       << "," << high << "], found " << value);
  }
}

void ReadSolver(TConfigurationNode& node, SRigidSettings& settings) {
  using enum SRigidSettings::EStepper;
  std::string stepper = "mixed";
  GetNodeAttributeOrDefault(node, "stepper", stepper, stepper);
  if (stepper == "mixed") {
    settings.Stepper = Mixed;
  } else if (stepper == "direct") {
    settings.Stepper = Direct;
  } else if (stepper == "iterative") {
    settings.Stepper = Iterative;
  } else {
    THROW_ARGOSEXCEPTION(OwnerOf(node) << ": \"stepper\" must be \"mixed\", \"direct\" or "
                                          "\"iterative\", found \""
                                       << stepper << "\"");
  }
  GetNodeAttributeOrDefault(node, "iterations", settings.SolverIterations,
                            settings.SolverIterations);
  if (settings.SolverIterations < 1 || settings.SolverIterations > kMaxSolverIterations) {
    THROW_ARGOSEXCEPTION(OwnerOf(node) << ": \"iterations\" must be in [1," << kMaxSolverIterations
                                       << "], found " << settings.SolverIterations);
  }
  GetNodeAttributeOrDefault(node, "max_direct_rows", settings.MaxDirectRows,
                            settings.MaxDirectRows);
  ReadInRange(node, "erp", 0.01, 1.0, settings.ErrorReduction);
  // without softness, redundant contacts cannot be solved
  ReadInRange(node, "cfm", 1e-10, 1.0, settings.ConstraintForceMixing);
}

void ReadContacts(TConfigurationNode& node, SRigidSettings& settings) {
  ReadInRange(node, "restitution", 0.0, 1.0, settings.Restitution);
  ReadInRange(node, "bounce_speed", 0.0, 1e3, settings.BounceSpeed);
  ReadInRange(node, "surface_layer", 0.0, 0.1, settings.SurfaceLayer);
  ReadInRange(node, "max_correcting_speed", 1e-3, 1e3, settings.MaxCorrectingSpeed);
}

}  // namespace

void ReadRigidSettings(TConfigurationNode& tree, SRigidSettings& settings) {
  ReadInRange(tree, "default_friction", 0.0, 1e3, settings.Friction);
  GetNodeAttributeOrDefault(tree, "sleep", settings.Sleep, settings.Sleep);
  GetNodeAttributeOrDefault(tree, "free_robots", settings.FreeRobots, settings.FreeRobots);
  GetNodeAttributeOrDefault(tree, "upright", settings.Upright, settings.Upright);
  // used by the debugger of another physics library
  NodeAttributeExists(tree, "debug_file");
  if (NodeExists(tree, "solver")) {
    ReadSolver(GetNode(tree, "solver"), settings);
  }
  if (NodeExists(tree, "contacts")) {
    ReadContacts(GetNode(tree, "contacts"), settings);
  }
}

}  // namespace argos
