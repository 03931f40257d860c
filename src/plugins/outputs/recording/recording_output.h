#ifndef ARGOS3_PLUGINS_OUTPUTS_RECORDING_RECORDING_OUTPUT_H
#define ARGOS3_PLUGINS_OUTPUTS_RECORDING_RECORDING_OUTPUT_H

#include <argos3/core/simulator/outputs/run_output.h>
#include <argos3/core/simulator/visualization/view_drawing.h>
#include <argos3/plugins/simulator/outputs/recording/capture.h>
#include <argos3/plugins/simulator/outputs/recording/format/recorded_frame.h>
#include <argos3/plugins/simulator/outputs/recording/format/recording_writer.h>
#include <argos3/plugins/simulator/outputs/recording/recorded_fields.h>

#include <memory>
#include <optional>
#include <string>

namespace argos {

/** Records a run into a file, from which it can be replayed: `<recording>`. */
class CRecordingOutput : public CRunOutput {
 public:
  CRecordingOutput();
  ~CRecordingOutput() override;

  /** Reads the attributes that the plug-in's description lists, and creates the file. */
  void Init(TConfigurationNode& tree) override;
  /** The next run goes to another file: "run.rec", "run.2.rec", ... */
  void Reset() override;
  void Destroy() override;
  void Observe(CSimulator& simulator) override;
  void Finish(CSimulator& simulator) override;

 private:
  void Open();
  void Record(CSimulator& simulator);
  void AddPending();
  void KeepReplayedFields(CSpace& space);

  std::string m_location;  // of the element
  std::string m_file;  // as given
  UInt32 m_every = 1;
  EPrecision m_precision = EPrecision::Grid;
  UInt32 m_run = 1;  // since loading
  CCapture m_capture;
  std::optional<CRecordedFields> m_fields;  // none: no fields
  CViewDrawing m_drawing;
  bool m_hasDrawing = false;  // it is recorded
  UInt32 m_width = 0;  // pixels, of the picture for which code draws
  UInt32 m_height = 0;
  std::unique_ptr<CRecordingWriter> m_writer;  // null: closed
  std::optional<UInt32> m_lastTick;  // recorded
  std::optional<SFrameUpdate> m_pending;  // of that tick: its metrics may still change
  UInt32 m_numFrames = 0;
  UInt64 m_numRobotTicks = 0;
};

}  // namespace argos

#endif
