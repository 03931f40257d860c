#include <argos3/core/simulator/entity/positional_entity.h>
#include <argos3/core/simulator/space/positional_indices/grid.h>
#include <argos3/core/simulator/space/positional_indices/hash_index.h>
#include <argos3/core/utility/math/random_stream.h>
#include <argos3/testing/support/no_allocation.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <set>
#include <sstream>

namespace positional_index_test {

using namespace argos;
using Catch::Matchers::Contains;

namespace {

using TIndex = CPositionalIndex<CPositionalEntity>;
using TGrid = CGrid<CPositionalEntity>;

class CGridUpdater : public TGrid::COperation {
 public:
  explicit CGridUpdater(TGrid& grid) : m_grid(grid) {}
  bool operator()(CPositionalEntity& entity) override {
    SInt32 i = 0;
    SInt32 j = 0;
    SInt32 k = 0;
    m_grid.PositionToCellUnsafe(i, j, k, entity.GetPosition());
    m_grid.UpdateCell(i, j, k, entity);
    return true;
  }

 private:
  TGrid& m_grid;
};

class CHashUpdater : public CSpaceHashUpdater<CPositionalEntity> {
 public:
  void operator()(CAbstractSpaceHash<CPositionalEntity>& hash, CPositionalEntity& entity) override {
    SInt32 i = 0;
    SInt32 j = 0;
    SInt32 k = 0;
    hash.SpaceToHashTable(i, j, k, entity.GetPosition());
    hash.UpdateCell(i, j, k, entity);
  }
};

class CCollect : public TIndex::COperation {
 public:
  bool operator()(CPositionalEntity& entity) override {
    Found.push_back(&entity);
    return true;
  }
  bool Has(const CPositionalEntity& entity) const {
    return std::find(Found.begin(), Found.end(), &entity) != Found.end();
  }
  std::vector<CPositionalEntity*> Found;
};

class CStopAt : public TIndex::COperation {
 public:
  explicit CStopAt(const CPositionalEntity* match) : m_match(match) {}
  bool operator()(CPositionalEntity& entity) override {
    Found.push_back(&entity);
    return &entity != m_match;
  }
  std::vector<CPositionalEntity*> Found;

 private:
  const CPositionalEntity* m_match;
};

// an index of either kind over a box of 10 x 10 x 2 m around the
// origin, and points in and around it
struct SIndexed {
  explicit SIndexed(const std::string& kind, int numEntities = 0) {
    if (kind == "grid") {
      auto grid =
          std::make_unique<TGrid>(CVector3(-5.0, -5.0, -1.0), CVector3(5.0, 5.0, 1.0), 7, 10, 2);
      Updater = std::make_unique<CGridUpdater>(*grid);
      grid->SetUpdateEntityOperation(Updater.get());
      Index = std::move(grid);
    } else {
      Index =
          std::make_unique<CHashIndex<CPositionalEntity, CHashUpdater>>(CVector3(1.4, 1.0, 1.0));
    }
    for (int i = 0; i < numEntities; ++i) {
      Add(RandomPoint());
    }
    Index->Update();
  }

  CVector3 RandomPoint() {
    return CVector3(Random.Uniform(-8.0, 8.0), Random.Uniform(-8.0, 8.0),
                    Random.Uniform(-2.0, 2.0));
  }
  CPositionalEntity& Add(const CVector3& position) {
    Entities.push_back(std::make_unique<CPositionalEntity>(
        nullptr, "e" + std::to_string(Entities.size()), position));
    Entities.back()->SetIndex(static_cast<ssize_t>(Entities.size()));
    Index->AddEntity(*Entities.back());
    return *Entities.back();
  }

