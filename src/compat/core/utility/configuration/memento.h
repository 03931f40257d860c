#ifndef ARGOS3_COMPAT_CORE_UTILITY_CONFIGURATION_MEMENTO_H
#define ARGOS3_COMPAT_CORE_UTILITY_CONFIGURATION_MEMENTO_H

#include <argos3/core/utility/datatypes/byte_array.h>

namespace argos {

/** An object whose state can be saved and restored. */
class CMemento {
 public:
  virtual ~CMemento() = default;

  /** Appends the state to the buffer. */
  virtual void SaveState(CByteArray& buffer) = 0;

  /**
   * Restores the state from the front of the buffer.
   * @throws CARGoSException if the buffer is too short.
   */
  virtual void LoadState(CByteArray& buffer) = 0;
};

}  // namespace argos

#endif
