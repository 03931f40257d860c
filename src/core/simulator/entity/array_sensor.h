#ifndef ARGOS3_CORE_SIMULATOR_ENTITY_ARRAY_SENSOR_H
#define ARGOS3_CORE_SIMULATOR_ENTITY_ARRAY_SENSOR_H

#include <argos3/core/simulator/entity/sensor.h>

namespace argos {

/** Base of simulated sensors whose readings are in an array apart from the sensor. */
class CArraySensor : public CSimulatedSensor {
 public:
  struct SArray {
    const void* Start;
    UInt32 Bytes;
  };

  /**
   * The array that Update() writes to, which the tick prefetches. Called only after the robots of
   * the space have changed, so an array that is reallocated later is not prefetched.
   */
  virtual SArray GetReadingsArray() const = 0;

 protected:
  template <typename CONTAINER>
  static SArray ArrayOf(const CONTAINER& readings) {
    return {readings.data(), static_cast<UInt32>(readings.size() * sizeof(*readings.data()))};
  }
};

}  // namespace argos

#endif
