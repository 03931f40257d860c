#ifndef ARGOS3_PLUGINS_OUTPUTS_RECORDING_FORMAT_FRAME_CODING_H
#define ARGOS3_PLUGINS_OUTPUTS_RECORDING_FORMAT_FRAME_CODING_H

#include <argos3/plugins/simulator/outputs/recording/format/entity_table.h>
#include <argos3/plugins/simulator/outputs/recording/format/pose_columns.h>
#include <argos3/plugins/simulator/outputs/recording/format/ray_columns.h>
#include <argos3/plugins/simulator/outputs/recording/format/recorded_frame.h>

#include <memory>
#include <string>
#include <vector>

namespace argos {

/** Values of users' choice in time; new ones are predicted as 0. */
class CNamedColumns {
 public:
  void Restart() { m_columns.clear(); }
  void Encode(const std::vector<SRecordedColumn>& columns, CByteWriter& out);
  /** @throws CARGoSException */
  void Decode(std::vector<SRecordedColumn>& columns, size_t numEntities, CByteReader& in);

 private:
  CPredictedColumn& Get(size_t number, size_t size);

  std::vector<CPredictedColumn> m_columns;
  std::vector<SInt64> m_values;
};

/**
 * Codes frames as differences to the frame before. A key frame needs none: decoding may start
 * there. The floor of a key frame is not part of it: the file has it apart (recording_file.h).
 *
 * Bytes of a frame: its length; tick; 1 for a key frame, else 0; then sections, each with number,
 * length and content. A reader skips sections that it does not know.
 */
class CFrameEncoder {
 public:
  explicit CFrameEncoder(EPrecision precision) : m_poses(precision), m_rays(precision) {}

  /**
   * Appends a frame, and takes new types and entities out of the update.
   * @param isKey  must be true of the first one, and if size or existence of the floor has changed.
   */
  void Encode(SFrameUpdate& update, bool isKey, std::string& bytes);
  const CEntityTable& GetTable() const { return m_table; }

 private:
  template <typename WRITE>
  void AddSection(int number, WRITE&& write);
  void Resize(const CEntityTable::SChange& change);
  void EncodeWords(const std::vector<UInt32>& words, CByteWriter& out);

  CEntityTable m_table;
  CPoseColumns m_poses;
  CRayColumns m_rays;
  CNamedColumns m_columns;
  std::vector<UInt32> m_words;  // words of the last frame
  std::shared_ptr<const SRecordedFloor> m_floor;  // floor of the last frame
  std::string m_drawing;  // drawing of the last frame
  std::string m_body;
  std::string m_section;
};

/** Decodes what CFrameEncoder coded. Any bytes give frames or an exception. */
class CFrameDecoder {
 public:
  explicit CFrameDecoder(EPrecision precision) : m_poses(precision), m_rays(precision) {}

  /** The floor of the next frame, if that is a key frame. */
  void SetFloor(std::shared_ptr<const SRecordedFloor> floor) { m_frame.Floor = std::move(floor); }
  /**
   * Reads the next frame.
   * @param isKey  true: it must be a key frame; false: it must be none.
   * @throws CARGoSException if the bytes are none; then the next one must be a key frame.
   */
  const SRecordedFrame& Decode(CByteReader& in, bool isKey);
  /** The last one; without a tick, types and entities before the first. */
  const SRecordedFrame& GetFrame() const { return m_frame; }

 private:
  void DecodeSection(UInt64 number, CByteReader& in);
  void ReadEntities(CByteReader& in);
  void DecodeWords(CByteReader& in);

  CEntityTable m_table;
  CPoseColumns m_poses;
  CRayColumns m_rays;
  CNamedColumns m_columns;
  SRecordedFrame m_frame;
  bool m_isKey = false;
};

/** Writes the rows of pixels that differ; the sizes must be equal. */
void WriteFloorChange(const SRecordedFloor& before, const SRecordedFloor& now, CByteWriter& out);
/** @throws CARGoSException */
std::shared_ptr<const SRecordedFloor> ReadFloorChange(const SRecordedFloor& before,
                                                      CByteReader& in);
/** A floor on its own. */
void WriteFloor(const SRecordedFloor& floor, CByteWriter& out);
/** @throws CARGoSException */
std::shared_ptr<const SRecordedFloor> ReadFloor(CByteReader& in);

}  // namespace argos

#endif
