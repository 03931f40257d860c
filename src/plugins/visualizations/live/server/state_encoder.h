#ifndef ARGOS3_PLUGINS_VISUALIZATIONS_LIVE_SERVER_STATE_ENCODER_H
#define ARGOS3_PLUGINS_VISUALIZATIONS_LIVE_SERVER_STATE_ENCODER_H

#include <argos3/plugins/simulator/outputs/recording/format/frame_coding.h>
#include <argos3/plugins/simulator/outputs/recording/format/recording_blocks.h>
#include <argos3/plugins/simulator/visualizations/live/link/live_messages.h>

#include <memory>
#include <string>
#include <vector>

namespace argos {

/**
 * Codes states for one viewer, as blocks of a recording: differences to the last state that it was
 * sent, whichever were skipped.
 */
class CStateEncoder {
 public:
  /** A viewer needs at most so many states to decode one that it has kept. */
  static constexpr UInt32 kMaxStatesFromKey = 100;

  CStateEncoder() : m_encoder(EPrecision::Grid) {}

  /**
   * Codes a state, perhaps after the floor.
   * @param state   the table of its update is used meanwhile, and empty afterwards.
   * @param blocks  the blocks are appended, each with its header.
   */
  void Encode(SLiveState& state, CBlockPacker& packer, std::vector<std::string>& blocks);

 private:
  bool NeedsKey(const SLiveState& state) const;
  void AddFloor(const SRecordedFloor& floor, CBlockPacker& packer,
                std::vector<std::string>& blocks);

  CFrameEncoder m_encoder;
  std::shared_ptr<const SLiveTable> m_table;  // of the last state; null: none was sent
  std::shared_ptr<const SRecordedFloor> m_floor;  // of the last state
  UInt32 m_tick = 0;  // of the last state
  UInt32 m_numFromKey = 0;  // states since the last key frame, with it
  UInt64 m_numFloors = 0;
  std::string m_bytes;
};

}  // namespace argos

#endif
