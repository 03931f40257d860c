#include <argos3/core/simulator/loading/periodicity_check.h>

#include <argos3/core/simulator/context/load_errors.h>
#include <argos3/core/simulator/context/simulation_context.h>
#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/simulator/geometry/body_description.h>
#include <argos3/core/simulator/geometry/body_index.h>
#include <argos3/core/simulator/medium/medium.h>
#include <argos3/core/simulator/physics_engine/physics_engine.h>
#include <argos3/core/utility/configuration/argos_configuration.h>
#include <argos3/core/utility/errors/argos_exception.h>
#include <argos3/core/utility/plugins/factory.h>

#include <memory>
#include <string>

namespace argos {

namespace {

// such as 'file:line: <led id="leds">'
std::string DescribeMedium(const CMedium& medium, TConfigurationNode& root) {
  if (NodeExists(root, "media")) {
    TConfigurationNode& section = GetNode(root, "media");
    TConfigurationNodeIterator it;
    for (it = it.begin(&section); it != it.end(); ++it) {
      std::string id;
      GetNodeAttributeOrDefault(*it, "id", id, id);
      if (id == medium.GetId()) {
        return it->GetLocation() + ": <" + it->Value() + " id=\"" + id + "\">";
      }
    }
  }
  return "medium \"" + medium.GetId() + '"';
}

// ": use a or b", of the registered engines
std::string SuggestEngines() {
  std::string suggestion;
  for (const std::string& label : CFactory<CPhysicsEngine>::GetLabels()) {
    const std::unique_ptr<CPhysicsEngine> engine(CFactory<CPhysicsEngine>::New(label));
    if (engine->CanBePeriodic()) {
      suggestion += (suggestion.empty() ? ": use " : " or ") + label;
    }
  }
  return suggestion;
}

// Two bodies must not touch on both sides. Engines check it again with the paths of a tick.
void CheckWidth(const SSimulationContext& context, const std::string& arena) {
  const SPeriodicity& period = context.Arena.Period;
  context.Index->ForEachBody([&](CEmbodiedEntity& body) {
    const Real necessary = 4.0 * body.GetBodyDescription()->ComputeBoundingRadius();
    for (const SPeriodicAxis* axis : {&period.X, &period.Y}) {
      if (axis->IsOn() && body.IsMovable() && !(axis->Period > necessary)) {
        THROW_ARGOSEXCEPTION(arena << ": <arena>: \"size\" along a periodic axis must be more than "
                                      "four times the radius of \""
                                   << body.GetRootEntity().GetId() << "\", " << necessary
                                   << " m; found " << axis->Period << " m");
      }
    }
  });
}

}  // namespace

void CheckPeriodicity(const SSimulationContext& context, TConfigurationNode& root,
                      CLoadErrors& errors) {
  if (!context.Arena.Period.IsOn() || context.IsReplay) {
    return;
  }
  const auto refuse = [&errors](const std::string& part, const std::string& reason) {
    errors.Try("", [&] { THROW_ARGOSEXCEPTION(part << ": " << reason); });
  };
  for (const CPhysicsEngine* engine : context.Engines) {
    if (!engine->CanBePeriodic()) {
      refuse(engine->GetOrigin(),
             "an engine of this type does not know the joined sides of an <arena periodic=...>" +
                 SuggestEngines());
    }
    if (engine->IsEntityTransferActive()) {
      refuse(engine->GetOrigin(),
             "an engine with <boundaries> cannot be in an <arena periodic=...>: its region has an "
             "end where the arena has none");
    }
  }
  if (context.Engines.size() > 1) {
    refuse(context.Engines[1]->GetOrigin(),
           "an <arena periodic=...> has one engine only, and this is the second one");
  }
  errors.Try("", [&] { CheckWidth(context, GetNode(root, "arena").GetLocation()); });
  for (const CMedium* medium : context.Media) {
    if (!medium->CanBePeriodic()) {
      refuse(DescribeMedium(*medium, root),
             "a medium of this type does not know the joined sides of an <arena periodic=...>");
    }
  }
}

}  // namespace argos
