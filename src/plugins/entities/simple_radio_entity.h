#ifndef ARGOS3_PLUGINS_ENTITIES_SIMPLE_RADIO_ENTITY_H
#define ARGOS3_PLUGINS_ENTITIES_SIMPLE_RADIO_ENTITY_H

#include <argos3/core/utility/datatypes/byte_array.h>
#include <argos3/core/utility/datatypes/set.h>
#include <argos3/plugins/simulator/entities/cell_updaters.h>
#include <argos3/plugins/simulator/entities/medium_member.h>
#include <argos3/plugins/simulator/entities/spare_elements.h>

#include <string>
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

  /** Received, unread messages, in order of arrival. */
  std::vector<CByteArray>& GetMessages() { return m_messages; }
  const std::vector<CByteArray>& GetMessages() const { return m_messages; }
  void ReceiveMessage(const CByteArray& message);

  /** Empties @p outbox; the medium sends its messages in the next TakeActs(). */
  void Send(std::vector<CByteArray>& outbox);
  /** Messages to be sent; for the medium. */
  const std::vector<CByteArray>& GetOutbox() const { return m_outbox; }
  void ClearOutbox() { m_outbox.clear(); }

  /** Swaps the received messages with the contents of @p read, which are reused; for sensors. */
  void Read(std::vector<CByteArray>& read);
  /** Returns messages from Read() for reuse of their memory; for sensors that are reset. */
  void TakeBack(std::vector<CByteArray>& read) { m_spare.Shrink(read, 0); }
  /** Drops messages that sensors had the chance to read; for the medium, once a tick. */
  void DropOldMessages();
  /** For the medium: appends messages, which become old in the next tick. */
  void Deliver(const std::vector<CByteArray>& messages);

  /** Enables recording of the senders' positions; for sensors that display them. */
  void SetRememberingOrigins(bool remember) {
    KeepForReset(m_remembersOrigins);
    m_remembersOrigins = remember;
  }
  /** For the medium: records the position of a sender, m, world frame. */
  void NoteOrigin(const CVector3& position);
  /** Positions of the senders of unread messages, m, world frame; cleared by Read(). */
  const std::vector<CVector3>& GetOrigins() const { return m_origins; }

  /** For the medium: index among its radios. */
  UInt32 GetNumberInMedium() const { return m_numberInMedium; }
  void SetNumberInMedium(UInt32 number) { m_numberInMedium = number; }

  void UpdateDigest(CDigest& digest) const override;

 private:
  Real m_range = 0.0;  // m
  std::vector<CByteArray> m_messages;  // received
  size_t m_numOld = 0;  // how many of them the next DropOldMessages() drops
  std::vector<CByteArray> m_outbox;
  CSpareElements<CByteArray> m_spare;
  bool m_remembersOrigins = false;
  std::vector<CVector3> m_origins;  // m, world frame
  UInt32 m_numberInMedium = 0;
};

/** Put a radio into its cell. */
using CSimpleRadioEntityGridUpdater = CCellGridUpdater<CSimpleRadioEntity>;
using CSimpleRadioEntitySpaceHashUpdater = CCellHashUpdater<CSimpleRadioEntity>;

}  // namespace argos

#endif
