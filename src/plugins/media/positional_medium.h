#ifndef ARGOS3_PLUGINS_MEDIA_POSITIONAL_MEDIUM_H
#define ARGOS3_PLUGINS_MEDIA_POSITIONAL_MEDIUM_H

#include <argos3/core/simulator/medium/medium.h>
#include <argos3/core/simulator/space/positional_indices/grid.h>
#include <argos3/core/simulator/space/positional_indices/hash_index.h>
#include <argos3/core/simulator/space/space.h>
#include <argos3/plugins/simulator/media/clear_medium.h>
#include <argos3/plugins/simulator/media/entity_points.h>
#include <argos3/plugins/simulator/media/index_choice.h>

#include <algorithm>
#include <memory>
#include <vector>

namespace argos {

/**
 * Base of the media of LEDs and tags: an index of entities for cameras.
 *
 * Contains the enabled entities of this medium. The index has those that the updaters inserted at
 * the last Update(); entities outside the arena are included.
 * @tparam ENTITY  a CMediumMember.
 * @tparam GRID_UPDATER, HASH_UPDATER  insert an entity into its cells, if it is visible.
 */
template <class ENTITY, class GRID_UPDATER, class HASH_UPDATER>
class CPositionalMedium : public CMedium, public ENTITY::CRegistry {
 public:
  CPositionalMedium() = default;
  ~CPositionalMedium() override { RemoveAll(); }

  /**
   * Reads `id`, `index` ("grid" or "hash") and `grid_size` (cells along each axis).
   * @throws CARGoSException if a value is unknown or out of range.
   */
  void Init(TConfigurationNode& tree) override {
    CMedium::Init(tree);
    m_choice.Read(tree);
  }
  /** Restores the initial order of the entities that are enabled at the start. */
  void Reset() override {
    SortByEntityIndex();
    CPositionalMedium::Update();
  }
  /** Removes all entities. */
  void Destroy() override { RemoveAll(); }
  void PostSpaceInit() override {
    SortByEntityIndex();
    CPositionalMedium::Update();
  }
  void Update() override {
    CPositionalIndex<ENTITY>& index = GetIndex();
    m_points.Invalidate();
    if (!m_keepsPoints || m_choice.Kind != SIndexChoice::EKind::Grid) {
      index.Update();
      return;
    }
    m_points.Start(m_numEntities);
    index.Update();
    m_points.Finish();
  }

  /** The index as of the last Update(). Queries are safe on several threads at once. */
  CPositionalIndex<ENTITY>& GetIndex() {
    if (m_index == nullptr) {
      MakeIndex();
    }
    return *m_index;
  }

  /** Makes each Update() from the next one on fill GetPoints(), if the index is a grid. */
  void KeepPoints() { m_keepsPoints = true; }
  /**
   * The entities that the index contains, with their positions at the last Update().
   * @return null if there are none, or an entity was removed since.
   */
  const CEntityPoints<ENTITY>* GetPoints() const {
    return m_points.IsComplete() ? &m_points : nullptr;
  }

 protected:
  const SIndexChoice& GetIndexChoice() const { return m_choice; }

  // called by entities when they are enabled and disabled
  void Insert(ENTITY& entity) override {
    ++m_numEntities;
    if (m_index != nullptr) {
      m_index->AddEntity(entity);
    } else {
      m_waiting.push_back(&entity);
    }
  }
  void Erase(ENTITY& entity) override {
    m_numEntities -= m_numEntities > 0 ? 1 : 0;
    m_points.Invalidate();
    if (m_index != nullptr) {
      m_index->RemoveEntity(entity);
    } else {
      m_waiting.erase(std::remove(m_waiting.begin(), m_waiting.end(), &entity), m_waiting.end());
    }
  }

 private:
  // puts an entity into its cell, and into the points while these are filled
  class CUpdater : public CPositionalIndex<ENTITY>::COperation {
   public:
    CUpdater(CPositionalMedium& medium, CGrid<ENTITY>& grid) : m_medium(medium), m_cells(grid) {}
    bool operator()(ENTITY& entity) override {
      if (m_medium.m_keepsPoints && entity.IsInCells()) {
        m_medium.m_points.Add(entity);
      }
      return m_cells(entity);
    }

   private:
    CPositionalMedium& m_medium;
    GRID_UPDATER m_cells;
  };

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

  // makes no list of them: there may be no memory for one
  void RemoveAll() {
    class CClear : public CPositionalIndex<ENTITY>::COperation {
     public:
      bool operator()(ENTITY& entity) override {
        entity.ClearMedium();
        return true;
      }
    } clear;
    if (m_index != nullptr) {
      m_index->ForAllEntities(clear);
    }
    ClearMediumOfAll(m_waiting);
  }

  // Disabling and enabling moves an entity to the end of the list; this restores the same order at
  // the start of every run.
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
    std::unique_ptr<CPositionalIndex<ENTITY>> index;
    if (m_choice.Kind == SIndexChoice::EKind::Grid) {
      const CVector3& center = GetSpace().GetArenaCenter();
      auto grid = std::make_unique<CGrid<ENTITY>>(center - extent * 0.5, center + extent * 0.5,
                                                  number[0], number[1], number[2]);
      m_gridUpdater = std::make_unique<CUpdater>(*this, *grid);
      grid->SetUpdateEntityOperation(m_gridUpdater.get());
      index = std::move(grid);
    } else {
      index = std::make_unique<CHashIndex<ENTITY, HASH_UPDATER>>(CVector3(
          extent.GetX() / number[0], extent.GetY() / number[1], extent.GetZ() / number[2]));
    }
    for (ENTITY* entity : m_waiting) {
      index->AddEntity(*entity);
    }
    // complete: an entity is in one of the two, whatever fails before
    m_index = std::move(index);
    m_waiting.clear();
  }

  SIndexChoice m_choice;
  std::vector<ENTITY*> m_waiting;  // added before the index was made; not owned
  std::unique_ptr<CPositionalIndex<ENTITY>> m_index;  // null until the arena is known
  std::unique_ptr<CUpdater> m_gridUpdater;  // updates a grid
  size_t m_numEntities = 0;  // is an upper limit of the number of points
  bool m_keepsPoints = false;
  CEntityPoints<ENTITY> m_points;
};

}  // namespace argos

#endif
