#ifndef ARGOS3_TESTING_SCENARIO_MUTATIONS_MUTATORS_H
#define ARGOS3_TESTING_SCENARIO_MUTATIONS_MUTATORS_H

#include <cstdint>
#include <string>

namespace argos {

/** What is changed in a file. */
enum class EMutation {
  Attribute,  // a value, a name, or an attribute removed or repeated elsewhere
  Element,  // removed, duplicated, renamed, moved, nested, or with text
  File  // truncated, or bytes flipped, removed, inserted or repeated
};

/**
 * Changes a well-formed experiment file at one to three places.
 *
 * The result depends on the arguments only, on every platform.
 * @param description  set to what was done, for messages.
 */
std::string Mutate(const std::string& xml, EMutation mutation, std::uint64_t seed,
                   std::string& description);

}  // namespace argos

#endif
