#include <argos3/core/simulator/loading/load_warnings.h>

#include <argos3/core/simulator/context/simulation_context.h>
#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/simulator/geometry/body_description.h>
#include <argos3/core/simulator/geometry/body_index.h>
#include <argos3/core/simulator/loading/loading_check.h>
#include <argos3/core/simulator/space/space.h>
#include <argos3/core/utility/configuration/configuration_document.h>
#include <argos3/core/utility/logging/argos_log.h>
#include <argos3/core/utility/text/classic_locale.h>

#include <algorithm>

namespace argos {

namespace {

// more lines hide what was printed before them
constexpr size_t kMaxWarnings = 20;

// tolerance for roundings of poses and of the arena's limits
constexpr Real kArenaTolerance = 1e-6;  // m

typedef std::vector<std::string> TLines;

void CheckIds(TConfigurationNode& section, TLines& lines) {
  TConfigurationNodeIterator it;
  for (it = it.begin(&section); it != it.end(); ++it) {
    std::string id = "some";
    GetNodeAttributeOrDefault(*it, "id", id, id);
    if (id.empty()) {
      lines.push_back(it->GetLocation() + ": <" + it->Value() + ">: attribute \"id\" is empty");
    }
  }
}

// Of walls the origin may be outside, of movable bodies not. An arena without a height has none
// that bodies could be outside of.
bool IsOutside(const CEmbodiedEntity& body, const CRange<CVector3>& limits) {
  const CVector3& position = body.GetOriginAnchor().Position;
  const Real reach = body.IsMovable() || body.GetBodyDescription() == nullptr
                         ? 0.0
                         : body.GetBodyDescription()->ComputeBoundingRadius();
  const bool isFlat = !(limits.GetMin().GetZ() < limits.GetMax().GetZ());
  for (UInt32 axis = 0; axis < (isFlat ? 2U : 3U); ++axis) {
    if (position[axis] < limits.GetMin()[axis] - reach - kArenaTolerance ||
        position[axis] > limits.GetMax()[axis] + reach + kArenaTolerance) {
      return true;
    }
  }
  return false;
}

// <distribute> has checked the bodies that it places
bool IsPlacedByHand(const CEmbodiedEntity& body) {
  CEntity& root = const_cast<CEmbodiedEntity&>(body).GetRootEntity();
  TConfigurationNode* const node = root.GetConfigurationNode();
  const TConfigurationNode* const parent = node != nullptr ? node->Parent(false) : nullptr;
  return parent != nullptr && parent->Value() == "arena";
}

// Bodies with a common fault: how many, and the first in the order of the roots.
struct SFaultyBodies {
  size_t Number = 0;
  size_t PlaceOfFirst = 0;
  const CEmbodiedEntity* First = nullptr;

