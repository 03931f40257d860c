#ifndef ARGOS3_CORE_CONTROL_INTERFACE_METRIC_RECORDER_H
#define ARGOS3_CORE_CONTROL_INTERFACE_METRIC_RECORDER_H

#include <argos3/core/utility/datatypes/datatypes.h>

#include <string_view>

namespace argos {

/** Records a metric of the calling thread's simulation; may throw. */
using TMetricRecorder = void (*)(std::string_view name, Real value, std::string_view unit);

/** Sets what RecordMetric() calls, in the whole process; the simulator does when it is loaded. */
void SetMetricRecorder(TMetricRecorder recorder);

/**
 * Records a metric of the run, see CMetrics::Record(); for controllers that are also compiled for
 * real robots, where it does nothing.
 * @throws CARGoSException as CMetrics::Record().
 */
void RecordMetric(std::string_view name, Real value, std::string_view unit = {});

}  // namespace argos

#endif
