#ifndef ARGOS3_PLUGINS_ENTITIES_RAB_EQUIPPED_ENTITY_H
#define ARGOS3_PLUGINS_ENTITIES_RAB_EQUIPPED_ENTITY_H

#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/utility/datatypes/byte_array.h>
#include <argos3/core/utility/datatypes/set.h>
#include <argos3/plugins/simulator/entities/medium_member.h>

#include <string>
#include <vector>

namespace argos {

class CRABMedium;

/**
 * A range-and-bearing device: sends a message of fixed size all around, as far as its range.
 *
 * Starts disabled. While it is enabled and has a medium, the medium routes its messages.
 */
class CRABEquippedEntity : public CMediumMember<CRABEquippedEntity, CRABMedium> {
 public:
  ENABLE_VTABLE();

  typedef std::vector<CRABEquippedEntity*> TVector;
  typedef CSet<CRABEquippedEntity*, SEntityComparator> TSet;

  explicit CRABEquippedEntity(CComposableEntity* parent);
  /**
   * @param messageSize       bytes of every message.
   * @param range             how far messages reach, m, >= 0.
   * @param anchor            the frame that the device sits in, of @p body.
   * @param offset, rotation  of the device in that frame, m.
   * @throws CARGoSException if the range is not >= 0.
   */
  CRABEquippedEntity(CComposableEntity* parent, const std::string& id, size_t messageSize,
                     Real range, SAnchor& anchor, CEmbodiedEntity& body,
                     const CVector3& offset = CVector3(),
                     const CQuaternion& rotation = CQuaternion());
  ~CRABEquippedEntity() override;

  /**
   * Reads `id`, `anchor`, `range`, `msg_size`, and the optional `position` and `orientation` in the
   * frame of the anchor; the parent must have a "body" with that anchor.
   * @throws CARGoSException if a value is missing or out of range.
   */
  void Init(TConfigurationNode& tree) override;
  /** The message becomes all zeros; the device goes where its anchor is. */
  void Reset() override;
  /** Goes where the anchor is. */
  void Update() override;
  std::string GetTypeDescription() const override { return "rab"; }
  /** Also of the anchor; an enabled device goes where its anchor is. */
  void SetEnabled(bool enabled) override;

  CEmbodiedEntity& GetEntityBody() { return *m_body; }
  const CEmbodiedEntity& GetEntityBody() const { return *m_body; }
  const SAnchor& GetAnchor() const { return *m_anchor; }

  size_t GetMsgSize() const { return m_messageSize; }
  /** The message, GetMsgSize() bytes. */
  CByteArray& GetData() { return m_data; }
  const CByteArray& GetData() const { return m_data; }
  /** @throws CARGoSException unless @p data has GetMsgSize() bytes. */
  void SetData(const CByteArray& data);
  /** All zeros. */
  void ClearData() { m_data.Zero(); }

  /** m. */
  Real GetRange() const { return m_range; }
  /** @throws CARGoSException if it is not >= 0. */
  void SetRange(Real range);

  /** For the medium: which of its devices this one is. */
  UInt32 GetNumberInMedium() const { return m_numberInMedium; }
  void SetNumberInMedium(UInt32 number) { m_numberInMedium = number; }

  void UpdateDigest(CDigest& digest) const override;

 private:
  std::string Describe() const;

  size_t m_messageSize = 0;  // bytes
  Real m_range = 0.0;  // m
  SAnchor* m_anchor = nullptr;  // of m_body; null before Init()
  CEmbodiedEntity* m_body = nullptr;
  CVector3 m_offset;  // in the anchor's frame, m
  CQuaternion m_rotation;  // in the anchor's frame
  CByteArray m_data;
  UInt32 m_numberInMedium = 0;
};

}  // namespace argos

#endif
