#ifndef ARGOS3_CORE_SIMULATOR_ENTITY_ARRAY_SENSOR_H
#define ARGOS3_CORE_SIMULATOR_ENTITY_ARRAY_SENSOR_H

#include <argos3/core/simulator/entity/sensor.h>

#include <vector>

namespace argos {

/**
 * Base of simulated sensors that work on memory apart from the sensor, which the tick prefetches.
 *
 * The functions are called only after the robots of the space have changed, so an array that is
 * reallocated later is not prefetched.
 */
class CArraySensor : public CSimulatedSensor {
 public:
  struct SArray {
    const void* Start;
    UInt32 Bytes;
  };

  /** The array that Update() writes to. */
  virtual SArray GetReadingsArray() const = 0;
  /** Appends what else Update() reads for this robot only. */
  virtual void ListInputs(std::vector<SArray>& /*inputs*/) const {}

 protected:
  template <typename CONTAINER>
  static SArray ArrayOf(const CONTAINER& readings) {
    return {readings.data(), static_cast<UInt32>(readings.size() * sizeof(*readings.data()))};
  }
};

}  // namespace argos

#endif
