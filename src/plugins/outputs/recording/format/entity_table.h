#ifndef ARGOS3_PLUGINS_OUTPUTS_RECORDING_FORMAT_ENTITY_TABLE_H
#define ARGOS3_PLUGINS_OUTPUTS_RECORDING_FORMAT_ENTITY_TABLE_H

#include <argos3/plugins/simulator/outputs/recording/format/recorded_frame.h>
#include <argos3/support/byte_stream.h>

#include <vector>

namespace argos {

/**
 * The types and entities of a recording at one tick, and how many poses and words they have.
 * Encoder and decoder keep one each, in step.
 */
class CEntityTable {
 public:
  /** Which poses and words an update removes, by place before it; and how many it adds. */
  struct SChange {
    bool IsRestart = false;
    bool IsEmpty = true;
    std::vector<bool> RemovedPoses;
    std::vector<bool> RemovedWords;
    size_t NumAddedPoses = 0;
    size_t NumAddedWords = 0;
  };

  const std::vector<SRecordedType>& GetTypes() const { return m_types; }
  const std::vector<SRecordedEntity>& GetEntities() const { return m_entities; }
  size_t GetNumPoses() const { return m_numPoses; }
  size_t GetNumWords() const { return m_numWords; }

  /**
   * Takes types and entities out of the update.
   * @throws CARGoSException if they do not fit to the table, or make it too large.
   */
  SChange Apply(SFrameUpdate& update);

  /** Writes the changes of an update. */
  static void WriteChanges(const SFrameUpdate& update, CByteWriter& out);
  /** Writes the whole table, as an update with IsRestart. */
  void WriteAll(CByteWriter& out) const;
  /** Reads what either has written. @throws CARGoSException */
  static SFrameUpdate ReadChanges(CByteReader& in);

 private:
  void Remove(const std::vector<UInt32>& removed, SChange& change);
  void Add(std::vector<SRecordedEntity>&& added, SChange& change);

  std::vector<SRecordedType> m_types;
  std::vector<SRecordedEntity> m_entities;
  size_t m_numPoses = 0;
  size_t m_numWords = 0;
};

}  // namespace argos

#endif
