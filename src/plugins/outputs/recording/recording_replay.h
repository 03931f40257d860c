#ifndef ARGOS3_PLUGINS_OUTPUTS_RECORDING_RECORDING_REPLAY_H
#define ARGOS3_PLUGINS_OUTPUTS_RECORDING_RECORDING_REPLAY_H

#include <argos3/core/simulator/replay/replay.h>
#include <argos3/plugins/simulator/outputs/recording/format/recording_reader.h>
#include <argos3/plugins/simulator/outputs/recording/stand_ins.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace argos {

/** Replays what `<recording>` has written. */
class CRecordingReplay : public CReplay {
 public:
  CRecordingReplay();
  ~CRecordingReplay() override;

  void Open(const SReplayRequest& request) override;
  UInt32 ReadSeed(const std::string& file) const override;
  std::vector<SRecordedPose> ReadPoses(const std::string& file,
                                       const std::optional<SReplayTime>& at) const override;
  const std::string& GetExperiment() const override;
  const std::string& GetExperimentFile() const override { return m_experimentFile; }
  UInt32 GetSeed() const override;
  Real GetTickLength() const override;
  bool IsExact() const override;
  UInt32 GetLastTick() const override { return m_lastTick; }
  std::unique_ptr<CLoopFunctions> MakeLoopFunctions() override;
  void Begin(CSpace& space) override;
  void Advance(CSpace& space) override;
  void Seek(CSpace& space, UInt32 tick) override;
  bool IsAtEnd() const override { return m_hasEnded; }

  /** What users' code drew in the present state, see DrawAgain(); empty if it is not recorded. */
  const std::string& GetDrawing() const { return m_drawing; }
  /** The floor of the present state; null if there is none. */
  const SRecordedFloor* GetFloor() const { return m_floor.get(); }

 private:
  void SelectPart(const SReplayRequest& request);
  const SRecordedFrame* ReadFrame();
  void Show(const SRecordedFrame& frame, CSpace& space);
  void UpdateTypes(const SRecordedFrame& frame);
  void UpdateEntities(const SRecordedFrame& frame, CSpace& space);
  bool IsSame(const CReplayedEntity& entity, const SRecordedEntity& recorded) const;
  void ShowRays(const SRecordedFrame& frame) const;
  void ShowFieldsAndDrawing(const SRecordedFrame& frame, CSpace& space);

  std::unique_ptr<CRecordingReader> m_reader;
  std::string m_experimentFile;
  UInt32 m_firstTick = 0;
  UInt32 m_lastTick = 0;
  UInt32 m_every = 1;
  UInt32 m_nextTick = 0;  // states before it are skipped, but for the last one
  bool m_hasEnded = false;

  std::vector<std::shared_ptr<const SRecordedType>> m_types;  // types of the frame
  std::vector<std::string> m_typeBytes;  // bytes of m_types
  std::vector<CReplayedEntity> m_entities;  // have the order of the space
  UInt64 m_entitiesVersion = 0;  // version of m_entities
  std::shared_ptr<const SRecordedFloor> m_floor;
  std::string m_drawing;
  std::shared_ptr<SReplayedColumns> m_columns = std::make_shared<SReplayedColumns>();
};

}  // namespace argos

#endif
