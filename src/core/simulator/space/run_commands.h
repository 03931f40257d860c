#ifndef ARGOS3_CORE_SIMULATOR_SPACE_RUN_COMMANDS_H
#define ARGOS3_CORE_SIMULATOR_SPACE_RUN_COMMANDS_H

#include <argos3/core/simulator/space/space.h>
#include <argos3/core/utility/datatypes/datatypes.h>

#include <string>
#include <utility>
#include <vector>

namespace argos {

/** What a user has changed in a run while it was running, on its way into a recording. */
class CRunCommands : public CSpaceExtension {
 public:
  struct SCommand {
    UInt32 Tick; /**< tick after which it was given */
    std::string Text; /**< has a form that the senders of commands know */
  };

  /** Commands are kept from now on, for an output that takes them. */
  void Keep() { m_areKept = true; }
  void Add(UInt32 tick, std::string text) {
    if (m_areKept) {
      m_commands.push_back({tick, std::move(text)});
    }
  }
  /** @return those since the last call, in order. */
  std::vector<SCommand> Take() { return std::exchange(m_commands, {}); }

 private:
  bool m_areKept = false;
  std::vector<SCommand> m_commands;
};

}  // namespace argos

#endif
