#ifndef ARGOS3_PLUGINS_OUTPUTS_RECORDING_CAPTURE_H
#define ARGOS3_PLUGINS_OUTPUTS_RECORDING_CAPTURE_H

#include <argos3/plugins/simulator/outputs/recording/format/recorded_frame.h>
#include <argos3/plugins/simulator/outputs/recording/tracked_entity.h>

#include <memory>
#include <string>
#include <unordered_map>
#include <vector>

namespace argos {

class CFloorEntity;
class CSpace;

/** Reads what views show of a space, tick after tick. Changes nothing, and creates no entity. */
class CCapture {
 public:
  /** Fills an empty update with the present state; the first one has all entities. */
  void Take(CSpace& space, SFrameUpdate& update);
  /** The next update has all entities again. */
  void Restart();

 private:
  void TakeEntities(CSpace& space, SFrameUpdate& update);
  // @return true if entities that are left have new parts
  bool RemoveGone(CSpace& space, SFrameUpdate& update);
  UInt32 FindType(const CTrackedEntity& entity, SFrameUpdate& update);
  void TakeFloor(CSpace& space, SFrameUpdate& update);
  std::shared_ptr<const SRecordedFloor> ReadFloor(CSpace& space, CFloorEntity& floor) const;

  std::vector<CTrackedEntity> m_entities;  // have the order of the space
  std::unordered_map<std::string, UInt32> m_types;  // are keyed by their bytes
  bool m_isRestart = true;
  std::shared_ptr<const SRecordedFloor> m_floor;  // floor of the last update
  const CFloorEntity* m_floorEntity = nullptr;  // entity of m_floor
  UInt64 m_floorVersion = 0;  // version of m_floor
};

/** Sets the metrics of an update to those of now. */
void TakeMetrics(CSpace& space, SFrameUpdate& update);

}  // namespace argos

#endif