  void Add(size_t place, const CEmbodiedEntity& body) {
    ++Number;
    if (First == nullptr || place < PlaceOfFirst) {
      PlaceOfFirst = place;
      First = &body;
    }
  }
};

// The immovable body in which a body begins that is placed by hand, or null. Robots that overlap
// each other are pushed apart.
const CEmbodiedEntity* FindWallAround(const CBodyIndex& index, const CEmbodiedEntity& body) {
  const SBodyDescription* const description = body.GetBodyDescription();
  if (!body.IsMovable() || description == nullptr || description->Articulation != nullptr ||
      body.GetBodyNumber() == CBodyIndex::kNoBody || !IsPlacedByHand(body)) {
    return nullptr;
  }
  const SAnchor& origin = body.GetOriginAnchor();
  const UInt32 other =
      index.FindOverlap(*description, origin.Position, origin.Orientation, body.GetBodyNumber());
  return other != CBodyIndex::kNoBody && !index.GetBody(other).IsMovable() ? &index.GetBody(other)
                                                                           : nullptr;
}

std::string DescribeOutside(const SFaultyBodies& bodies, const CRange<CVector3>& limits) {
  CTextOutput line;
  line << bodies.Number << (bodies.Number == 1 ? " body is" : " bodies are")
       << " outside of the arena, from (" << limits.GetMin() << ") to (" << limits.GetMax()
       << "): \"" << bodies.First->GetRootEntity().GetId() << "\" at ("
       << bodies.First->GetOriginAnchor().Position << ")" << (bodies.Number == 1 ? "" : ", ...");
  return line.str();
}

std::string DescribeInWalls(const SFaultyBodies& bodies, const CBodyIndex& index) {
  CTextOutput line;
  line << '"' << bodies.First->GetRootEntity().GetId() << "\" at ("
       << bodies.First->GetOriginAnchor().Position << ") overlaps \""
       << FindWallAround(index, *bodies.First)->GetRootEntity().GetId() << "\" at the start";
  if (bodies.Number > 1) {
    line << ", and " << bodies.Number - 1 << " more";
  }
  return line.str();
}

void CheckBodies(const SSimulationContext& context, TLines& lines) {
  const CBodyIndex& index = context.Space->GetBodyIndex();
  SFaultyBodies outside;
  SFaultyBodies inWalls;  // they are pushed out, perhaps on the wrong side
  context.Space->ForRootsAsCreated([&](CEntity& root, size_t place) {
    const auto* const composable = dynamic_cast<const CComposableEntity*>(&root);
    if (composable == nullptr) {
      return;
    }
    for (const CEntity* const component : composable->GetExistingComponents()) {
      const auto* const body = dynamic_cast<const CEmbodiedEntity*>(component);
      if (body == nullptr) {
        continue;
      }
      if (IsOutside(*body, context.Arena.Limits)) {
        outside.Add(place, *body);
      }
      if (FindWallAround(index, *body) != nullptr) {
        inWalls.Add(place, *body);
      }
    }
  });
  if (outside.Number > 0) {
    lines.push_back(DescribeOutside(outside, context.Arena.Limits));
  }
  if (inWalls.Number > 0) {
    lines.push_back(DescribeInWalls(inWalls, index));
  }
}

}  // namespace

std::vector<std::string> FindUnusedControllers(const CConfigurationDocument& document,
                                               const SSimulationContext& context) {
  TLines lines;
  for (const SControllerSetup* setup : context.Loading.ListUnusedControllers()) {
    if (!document.DescribeUnread(*setup->Node).empty()) {
      lines.push_back(setup->Node->GetLocation() + ": <" + setup->Node->Value() +
                      ">: no robot has the controller \"" + setup->Id +
                      "\", so its devices and parameters are not checked");
    }
  }
  return lines;
}

std::vector<std::string> FindLoadWarnings(CConfigurationDocument& document,
                                          const SSimulationContext& context, bool mayAddRobots) {
  // the checks below visit elements, so this comes first
  TLines unread = document.DescribeUnread();
  for (const SControllerSetup* setup : context.Loading.ListUnusedControllers()) {
    const TLines unused = document.DescribeUnread(*setup->Node);
    std::erase_if(unread, [&unused](const std::string& line) {
      return std::find(unused.begin(), unused.end(), line) != unused.end();
    });
  }
  TLines lines;
  TConfigurationNode& root = document.GetRoot();
  for (const char* const section : {"physics_engines", "media", "arena"}) {
    if (NodeExists(root, section)) {
      CheckIds(GetNode(root, section), lines);
    }
  }
  CheckBodies(context, lines);
  if (!mayAddRobots) {
    const TLines unused = FindUnusedControllers(document, context);
    lines.insert(lines.end(), unused.begin(), unused.end());
  }
  lines.insert(lines.end(), unread.begin(), unread.end());
  return lines;
}

void PrintWarnings(const std::vector<std::string>& lines) {
  const size_t printed =
      CLoadingCheck::IsActive() ? lines.size() : std::min(lines.size(), kMaxWarnings);
  for (size_t i = 0; i < printed; ++i) {
    LOGERR << "[WARNING] " << lines[i] << std::endl;
  }
  if (printed < lines.size()) {
    LOGERR << "[WARNING] ... and " << lines.size() - printed << " warnings more" << std::endl;
  }
}

}  // namespace argos