  CRandomStream Random{1, "test", "positional index", "points"};
  std::unique_ptr<CGridUpdater> Updater;
  std::unique_ptr<TIndex> Index;
  std::vector<std::unique_ptr<CPositionalEntity>> Entities;
};

}  // namespace

TEST_CASE("positional index: range queries find all entities that brute force finds",
          "[core][space]") {
  const std::string kind = GENERATE("grid", "hash");
  CAPTURE(kind);
  SIndexed world(kind, 500);
  for (int trial = 0; trial < 100; ++trial) {
    const CVector3 center = world.RandomPoint();
    const CVector3 half(world.Random.Uniform(0.0, 3.0), world.Random.Uniform(0.0, 3.0),
                        world.Random.Uniform(0.0, 1.0));
    const Real radius = world.Random.Uniform(0.0, 3.0);
    CCollect inBox;
    CCollect inSphere;
    world.Index->ForEntitiesInBoxRange(center, half, inBox);
    world.Index->ForEntitiesInSphereRange(center, radius, inSphere);
    for (const auto& entity : world.Entities) {
      const CVector3 offset = entity->GetPosition() - center;
      if (std::abs(offset.GetX()) <= half.GetX() && std::abs(offset.GetY()) <= half.GetY() &&
          std::abs(offset.GetZ()) <= half.GetZ()) {
        CHECK(inBox.Has(*entity));
      }
      if (offset.Length() <= radius) {
        CHECK(inSphere.Has(*entity));
      }
    }
  }
}

TEST_CASE("positional index: flat ranges find the entities in their plane", "[core][space]") {
  const std::string kind = GENERATE("grid", "hash");
  CAPTURE(kind);
  SIndexed world(kind);
  for (int i = 0; i < 300; ++i) {
    CVector3 position = world.RandomPoint();
    position.SetZ(0.3);
    world.Add(position);
  }
  world.Index->Update();
  for (int trial = 0; trial < 50; ++trial) {
    CVector3 center = world.RandomPoint();
    center.SetZ(0.3);
    const CVector2 half(world.Random.Uniform(0.0, 3.0), world.Random.Uniform(0.0, 3.0));
    const Real radius = world.Random.Uniform(0.0, 3.0);
    CCollect inCircle;
    CCollect inRectangle;
    world.Index->ForEntitiesInCircleRange(center, radius, inCircle);
    world.Index->ForEntitiesInRectangleRange(center, half, inRectangle);
    for (const auto& entity : world.Entities) {
      const CVector3 offset = entity->GetPosition() - center;
      if (offset.Length() <= radius) {
        CHECK(inCircle.Has(*entity));
      }
      if (std::abs(offset.GetX()) <= half.GetX() && std::abs(offset.GetY()) <= half.GetY()) {
        CHECK(inRectangle.Has(*entity));
      }
    }
  }
}

TEST_CASE("positional index: rays find all points on them", "[core][space]") {
  const std::string kind = GENERATE("grid", "hash");
  CAPTURE(kind);
  for (int trial = 0; trial < 50; ++trial) {
    SIndexed world(kind, 400);
    const CRay3 ray(world.RandomPoint(), world.RandomPoint());
    std::vector<CPositionalEntity*> onRay;
    for (int i = 0; i <= 20; ++i) {
      CVector3 point;
      ray.GetPoint(point, i / 20.0);
      onRay.push_back(&world.Add(point));
    }
    world.Index->Update();
    CCollect collect;
    world.Index->ForEntitiesAlongRay(ray, collect);
    for (const CPositionalEntity* entity : onRay) {
      CHECK(collect.Has(*entity));
    }
    // a grid visits far fewer entities than all, in the order of the ray's
    // cells: that of the start first
    CHECK(collect.Found.size() < world.Entities.size());
  }
}

TEST_CASE("positional index: a ray query stops at the match, or after its cell", "[core][space]") {
  const std::string kind = GENERATE("grid", "hash");
  CAPTURE(kind);
  SIndexed world(kind);
  // two entities in the first cell, one of them the match, and a distant one
  CPositionalEntity& match = world.Add(CVector3(0.1, 0.1, 0.1));
  CPositionalEntity& besides = world.Add(CVector3(0.2, 0.1, 0.1));
  world.Add(CVector3(3.9, 0.1, 0.1));
  // with fewer entities than cells along the ray the hash would visit all entities
  for (int i = 0; i < 50; ++i) {
    world.Add(CVector3(-4.0, -4.0, -0.5));
  }
  world.Index->Update();
  const CRay3 ray(CVector3(0.05, 0.1, 0.1), CVector3(4.0, 0.1, 0.1));
  CStopAt once(&match);
  world.Index->ForEntitiesAlongRay(ray, once);
  CHECK(once.Found == std::vector<CPositionalEntity*>{&match});
  CStopAt afterCell(&match);
  world.Index->ForEntitiesAlongRay(ray, afterCell, true);
  CHECK(afterCell.Found == std::vector<CPositionalEntity*>{&match, &besides});
}

TEST_CASE("hash index: along a ray of more cells than entities all entities are visited",
          "[core][space]") {
  SIndexed world("hash");
  CPositionalEntity& first = world.Add(CVector3(0.1, 0.1, 0.1));
  CPositionalEntity& match = world.Add(CVector3(0.2, 0.1, 0.1));
  CPositionalEntity& distant = world.Add(CVector3(3.9, 0.1, 0.1));
  world.Index->Update();
  const CRay3 ray(CVector3(0.05, 0.1, 0.1), CVector3(100.0, 0.1, 0.1));
  CCollect all;
  world.Index->ForEntitiesAlongRay(ray, all);
  CHECK(all.Found == std::vector<CPositionalEntity*>{&first, &match, &distant});
  CStopAt once(&match);
  world.Index->ForEntitiesAlongRay(ray, once);
  CHECK(once.Found == std::vector<CPositionalEntity*>{&first, &match});
  // which of them is the closest one is not known
  CStopAt closest(&match);
  world.Index->ForEntitiesAlongRay(ray, closest, true);
  CHECK(closest.Found == std::vector<CPositionalEntity*>{&first, &match, &distant});
}

TEST_CASE("positional index: a removed entity is never visited again", "[core][space]") {
  const std::string kind = GENERATE("grid", "hash");
  CAPTURE(kind);
  SIndexed world(kind, 100);
  std::set<CPositionalEntity*> alive;
  for (const auto& entity : world.Entities) {
    alive.insert(entity.get());
  }
  const auto visited = [&world] {
    CCollect all;
    world.Index->ForEntitiesInBoxRange(CVector3(), CVector3(20.0, 20.0, 20.0), all);
    return std::set<CPositionalEntity*>(all.Found.begin(), all.Found.end());
  };
  CHECK(visited() == alive);
  for (int i = 0; i < 90; ++i) {
    CPositionalEntity* entity = world.Entities[(i * 37) % 100].get();
    world.Index->RemoveEntity(*entity);
    world.Index->RemoveEntity(*entity);
    alive.erase(entity);
    if (i % 7 == 0) {
      world.Index->Update();
    }
    CHECK(visited() == alive);
  }
}

TEST_CASE("positional index: all entities are visited in order of addition", "[core][space]") {
  const std::string kind = GENERATE("grid", "hash");
  SIndexed world(kind, 20);
  world.Index->RemoveEntity(*world.Entities[5]);
  world.Index->AddEntity(*world.Entities[5]);
  world.Index->AddEntity(*world.Entities[6]);  // no effect: it is in the index already
  CCollect all;
  world.Index->ForAllEntities(all);
  std::vector<CPositionalEntity*> expected;
  for (size_t i = 0; i < 20; ++i) {
    if (i != 5) {
      expected.push_back(world.Entities[i].get());
    }
  }
  expected.push_back(world.Entities[5].get());
  CHECK(all.Found == expected);
}

TEST_CASE("positional index: entities at a place are returned as a set", "[core][space]") {
  const std::string kind = GENERATE("grid", "hash");
  SIndexed world(kind);
  CPositionalEntity& far = world.Add(CVector3(1e12, -1e12, 0.0));
  CPositionalEntity& lost = world.Add(CVector3());
  lost.SetPosition(CVector3(std::numeric_limits<Real>::quiet_NaN(), 0.0, 0.0));
  CPositionalEntity& here = world.Add(CVector3(1.0, 1.0, 0.5));
  world.Index->Update();
  CSet<CPositionalEntity*, SEntityComparator> found;
  world.Index->GetEntitiesAt(found, CVector3(1.0, 1.0, 0.5));
  CHECK(found.size() == 1);
  CHECK(found.exists(&here));
  world.Index->GetEntitiesAt(found, CVector3(1e12, -1e12, 0.0));
  CHECK(found.exists(&far));
  CHECK_FALSE(found.exists(&here));
  CCollect all;
  world.Index->ForAllEntities(all);
  CHECK(all.Has(lost));
}

TEST_CASE("positional index: an update allocates nothing, wherever the entities have moved",
          "[core][space]") {
  const std::string kind = GENERATE("grid", "hash");
  CAPTURE(kind);
  SIndexed world(kind, 200);
  std::vector<CVector3> places;
  for (int i = 0; i < 10; ++i) {
    // every second update puts all entities into one cell
    places.push_back(world.RandomPoint());
  }
  CheckAllocatesNothing([&] {
    for (int update = 0; update < 20; ++update) {
      for (const auto& entity : world.Entities) {
        entity->SetPosition(update % 2 == 0 ? places[update / 2] : world.RandomPoint());
      }
      world.Index->Update();
    }
  });
}

TEST_CASE("grid: cells outside are those at its edges", "[core][space]") {
  class CPutAt : public TGrid::COperation {
   public:
    CPutAt(TGrid& grid, SInt32 i, SInt32 j, SInt32 k) : m_grid(grid), m_i(i), m_j(j), m_k(k) {}
    bool operator()(CPositionalEntity& entity) override {
      m_grid.UpdateCell(m_i, m_j, m_k, entity);
      return true;
    }

   private:
    TGrid& m_grid;
    SInt32 m_i, m_j, m_k;
  };
  // of 7 x 10 x 2 cells
  const auto [i, j, k, nearestI, nearestJ, nearestK] =
      GENERATE(table<SInt32, SInt32, SInt32, SInt32, SInt32, SInt32>({
          {-1, 4, 1, 0, 4, 1},
          {7, 4, 1, 6, 4, 1},
          {3, -5, 0, 3, 0, 0},
          {3, 10, 0, 3, 9, 0},
          {3, 4, -1, 3, 4, 0},
          {3, 4, 2, 3, 4, 1},
          {6, 9, 1, 6, 9, 1},
      }));
  SIndexed world("grid");
  auto& grid = dynamic_cast<TGrid&>(*world.Index);
  CPutAt put(grid, i, j, k);
  grid.SetUpdateEntityOperation(&put);
  CPositionalEntity& entity = world.Add(CVector3());
  grid.Update();
  CHECK(grid.GetCellAt(nearestI, nearestJ, nearestK).Entities.exists(&entity));
}

TEST_CASE("grid: a cell lists its entities in order, as of the last update", "[core][space]") {
  SIndexed world("grid");
  auto& grid = dynamic_cast<TGrid&>(*world.Index);
  const CVector3 here(0.0, 0.5, 0.5);
  SInt32 i = 0;
  SInt32 j = 0;
  SInt32 k = 0;
  grid.PositionToCell(i, j, k, here);
  TGrid::SCell& cell = grid.GetCellAt(i, j, k);
  // an empty cell
  CHECK(cell.Entities.empty());
  CHECK(cell.Entities.begin() == cell.Entities.end());
  CPositionalEntity& a = world.Add(here);
  CPositionalEntity& b = world.Add(here);
  CPositionalEntity& c = world.Add(here);
  world.Index->Update();
  const auto list = [&cell] {
    return std::vector<CPositionalEntity*>(cell.Entities.begin(), cell.Entities.end());
  };
  CHECK(list() == std::vector<CPositionalEntity*>{&a, &b, &c});
  CHECK(cell.Entities.size() == 3);
  CHECK((*cell.Entities.begin())->GetId() == "e0");
  CHECK(cell.Entities.exists(&b));
  const UInt64 timestamp = cell.Timestamp;

  // a removed entity disappears from the list at once: the first, a middle one, the last
  const auto removed = GENERATE(0, 1, 2);
  std::vector<CPositionalEntity*> left = {&a, &b, &c};
  world.Index->RemoveEntity(*left[removed]);
  left.erase(left.begin() + removed);
  CHECK(list() == left);
  CHECK(cell.Entities.size() == 2);
  // entities added to cells by UpdateCell() between updates, here to two cells
  CPositionalEntity& d = world.Add(here);
  grid.UpdateCell(i, j, k, d);
  grid.UpdateCell(i + 1, j, k, d);
  left.push_back(&d);
  CHECK(list() == left);
  CHECK(grid.GetCellAt(i + 1, j, k).Entities.exists(&d));
  world.Index->RemoveEntity(d);
  left.pop_back();
  CHECK(list() == left);
  CHECK(grid.GetCellAt(i + 1, j, k).Entities.empty());

  // entities that have moved away are not listed after the next update
  for (CPositionalEntity* entity : left) {
    entity->SetPosition(CVector3(-4.0, -4.0, -0.5));
  }
  world.Index->Update();
  CHECK(cell.Entities.empty());
  CHECK(cell.Entities.begin() == cell.Entities.end());
  CHECK_FALSE(cell.Entities.exists(left[0]));
  CHECK(cell.Timestamp == timestamp);
}

TEST_CASE("grid: cells and positions correspond", "[core][space]") {
  TGrid grid(CVector3(-1.0, 0.0, 2.0), CVector3(1.0, 3.0, 3.0), 4, 3, 2);
  CHECK(grid.GetSizeI() == 4);
  CHECK(grid.GetSizeJ() == 3);
  CHECK(grid.GetSizeK() == 2);
  SInt32 i = 0;
  SInt32 j = 0;
  SInt32 k = 0;
  grid.PositionToCell(i, j, k, CVector3(0.6, 2.9, 2.4));
  CHECK((i == 3 && j == 2 && k == 0));
  // the upper border belongs to the last cell
  grid.PositionToCell(i, j, k, CVector3(1.0, 3.0, 3.0));
  CHECK((i == 3 && j == 2 && k == 1));
  CHECK_THROWS_WITH(grid.PositionToCell(i, j, k, CVector3(0.0, 3.1, 2.5)),
                    Contains("outside the grid") && Contains("component y"));
  grid.PositionToCellUnsafe(i, j, k, CVector3(-100.0, 100.0, 2.9));
  CHECK((i == 0 && j == 2 && k == 1));
  i = -3;
  j = 9;
  k = 1;
  grid.ClampCoordinates(i, j, k);
  CHECK((i == 0 && j == 2 && k == 1));
}

TEST_CASE("grid: cells are visited in order, and those of a ray along it", "[core][space]") {
  TGrid grid(CVector3(0.0, 0.0, 0.0), CVector3(3.0, 3.0, 1.0), 3, 3, 1);
  class CCells : public TGrid::CCellOperation {
   public:
    bool operator()(SInt32 i, SInt32 j, SInt32, TGrid::SCell&) override {
      Numbers.push_back(10 * i + j);
      return true;
    }
    std::vector<int> Numbers;
  };
  CCells all;
  grid.ForAllCells(all);
  CHECK(all.Numbers == std::vector<int>{0, 10, 20, 1, 11, 21, 2, 12, 22});
  CCells ray;
  grid.ForCellsAlongRay(CRay3(CVector3(0.5, 0.2, 0.5), CVector3(2.5, 1.4, 0.5)), ray);
  // crosses (1, 0.5) and (2, 1.1), and y = 1 at x = 11/6
  CHECK(ray.Numbers == std::vector<int>{0, 10, 11, 21});
  CCells back;
  grid.ForCellsAlongRay(CRay3(CVector3(2.5, 1.4, 0.5), CVector3(0.5, 0.2, 0.5)), back);
  CHECK(back.Numbers == std::vector<int>{21, 11, 10, 0});
  CCells circle;
  grid.ForCellsInCircleRange(CVector3(0.5, 0.5, 0.5), 0.6, circle);
  CHECK(circle.Numbers == std::vector<int>{0, 10, 1, 11});
}

TEST_CASE("grid: invalid sizes and cells are refused", "[core][space][errors]") {
  const CVector3 min;
  const CVector3 max(1.0, 1.0, 1.0);
  CHECK_THROWS_WITH(TGrid(min, max, 0, 1, 1), Contains("0,1,1"));
  CHECK_THROWS_WITH(TGrid(max, min, 1, 1, 1), Contains("volume"));
  TGrid grid(min, max, 1, 1, 1);
  CPositionalEntity entity(nullptr, "e");
  grid.AddEntity(entity);
  CHECK_THROWS_WITH(grid.Update(), Contains("SetUpdateEntityOperation"));
}

TEST_CASE("space hash: cells have no bounds, and a dump lists them", "[core][space]") {
  CSpaceHash<CPositionalEntity, CHashUpdater> hash;
  hash.SetCellSize(CVector3(0.5, 1.0, 2.0));
  hash.SetSize(3);
  CPositionalEntity a(nullptr, "a", CVector3(-0.1, 7.5, 0.0));
  CPositionalEntity b(nullptr, "b", CVector3(-0.4, 7.0, 1.9));
  CPositionalEntity c(nullptr, "c", CVector3(1000.2, -3000.0, 0.0));
  hash.AddElement(a);
  hash.AddElement(c);
  hash.AddElement(b);
  hash.Update();
  std::vector<CPositionalEntity*> found;
  CHECK(hash.CheckCell(-1, 7, 0, found));
  CHECK(found == std::vector<CPositionalEntity*>{&a, &b});
  found.clear();
  CHECK_FALSE(hash.CheckCell(0, 7, 0, found));
  CHECK(hash.SpaceToHashTable(1000.2, 0) == 2000);
  CVector3 corner;
  hash.HashTableToSpace(corner, 2000, -3000, 0);
  CHECK(corner == CVector3(1000.0, -3000.0, 0.0));
  std::ostringstream dump;
  hash.Dump(dump);
  CHECK(dump.str() == "(-1,7,0): a b\n(2000,-3000,0): c\n");
  CHECK_THROWS_WITH(hash.SetCellSize(CVector3(1.0, 0.0, 1.0)), Contains("> 0"));
}

}  // namespace positional_index_test
