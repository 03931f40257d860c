#ifndef ARGOS3_PLUGINS_ENTITIES_SIMPLE_RADIO_ENTITY_H
#define ARGOS3_PLUGINS_ENTITIES_SIMPLE_RADIO_ENTITY_H

#include <argos3/core/simulator/space/positional_indices/grid.h>
#include <argos3/core/simulator/space/positional_indices/space_hash.h>
#include <argos3/core/utility/datatypes/byte_array.h>
#include <argos3/core/utility/datatypes/set.h>
#include <argos3/core/utility/datatypes/spare_elements.h>
#include <argos3/plugins/simulator/entities/medium_member.h>

#include <string>
#include <vector>

namespace argos {

class CSimpleRadioMedium;

/**
 * A radio: what it sends reaches every other radio of its medium within its range, whatever stands
 * between.
 *
 * Starts disabled. The medium knows it exactly while it is enabled.
 */
class CSimpleRadioEntity : public CMediumMember<CSimpleRadioEntity, CSimpleRadioMedium> {
 public:
  ENABLE_VTABLE();

  typedef std::vector<CSimpleRadioEntity*> TVector;
  typedef std::vector<CSimpleRadioEntity*> TList;
  typedef CSet<CSimpleRadioEntity*, SEntityComparator> TSet;

  explicit CSimpleRadioEntity(CComposableEntity* parent);
  /** @param range how far messages reach, m, >= 0. @throws CARGoSException if it is not. */
  CSimpleRadioEntity(CComposableEntity* parent, const std::string& id, Real range);
  ~CSimpleRadioEntity() override;

  /** Reads `range` and the pose. */
  void Init(TConfigurationNode& tree) override;
  /** Without messages. */
  void Reset() override;
  std::string GetTypeDescription() const override { return "radio"; }

  /** m. */
  Real GetRange() const { return m_range; }
  /** @throws CARGoSException if it is not >= 0. */
  void SetRange(Real range);

  /** What was received and not read yet, in order of arrival. */
  std::vector<CByteArray>& GetMessages() { return m_messages; }
  const std::vector<CByteArray>& GetMessages() const { return m_messages; }
  void ReceiveMessage(const CByteArray& message);

  /** Sends the messages of @p outbox with the next TakeActs() of the medium, and empties it. */
  void Send(std::vector<CByteArray>& outbox);
  /** What waits to be sent; for the medium. */
  const std::vector<CByteArray>& GetOutbox() const { return m_outbox; }
  void ClearOutbox() { m_outbox.clear(); }

  /** Exchanges the messages received for those of @p read, which are used again; for sensors. */
  void Read(std::vector<CByteArray>& read);
  /** Takes back what Read() gave, for its memory; for sensors that are reset. */
  void TakeBack(std::vector<CByteArray>& read) { m_spare.Shrink(read, 0); }
  /** Drops messages that a sensor could have read; for the medium, once a tick. */
  void DropOldMessages();
  /** For the medium: takes over messages, which are old in the next tick. */
  void Deliver(const std::vector<CByteArray>& messages);

  /** For sensors that show whom they hear: whether to remember where messages come from. */
  void SetRememberingOrigins(bool remember) { m_remembersOrigins = remember; }
  /** For the medium: notes where a sender is, m, world frame. */
  void NoteOrigin(const CVector3& position);
  /** Where the senders of unread messages were, m, world frame; cleared by Read(). */
  const std::vector<CVector3>& GetOrigins() const { return m_origins; }

  /** For the medium: which of its radios this one is. */
  UInt32 GetNumberInMedium() const { return m_numberInMedium; }
  void SetNumberInMedium(UInt32 number) { m_numberInMedium = number; }

  void UpdateDigest(CDigest& digest) const override;

 private:
  Real m_range = 0.0;  // m
  std::vector<CByteArray> m_messages;  // received
  size_t m_numOld = 0;  // of them, for the next DropOldMessages()
  std::vector<CByteArray> m_outbox;
  CSpareElements<CByteArray> m_spare;
  bool m_remembersOrigins = false;
  std::vector<CVector3> m_origins;  // m, world frame
  UInt32 m_numberInMedium = 0;
};

/** Puts a radio into its cell of a grid. */
class CSimpleRadioEntityGridUpdater : public CGrid<CSimpleRadioEntity>::COperation {
 public:
  explicit CSimpleRadioEntityGridUpdater(CGrid<CSimpleRadioEntity>& grid) : m_grid(grid) {}
  bool operator()(CSimpleRadioEntity& radio) override;

 private:
  CGrid<CSimpleRadioEntity>& m_grid;
};

/** Puts a radio into its cell of a space hash. */
class CSimpleRadioEntitySpaceHashUpdater : public CSpaceHashUpdater<CSimpleRadioEntity> {
 public:
  void operator()(CAbstractSpaceHash<CSimpleRadioEntity>& hash, CSimpleRadioEntity& radio) override;
};

}  // namespace argos

#endif
