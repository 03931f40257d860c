#include <argos3/core/simulator/placement/recorded_start.h>

#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/simulator/entity/positional_entity.h>
#include <argos3/core/simulator/physics_engine/described_body_model.h>
#include <argos3/core/simulator/placement/planned_bodies.h>
#include <argos3/core/simulator/replay/replay.h>
#include <argos3/core/simulator/space/space.h>
#include <argos3/core/utility/errors/argos_exception.h>
#include <argos3/core/utility/files/nearby_file.h>
#include <argos3/core/utility/logging/argos_log.h>

#include <memory>
#include <optional>
#include <string>
#include <unordered_set>
#include <vector>

namespace argos {

namespace {

std::optional<SReplayTime> ReadStartTime(TConfigurationNode& arena) {
  if (!NodeAttributeExists(arena, "start_at")) {
    return std::nullopt;
  }
  std::string text;
  GetNodeAttribute(arena, "start_at", text);
  const std::optional<SReplayTime> time = ParseReplayTime(text);
  if (!time) {
    THROW_ARGOSEXCEPTION(
        "attribute \"start_at\" must be a tick, such as 100, or a time in "
        "seconds, such as 12.5s, found \""
        << text << '"');
  }
  return time;
}

// @return true if the entity can be moved
bool Place(CEntity& entity, const SBodyPose& pose) {
  if (auto* const point = dynamic_cast<CPositionalEntity*>(&entity)) {
    point->MoveTo(pose.Position, pose.Orientation);
    point->SetInitPosition(pose.Position);
    point->SetInitOrientation(pose.Orientation);
    return true;
  }
  CEmbodiedEntity* const body = FindEmbodiedEntity(entity);
  if (body == nullptr || !body->IsMovable()) {
    return false;
  }
  body->MoveTo(pose.Position, pose.Orientation, false, true);
  body->SetInitPose(pose.Position, pose.Orientation);
  return true;
}

// Overlaps of recorded bodies are roundings; one with what was not there is an error.
void CheckOverlaps(CSpace& space, const std::vector<SRecordedPose>& recorded) {
  const CBodyIndex& index = space.GetBodyIndex();
  std::unordered_set<std::string> ids;
  for (const SRecordedPose& pose : recorded) {
    ids.insert(pose.Id);
  }
  for (const SRecordedPose& pose : recorded) {
    CEntity* const entity = space.TryGetEntity(pose.Id);
    const CEmbodiedEntity* const body = entity != nullptr ? FindEmbodiedEntity(*entity) : nullptr;
    if (body == nullptr || !body->IsMovable() || body->GetBodyDescription() == nullptr) {
      continue;
    }
    const SAnchor& origin = body->GetOriginAnchor();
    const UInt32 obstacle = index.FindOverlap(*body->GetBodyDescription(), origin.Position,
                                              origin.Orientation, body->GetBodyNumber());
    if (obstacle == CBodyIndex::kNoBody) {
      continue;
    }
    const std::string& other = index.GetBody(obstacle).GetRootEntity().GetId();
    if (ids.count(other) == 0) {
      THROW_ARGOSEXCEPTION('"' << pose.Id << "\" would overlap \"" << other << "\" at ("
                               << origin.Position << "), where it was then");
    }
  }
}

void Place(CSpace& space, TConfigurationNode& arena) {
  bool isRedistributed = false;
  GetNodeAttributeOrDefault(arena, "redistribute", isRedistributed, isRedistributed);
  if (isRedistributed) {
    THROW_ARGOSEXCEPTION("\"start_from\" and redistribute=\"true\" contradict each other");
  }
  std::string name;
  GetNodeAttribute(arena, "start_from", name);
  const std::string file = FindNearbyFile(name, arena.GetFileName(), "recording");
  const std::unique_ptr<CReplay> recording(CFactory<CReplay>::New("recording"));
  const std::vector<SRecordedPose> recorded = recording->ReadPoses(file, ReadStartTime(arena));
  size_t numPlaced = 0;
  for (const SRecordedPose& pose : recorded) {
    CEntity* const entity = space.TryGetEntity(pose.Id);
    numPlaced += entity != nullptr && Place(*entity, pose.Pose) ? 1 : 0;
  }
  if (numPlaced == 0) {
    THROW_ARGOSEXCEPTION("nothing of the arena that can move is in \"" << file
                                                                       << "\": ids must be equal");
  }
  CheckOverlaps(space, recorded);
  LOG << "[INFO] " << numPlaced << " of " << space.GetRootEntityVector().size()
      << " entities start where they were in \"" << file << '"' << std::endl;
}

}  // namespace

void PlaceAsRecorded(CSpace& space, TConfigurationNode& arena) {
  if (!NodeAttributeExists(arena, "start_from")) {
    if (NodeAttributeExists(arena, "start_at")) {
      THROW_ARGOSEXCEPTION(arena.GetLocation()
                           << ": <arena>: \"start_at\" needs \"start_from\", a recording");
    }
    return;
  }
  try {
    Place(space, arena);
  } catch (CARGoSException& ex) {
    THROW_ARGOSEXCEPTION_NESTED(arena.GetLocation() << ": <arena>: \"start_from\"", ex);
  }
}

}  // namespace argos
