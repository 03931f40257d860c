#ifndef ARGOS3_TESTING_CONTRACT_PHYSICS_ENGINES_BOARD_H
#define ARGOS3_TESTING_CONTRACT_PHYSICS_ENGINES_BOARD_H

#include <argos3/testing/contract/physics_engines/regions.h>
#include <argos3/testing/support/rooms.h>

#include <string>
#include <vector>

namespace argos {

/** A square arena divided among engines like a board, with a gate in every border. */
struct SBoard {
  static constexpr int kPerSide = 4; /**< engines */

  std::string Name;
  std::vector<SSharingEngine> Types; /**< in sequence, shifted by one in each row */

  const SSharingEngine& At(int column, int row) const {
    return Types[static_cast<size_t>(column + row) % Types.size()];
  }
  /** XML of the rooms' experiment in which these engines replace the engine. */
  std::string ToXml(const testing::SRoomsWorld& rooms) const;
};

/** One board for each type of engine, and one of all types. */
std::vector<SBoard> ListBoards();

}  // namespace argos

#endif
