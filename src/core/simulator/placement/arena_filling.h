#ifndef ARGOS3_CORE_SIMULATOR_PLACEMENT_ARENA_FILLING_H
#define ARGOS3_CORE_SIMULATOR_PLACEMENT_ARENA_FILLING_H

#include <argos3/core/simulator/context/load_errors.h>
#include <argos3/core/simulator/placement/distribution.h>
#include <argos3/core/utility/configuration/argos_configuration.h>

#include <sys/types.h>

#include <memory>
#include <vector>

namespace argos {

class CSpace;

/** The entities that `<arena>` declares, and the choice of places for its `<distribute>` elements.
 */
class CArenaFilling {
 public:
  /**
   * Creates the entities in document order, then those of the `<distribute>` elements. A failure is
   * recorded in @p errors, and loading continues with the next entity.
   *
   * Reads the attribute `redistribute`. @param arena  must exist as long as this object.
   */
  CArenaFilling(CSpace& space, TConfigurationNode& arena, CLoadErrors& errors);

  /** @return true if each reset must call Redistribute(): `redistribute="true"`. */
  bool IsRedistributedByReset() const { return m_isRedistributedByReset; }
  /**
   * Draws the places of all distributed entities again, as loading does, from the present state of
   * the space's random generator: they become the initial poses, which Reset() restores.
   *
   * Places are free of the bodies that the file declares, at their initial poses. Entities that
   * were removed keep their turn.
   * @throws CARGoSException as loading does if there is no free place, or if only an engine knows
   *   the shape of a body; no initial pose has changed then.
   */
  void Redistribute();

 private:
  CSpace& m_space;
  std::vector<std::unique_ptr<CDistribution>> m_distributions;
  ssize_t m_endOfSingles = 0;  // one more than the greatest index of entities that stand alone
  bool m_isRedistributedByReset = false;
};

}  // namespace argos

#endif
