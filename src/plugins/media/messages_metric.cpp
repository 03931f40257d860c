// The built-in metric "messages".

#include <argos3/core/simulator/simulator.h>
#include <argos3/core/simulator/space/built_in_metric.h>
#include <argos3/core/simulator/space/space.h>
#include <argos3/plugins/simulator/media/rab_medium.h>
#include <argos3/plugins/simulator/media/simple_radio_medium.h>

#include <vector>

namespace argos {

class CMessagesMetric : public CBuiltInMetric {
 public:
  void Init(CSpace& space) override {
    for (const CMedium* medium : space.GetSimulator().GetMedia()) {
      if (const auto* const rab = dynamic_cast<const CRABMedium*>(medium)) {
        m_rabMedia.push_back(rab);
      } else if (const auto* const radio = dynamic_cast<const CSimpleRadioMedium*>(medium)) {
        m_radioMedia.push_back(radio);
      }
    }
    if (m_rabMedia.empty() && m_radioMedia.empty()) {
      THROW_ARGOSEXCEPTION(
          "<media> has neither <range_and_bearing> nor <simple_radio>, whose messages are counted");
    }
  }

  Real Compute() override {
    UInt64 count = 0;
    for (const CRABMedium* medium : m_rabMedia) {
      count += medium->GetNumDelivered();
    }
    for (const CSimpleRadioMedium* medium : m_radioMedia) {
      count += medium->GetNumDelivered();
    }
    return static_cast<Real>(count);
  }

 private:
  std::vector<const CRABMedium*> m_rabMedia;
  std::vector<const CSimpleRadioMedium*> m_radioMedia;
};

REGISTER_BUILT_IN_METRIC(
    CMessagesMetric, "messages", "the authors of this project", "1.0",
    "The number of messages that robots receive in the tick, by range and bearing and by radio.",
    R"(A message counts once for each device that it reaches in the tick: of range and bearing, one for each pair of
sender and receiver as long as the sender is in range and sight, whatever its data; of simple radios, each message
times its receivers. Messages that a sensor drops by its own noise count. The sum of all media <range_and_bearing> and
<simple_radio>, one of which is required.

  <metrics file="metrics.csv" builtin="messages" />
)",
    "Usable")

}  // namespace argos
