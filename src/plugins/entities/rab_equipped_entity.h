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
 * A range-and-bearing device: sends a message of fixed size in all directions, up to its range.
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
   * @param messageSize       size of every message, bytes.
   * @param range             range of messages, m, >= 0.
   * @param anchor            the device's frame, an anchor of @p body.
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
  /** Clears the message; moves the device to its anchor's pose. */
  void Reset() override;
  /** Moves the device to its anchor's pose. */
  void Update() override;
  std::string GetTypeDescription() const override { return "rab"; }
  /**
   * Also enables or disables the use of the anchor; an enabled device moves to its anchor's pose.
   */
  void SetEnabled(bool enabled) override;

  CEmbodiedEntity& GetEntityBody() { return *m_pcEntityBody; }
  const CEmbodiedEntity& GetEntityBody() const { return *m_pcEntityBody; }
  const SAnchor& GetAnchor() const { return *m_psAnchor; }

  /** Greatest size of a message, bytes. */
  static constexpr size_t kMaxData = 65535;
  size_t GetMsgSize() const { return m_unMsgSize; }
  /** The message, GetMsgSize() bytes. */
  CByteArray& GetData() { return m_cData; }
  const CByteArray& GetData() const { return m_cData; }
  /**
   * By code of its own robot: takes effect when all robots have been controlled (CRobotsCode).
   * @throws CARGoSException unless @p data has GetMsgSize() bytes.
   */
  void SetData(const CByteArray& data);
  /** Sets all bytes of the message to 0; as SetData(). */
  void ClearData();

  /** Range of messages, m. */
  Real GetRange() const { return m_fRange; }
  /** @throws CARGoSException if the range is not >= 0. */
  void SetRange(Real range);

  /** For the medium: index among its devices. */
  UInt32 GetNumberInMedium() const { return m_numberInMedium; }
  void SetNumberInMedium(UInt32 number) { m_numberInMedium = number; }

  void UpdateDigest(CDigest& digest) const override;

 protected:
  // a derived class may set them itself; MoveTo() follows them at the next Update()
  size_t m_unMsgSize = 0;  // bytes
  Real m_fRange = 0.0;  // m
  SAnchor* m_psAnchor = nullptr;  // anchor of m_pcEntityBody; null before Init()
  CEmbodiedEntity* m_pcEntityBody = nullptr;
  CVector3 m_cPosOffset;  // offset in the anchor's frame, m
  CQuaternion m_cRotOffset;  // offset in the anchor's frame
  CByteArray m_cData;

 private:
  std::string Describe() const;

  UInt32 m_numberInMedium = 0;
};

}  // namespace argos

#endif
