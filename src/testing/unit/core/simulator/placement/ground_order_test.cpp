#include <argos3/core/simulator/entity/controllable_entity.h>
#include <argos3/core/simulator/placement/ground_order.h>
#include <argos3/testing/support/experiment.h>
#include <argos3/testing/support/toy_world.h>

#include <catch2/catch.hpp>

#include <algorithm>

namespace ground_order_test {

using namespace argos;

namespace {

std::string Distribute(UInt32 quantity) {
  return "<distribute><position method='uniform' min='-20,-20,0' max='20,20,0' />"
         "<orientation method='uniform' min='-180,0,0' max='180,0,0' />"
         "<entity quantity='" +
         std::to_string(quantity) +
         "' max_trials='1000'><toy-robot id='fb'><controller config='c' /></toy-robot></entity>"
         "</distribute>";
}

SExperiment Experiment(UInt32 quantity) {
  return SExperiment{.Seed = 1,
                     .Controllers = "<toy_controller id='c' />",
                     .Engines = "<toy_engine id='toy' />",
                     .Arena = Distribute(quantity)};
}

const CVector3& PositionOf(CTestWorld& world, const std::string& id) {
  return dynamic_cast<CToyRobotEntity&>(world.GetSpace().GetEntity(id))
      .GetEmbodiedEntity()
      .GetOriginAnchor()
      .Position;
}

// m, of the path through robots in the order of their indices
Real LengthOfPath(CTestWorld& world) {
  CEntity::TVector roots = world.GetSpace().GetRootEntityVector();
  std::sort(roots.begin(), roots.end(), SEntityComparator());
  Real length = 0.0;
  for (size_t i = 1; i < roots.size(); ++i) {
    length +=
        Distance(PositionOf(world, roots[i - 1]->GetId()), PositionOf(world, roots[i]->GetId()));
  }
  return length;
}

}  // namespace

TEST_CASE("ground order: tiles follow the Z-order curve, and places on a tile their numbers",
          "[core][space][distribute]") {
  // tiles of 1 m from (-1, -1): 0 1 / 2 3, then the next four along x
  const std::vector<CVector3> positions{{0.5, 0.5, 9.0},  {-1.0, 0.5, 0.0},  {1.5, -0.5, 0.0},
                                        {0.5, -0.5, 0.0}, {-1.0, -1.0, 0.0}, {-0.5, -0.5, 0.0}};
  CHECK(OrderOnGround(positions, 1.0) == std::vector<UInt32>{4, 5, 3, 1, 0, 2});
  CHECK(OrderOnGround({}, 1.0).empty());
  CHECK(OrderOnGround({{1.0, 2.0, 0.0}, {1.0, 2.0, 0.0}}, 0.0) == std::vector<UInt32>{0, 1});
  CHECK(OrderOnGround({{1e6, 0.0, 0.0}, {-1e6, 0.0, 0.0}}, 1e-12) == std::vector<UInt32>{1, 0});
}

TEST_CASE("distribute: many robots are created by their places, and listed by their numbers",
          "[core][space][distribute]") {
  constexpr UInt32 kMany = 600;
  constexpr UInt32 kFew = 400;
  CTestWorld many(Experiment(kMany));
  CTestWorld few(Experiment(kFew));
  // the places are those of robots that are created one by one
  for (UInt32 i = 0; i < kFew; ++i) {
    const std::string id = "fb" + std::to_string(i);
    CHECK(PositionOf(many, id) == PositionOf(few, id));
  }
  CSpace& space = many.GetSpace();
  REQUIRE(space.GetRootEntityVector().size() == kMany);
  REQUIRE(space.GetControllableEntities().size() == kMany);
  size_t place = 0;
  for (UInt32 i = 0; i < kMany; ++i) {
    const std::string id = "fb" + std::to_string(i);
    CHECK(space.GetRootEntityVector()[i]->GetId() == id);
    CHECK(space.GetControllableEntities()[i]->GetRootEntity().GetId() == id);
    // each root is followed by its components
    REQUIRE(place < space.GetEntityVector().size());
    CHECK(space.GetEntityVector()[place]->GetId() == id);
    const CEntity* const root = space.GetEntityVector()[place];
    while (place < space.GetEntityVector().size() &&
           &space.GetEntityVector()[place]->GetRootEntity() == root) {
      ++place;
    }
  }
  CHECK(place == space.GetEntityVector().size());
  // in the order of creation each root comes with its place in that list
  ssize_t last = -1;
  size_t visited = 0;
  space.ForRootsAsCreated([&](CEntity& root, size_t placeOfRoot) {
    CHECK(root.GetIndex() > last);
    last = root.GetIndex();
    CHECK(space.GetRootEntityVector()[placeOfRoot] == &root);
    ++visited;
  });
  CHECK(visited == kMany);
  // neighbours are created one after the other: random places are 20 m apart on average
  CHECK(LengthOfPath(many) < 3.0 * kMany);
  CHECK(LengthOfPath(few) > 15.0 * kFew);
  // the tick, removal and destruction work in either order
  many.Step(2);
  {
    const CSimulator::CScope scope(many.GetSimulator());
    space.Remove(space.GetEntity("fb300"));
  }
  many.Step(2);
  CHECK(space.GetControllableEntities()[300]->GetRootEntity().GetId() == "fb301");
}

}  // namespace ground_order_test
