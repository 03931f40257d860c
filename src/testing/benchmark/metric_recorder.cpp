// A controller that records a metric several times in each step, and does nothing else.

#include <argos3/core/control_interface/ci_controller.h>
#include <argos3/core/simulator/simulator.h>
#include <argos3/core/simulator/space/metrics.h>

using namespace argos;

namespace {

class CMetricRecorder : public CCI_Controller {
 public:
  void Init(TConfigurationNode& params) override { GetNodeAttribute(params, "records", m_records); }
  void ControlStep() override {
    if (m_records == 0) {
      return;
    }
    CMetrics& metrics = CSimulator::GetInstance().GetMetrics();
    for (UInt32 i = 0; i < m_records; ++i) {
      metrics.Record("recorded", i);
    }
  }

 private:
  UInt32 m_records = 0;  // calls in a step
};

}  // namespace

REGISTER_CONTROLLER(CMetricRecorder, "metric_recorder");
