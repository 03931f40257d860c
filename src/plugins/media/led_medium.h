#ifndef ARGOS3_PLUGINS_MEDIA_LED_MEDIUM_H
#define ARGOS3_PLUGINS_MEDIA_LED_MEDIUM_H

#include <argos3/core/simulator/medium/medium.h>
#include <argos3/core/simulator/space/positional_indices/positional_index.h>
#include <argos3/plugins/simulator/entities/led_entity.h>

#include <memory>
#include <vector>

namespace argos {

/**
 * Knows where the LEDs are, for cameras.
 *
 * Holds the enabled LEDs whose medium it is. Its index has those that were lit at the last
 * Update(); LEDs beyond the arena are in it like all others.
 */
class CLEDMedium : public CMedium, public CLEDEntity::CRegistry {
 public:
  CLEDMedium();
  ~CLEDMedium() override;

  /**
   * Reads `id`, `index` ("grid" or "hash") and `grid_size` (cells along each axis).
   * @throws CARGoSException if a value is unknown or out of range.
   */
  void Init(TConfigurationNode& tree) override;
  /** The LEDs enabled at the start are listed in the order they had then. */
  void Reset() override;
  /** Lets go of all LEDs. */
  void Destroy() override;
  void PostSpaceInit() override;
  void Update() override;

  /** Called by the LED when it is enabled and disabled. */
  void AddEntity(CLEDEntity& led) override;
  void RemoveEntity(CLEDEntity& led) override;
  CLEDMedium& AsMedium() override { return *this; }

  /** The LEDs lit, as of the last Update(). Queries are safe on several threads at once. */
  CPositionalIndex<CLEDEntity>& GetIndex();

 private:
  enum class EIndex { Grid, Hash };

  void ReadGridSize(TConfigurationNode& tree);
  void MakeIndex();
  void SortByEntityIndex();

  EIndex m_kind = EIndex::Grid;
  SInt32 m_gridSize[3] = {0, 0, 0};  // cells along x, y, z; 0: chosen from the arena
  std::vector<CLEDEntity*> m_waiting;  // added before the index was made; not owned
  std::unique_ptr<CPositionalIndex<CLEDEntity>> m_index;  // null until the arena is known
  std::unique_ptr<CLEDEntityGridUpdater> m_gridUpdater;  // of a grid
};

}  // namespace argos

#endif
