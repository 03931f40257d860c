#ifndef ARGOS3_PROGRAM_CATALOGUE_INTERFACE_CLASS_H
#define ARGOS3_PROGRAM_CATALOGUE_INTERFACE_CLASS_H

#include <string>
#include <typeinfo>

namespace argos {

/** The class of the control interface that a device implements. */
struct SInterfaceClass {
  std::string Name; /**< "CCI_LEDsActuator"; "" if there is none */
  std::string Library; /**< the file that contains it */
};

/**
 * Finds the most derived base class whose name begins with "CCI_". The compiler's type information
 * lists bases (Itanium C++ ABI), so that devices need not name their interface.
 * @param device  the class of the simulated device.
 */
SInterfaceClass FindInterfaceClass(const std::type_info& device);

}  // namespace argos

#endif
