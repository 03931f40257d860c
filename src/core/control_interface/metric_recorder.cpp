#include <argos3/core/control_interface/metric_recorder.h>

namespace argos {

namespace {

// written once, before there are threads
TMetricRecorder currentRecorder = nullptr;

}  // namespace

void SetMetricRecorder(TMetricRecorder recorder) {
  currentRecorder = recorder;
}

void RecordMetric(std::string_view name, Real value, std::string_view unit) {
  if (currentRecorder != nullptr) {
    currentRecorder(name, value, unit);
  }
}

}  // namespace argos
