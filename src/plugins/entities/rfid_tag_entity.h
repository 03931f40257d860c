#ifndef ARGOS3_PLUGINS_ENTITIES_RFID_TAG_ENTITY_H
#define ARGOS3_PLUGINS_ENTITIES_RFID_TAG_ENTITY_H

#include <argos3/core/simulator/visualization/appearance.h>
#include <argos3/core/utility/datatypes/byte_array.h>
#include <argos3/plugins/simulator/entities/medium_member.h>

#include <string>
#include <vector>

namespace argos {

class CRFIDMedium;

/**
 * A passive radio tag: a memory of fixed size that nearby robots can read and write.
 *
 * It is a root entity of the arena, or is mounted on a body (CRFIDTagEquippedEntity). It has no
 * body of its own. Starts disabled; the medium contains it exactly while it is enabled.
 */
class CRFIDTagEntity : public CMediumMember<CRFIDTagEntity, CRFIDMedium> {
 public:
  ENABLE_VTABLE();

  typedef std::vector<CRFIDTagEntity*> TList;

  /** A tag in the arena, to be initialised from XML. */
  CRFIDTagEntity();
  /** A mounted tag. */
  explicit CRFIDTagEntity(CComposableEntity* parent);
  /**
   * A tag without a medium: it cannot be read before SetMedium() and Enable().
   * @param parent    null: the tag is in the arena.
   * @param position  m, world frame.
   * @param data      the memory; defines its size.
   */
  CRFIDTagEntity(CComposableEntity* parent, const std::string& id, const CVector3& position,
                 const CByteArray& data);
  ~CRFIDTagEntity() override;

  /**
   * Reads `memory` (bytes, default 16), `data` (numbers from 0 to 255 separated by commas, default
   * none; the rest is 0) and the pose; for a tag in the arena also `medium`.
   * @throws CARGoSException if a value is out of range, or the data exceed the memory.
   */
  void Init(TConfigurationNode& tree) override;
  /** Restores the initial data and pose. */
  void Reset() override;
  std::string GetTypeDescription() const override { return "rfid_tag"; }

  /** Size of the memory, bytes. */
  size_t GetMemorySize() const { return m_data.Size(); }
  /** The whole memory. */
  const CByteArray& GetData() const { return m_data; }
  /** @throws CARGoSException unless @p data has GetMemorySize() bytes. */
  void SetData(const CByteArray& data);
  const CByteArray& GetInitData() const { return m_initData; }
  /** Writes bytes from @p offset on. @return false, without writing, if they do not fit. */
  bool TryWrite(size_t offset, const CByteArray& bytes);

  /** The id that readers report, with the ids of the parents: "t1" or "box.rfid_tags_0.t1". */
  const std::string& GetTagId() const;

  /** Null for a mounted tag, which is drawn with its body. */
  const SAppearance* GetAppearance() const override;
  void UpdateDigest(CDigest& digest) const override;

  /** For the medium: index among its tags. */
  UInt32 GetNumberInMedium() const { return m_numberInMedium; }
  void SetNumberInMedium(UInt32 number);

 private:
  CByteArray m_data;
  CByteArray m_initData;
  std::string m_tagId;  // empty until the tag has its number in the medium
  UInt32 m_numberInMedium = 0;
};

/** Appearance of a tag, in the frame of its carrier. @param position of its centre, m. */
SVisualPart MakeRFIDTagPart(const CVector3& position);

}  // namespace argos

#endif
