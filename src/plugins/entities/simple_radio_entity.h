#ifndef ARGOS3_PLUGINS_ENTITIES_SIMPLE_RADIO_ENTITY_H
#define ARGOS3_PLUGINS_ENTITIES_SIMPLE_RADIO_ENTITY_H

#include <argos3/core/utility/datatypes/byte_array.h>
#include <argos3/core/utility/datatypes/set.h>
#include <argos3/core/utility/math/vector3.h>
#include <argos3/plugins/simulator/entities/cell_updaters.h>
#include <argos3/plugins/simulator/entities/medium_member.h>
#include <argos3/plugins/simulator/entities/spare_elements.h>

#include <string>
#include <utility>
#include <vector>

namespace argos {

class CSimpleRadioMedium;

/**
 * A radio: its messages reach every other radio of its medium within its range, through obstacles.
 *
 * Starts disabled. The medium contains it exactly while it is enabled.
 */
class CSimpleRadioEntity : public CMediumMember<CSimpleRadioEntity, CSimpleRadioMedium> {
 public:
  ENABLE_VTABLE();

  typedef std::vector<CSimpleRadioEntity*> TVector;
  typedef std::vector<CSimpleRadioEntity*> TList;
  typedef CSet<CSimpleRadioEntity*, SEntityComparator> TSet;

  explicit CSimpleRadioEntity(CComposableEntity* parent);
  /** @param range range of messages, m, >= 0. @throws CARGoSException if it is out of range. */
  CSimpleRadioEntity(CComposableEntity* parent, const std::string& id, Real range);
  ~CSimpleRadioEntity() override;

  /** Reads `range` and the pose. */
  void Init(TConfigurationNode& tree) override;
  /** Removes all messages. */
  void Reset() override;
  std::string GetTypeDescription() const override { return "radio"; }

  /** Range of messages, m. */
  Real GetRange() const { return m_range; }
  /** @throws CARGoSException if the range is not >= 0. */
  void SetRange(Real range);

  /** A message, and where its sender was, m, world frame. */
  typedef std::pair<CVector3, CByteArray> TMessage;

  /** Received, unread messages, in order of arrival. */
  std::vector<TMessage>& GetMessages() { return m_messages; }
  const std::vector<TMessage>& GetMessages() const { return m_messages; }
  bool HasMessages() const { return !m_messages.empty(); }
  /** @param origin  position of the sender, m, world frame. */
  void ReceiveMessage(const CVector3& origin, const CByteArray& message);

  /** Empties @p outbox; the medium sends its messages in the next TakeActs(). */
  void Send(std::vector<CByteArray>& outbox);
  /** Messages to be sent; for the medium. */
  const std::vector<CByteArray>& GetOutbox() const { return m_outbox; }
  void ClearOutbox() { m_outbox.clear(); }

  /** Replaces @p read, whose memory is reused, by the received messages; for sensors. */
  void Read(std::vector<CByteArray>& read);
  /** Returns messages from Read() for reuse of their memory; for sensors that are reset. */
  void TakeBack(std::vector<CByteArray>& read) { m_spareBytes.Shrink(read, 0); }
  /** Drops messages that sensors had the chance to read; for the medium, once a tick. */
  void DropOldMessages();
  /** For the medium: appends messages of one sender, which become old in the next tick. */
  void Deliver(const CVector3& origin, const std::vector<CByteArray>& messages);

  /** For the medium: index among its radios. */
  UInt32 GetNumberInMedium() const { return m_numberInMedium; }
  void SetNumberInMedium(UInt32 number) { m_numberInMedium = number; }

  void UpdateDigest(CDigest& digest) const override;

 private:
  Real m_range = 0.0;  // m
  std::vector<TMessage> m_messages;  // received
  size_t m_numOld = 0;  // number of them that the next DropOldMessages() drops
  std::vector<CByteArray> m_outbox;
  CSpareElements<TMessage> m_spare;
  CSpareElements<CByteArray> m_spareBytes;  // bytes of messages that have been read
  UInt32 m_numberInMedium = 0;
};

/** Put a radio into its cell. */
using CSimpleRadioEntityGridUpdater = CCellGridUpdater<CSimpleRadioEntity>;
using CSimpleRadioEntitySpaceHashUpdater = CCellHashUpdater<CSimpleRadioEntity>;

}  // namespace argos

#endif
