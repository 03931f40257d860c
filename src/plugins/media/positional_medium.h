#ifndef ARGOS3_PLUGINS_MEDIA_POSITIONAL_MEDIUM_H
#define ARGOS3_PLUGINS_MEDIA_POSITIONAL_MEDIUM_H

#include <argos3/core/simulator/medium/medium.h>
#include <argos3/core/simulator/space/positional_indices/grid.h>
#include <argos3/core/simulator/space/positional_indices/hash_index.h>
#include <argos3/core/simulator/space/space.h>
#include <argos3/plugins/simulator/media/index_choice.h>

#include <algorithm>
#include <memory>
#include <vector>

namespace argos {

/**
 * Knows where the entities of a kind are, for cameras: what the media of LEDs and tags have in
 * common.
 *
 * Holds the enabled entities whose medium it is. Its index has those that its updaters put there at
 * the last Update(); entities beyond the arena are in it like all others.
 * @tparam ENTITY  a CMediumMember.
 * @tparam GRID_UPDATER, HASH_UPDATER  put an entity into its cells, if it is to be found.
 */
template <class ENTITY, class GRID_UPDATER, class HASH_UPDATER>
class CPositionalMedium : public CMedium, public ENTITY::CRegistry {
 public:
  CPositionalMedium() = default;
  ~CPositionalMedium() override { LetGoOfAll(); }

  /**
   * Reads `id`, `index` ("grid" or "hash") and `grid_size` (cells along each axis).
   * @throws CARGoSException if a value is unknown or out of range.
   */
  void Init(TConfigurationNode& tree) override {
    CMedium::Init(tree);
    m_choice.Read(tree);
  }
  /** The entities enabled at the start are listed in the order they had then. */
  void Reset() override {
    SortByEntityIndex();
    CPositionalMedium::Update();
  }
  /** Lets go of all entities. */
  void Destroy() override { LetGoOfAll(); }
  void PostSpaceInit() override {
    SortByEntityIndex();
    CPositionalMedium::Update();
  }
  void Update() override { GetIndex().Update(); }

  /** Called by the entity when it is enabled and disabled. */
  void AddEntity(ENTITY& entity) override {
    if (m_index != nullptr) {
      m_index->AddEntity(entity);
    } else {
      m_waiting.push_back(&entity);
    }
  }
  void RemoveEntity(ENTITY& entity) override {
    if (m_index != nullptr) {
      m_index->RemoveEntity(entity);
    } else {
      m_waiting.erase(std::remove(m_waiting.begin(), m_waiting.end(), &entity), m_waiting.end());
    }
  }

  /** As of the last Update(). Queries are safe on several threads at once. */
  CPositionalIndex<ENTITY>& GetIndex() {
    if (m_index == nullptr) {
      MakeIndex();
    }
    return *m_index;
  }

 protected:
  const SIndexChoice& GetIndexChoice() const { return m_choice; }

 private:
  // all entities, in the order of their addition
  std::vector<ENTITY*> ListAll() {
    class CCollect : public CPositionalIndex<ENTITY>::COperation {
     public:
      bool operator()(ENTITY& entity) override {
        Entities.push_back(&entity);
        return true;
      }
      std::vector<ENTITY*> Entities;
    } all;
    if (m_index != nullptr) {
      m_index->ForAllEntities(all);
    }
    return m_index != nullptr ? all.Entities : m_waiting;
  }

  void LetGoOfAll() {
    for (ENTITY* entity : ListAll()) {
      entity->ClearMedium();
    }
  }

  // entities that a run switched off and on have moved to the end of the list; with this the list
  // is at the start of every run the same
  void SortByEntityIndex() {
    GetIndex();
    std::vector<ENTITY*> all = ListAll();
    if (std::is_sorted(all.begin(), all.end(), SEntityComparator())) {
      return;
    }
    std::stable_sort(all.begin(), all.end(), SEntityComparator());
    for (ENTITY* entity : all) {
      m_index->RemoveEntity(*entity);
      m_index->AddEntity(*entity);
    }
  }

  void MakeIndex() {
    const SIndexChoice::SCells cells = m_choice.MakeCells(GetSpace().GetArenaSize());
    const SInt32* const number = cells.Number;
    const CVector3& extent = cells.Extent;
    if (m_choice.Kind == SIndexChoice::EKind::Grid) {
      const CVector3& center = GetSpace().GetArenaCenter();
      auto grid = std::make_unique<CGrid<ENTITY>>(center - extent * 0.5, center + extent * 0.5,
                                                  number[0], number[1], number[2]);
      m_gridUpdater = std::make_unique<GRID_UPDATER>(*grid);
      grid->SetUpdateEntityOperation(m_gridUpdater.get());
      m_index = std::move(grid);
    } else {
      m_index = std::make_unique<CHashIndex<ENTITY, HASH_UPDATER>>(CVector3(
          extent.GetX() / number[0], extent.GetY() / number[1], extent.GetZ() / number[2]));
    }
    for (ENTITY* entity : m_waiting) {
      m_index->AddEntity(*entity);
    }
    m_waiting.clear();
  }

  SIndexChoice m_choice;
  std::vector<ENTITY*> m_waiting;  // added before the index was made; not owned
  std::unique_ptr<CPositionalIndex<ENTITY>> m_index;  // null until the arena is known
  std::unique_ptr<GRID_UPDATER> m_gridUpdater;  // of a grid
};

}  // namespace argos

#endif
