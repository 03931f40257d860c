#ifndef ARGOS3_PLUGINS_MEDIA_SIMPLE_RADIO_MEDIUM_H
#define ARGOS3_PLUGINS_MEDIA_SIMPLE_RADIO_MEDIUM_H

#include <argos3/plugins/simulator/entities/simple_radio_entity.h>
#include <argos3/plugins/simulator/media/positional_medium.h>

#include <memory>

namespace argos {

/**
 * Transmits messages between radios, through obstacles.
 *
 * A message reaches every other radio within the sender's range, directly after the actuators,
 * before any motion. Receivers get messages in the order of their senders' insertion into the
 * space. The index contains all radios, as of the last Update().
 */
class CSimpleRadioMedium
    : public CPositionalMedium<CSimpleRadioEntity, CSimpleRadioEntityGridUpdater,
                               CSimpleRadioEntitySpaceHashUpdater> {
 public:
  CSimpleRadioMedium();
  ~CSimpleRadioMedium() override;

  void TakeActs() override;
  bool CanBePeriodic() const override { return true; }
  CSimpleRadioMedium& AsMedium() override { return *this; }
  void Reset() override;

  /** Messages delivered in the last tick, times their receivers. */
  UInt64 GetNumDelivered() const;

 private:
  struct SState;  // radios and their cells

  void Insert(CSimpleRadioEntity& radio) override;
  void Erase(CSimpleRadioEntity& radio) override;
  void SortByCell();
  void Deliver(CSimpleRadioEntity& sender);
  void DeliverTo(CSimpleRadioEntity& sender, const CVector3& displacement);

  std::unique_ptr<SState> m_state;
};

}  // namespace argos

#endif
