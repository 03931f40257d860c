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
 * A passive radio tag: a memory of fixed size that robots nearby read and write.
 *
 * It lies in the arena, as a root entity, or is carried by a body (CRFIDTagEquippedEntity). It has
 * no body of its own. Starts disabled; the medium knows it exactly while it is enabled.
 */
class CRFIDTagEntity : public CMediumMember<CRFIDTagEntity, CRFIDMedium> {
 public:
  ENABLE_VTABLE();

  typedef std::vector<CRFIDTagEntity*> TList;

  /** A tag that lies in the arena, to be initialised from XML. */
  CRFIDTagEntity();
  /** A tag that is carried. */
  explicit CRFIDTagEntity(CComposableEntity* parent);
  /**
   * A tag without a medium: nobody reads it until SetMedium() and Enable().
   * @param parent    null: the tag lies in the arena.
   * @param position  m, world frame.
   * @param data      the memory: its size is that of the tag's memory.
   */
  CRFIDTagEntity(CComposableEntity* parent, const std::string& id, const CVector3& position,
                 const CByteArray& data);
  ~CRFIDTagEntity() override;

  /**
   * Reads `memory` (bytes, default 16), `data` (numbers from 0 to 255 with commas between, default
   * none; the rest is 0) and the pose; of a tag that lies in the arena also `medium`, which it
   * enters.
   * @throws CARGoSException if a value is out of range, or the data does not fit.
   */
  void Init(TConfigurationNode& tree) override;
  /** Back to the initial data and pose. */
  void Reset() override;
  std::string GetTypeDescription() const override { return "rfid_tag"; }

  /** Bytes of the memory. */
  size_t GetMemorySize() const { return m_data.Size(); }
  /** The whole memory. */
  const CByteArray& GetData() const { return m_data; }
  /** @throws CARGoSException unless @p data has GetMemorySize() bytes. */
  void SetData(const CByteArray& data);
  const CByteArray& GetInitData() const { return m_initData; }
  /** Writes bytes from place @p offset on. @return false, with nothing written, if they do not fit.
   */
  bool TryWrite(size_t offset, const CByteArray& bytes);

  /** What readers see of it: its id with those of its parents, "t1" or "box.rfid_tags_0.t1". */
  const std::string& GetTagId() const;

  /** Only a tag that lies in the arena is drawn on its own. */
  const SAppearance* GetAppearance() const override;
  void UpdateDigest(CDigest& digest) const override;

  /** For the medium: which of its tags this one is. */
  UInt32 GetNumberInMedium() const { return m_numberInMedium; }
  void SetNumberInMedium(UInt32 number);

 private:
  CByteArray m_data;
  CByteArray m_initData;
  std::string m_tagId;  // empty until the medium numbers the tag
  UInt32 m_numberInMedium = 0;
};

/** How a tag is drawn, in the frame of what it is on. @param position of its centre, m. */
SVisualPart MakeRFIDTagPart(const CVector3& position);

}  // namespace argos

#endif
