#include <argos3/plugins/simulator/visualizations/offscreen/ground_cells.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <vector>

namespace ground_cells_test {

using namespace argos;

namespace {

// a solid of 1 x 1 x 2 m
SMeshInstance MakeInstance(double x, double y, double z) {
  SMeshInstance instance;
  instance.ToWorld[0] = {1.0f, 0.0f, 0.0f, static_cast<float>(x)};
  instance.ToWorld[1] = {0.0f, 1.0f, 0.0f, static_cast<float>(y)};
  instance.ToWorld[2] = {0.0f, 0.0f, 2.0f, static_cast<float>(z)};
  return instance;
}

// cells of 1 m, from the origin on
std::vector<TGroundArea> FindShaded(const CInstanceBatches::TBatches& casters,
                                    const Eigen::Vector3d& toSun, double blur = 0.0) {
  CGroundCells cells;
  cells.Fill({Eigen::Vector2d::Zero(), Eigen::Vector2d::Constant(kGroundCells)}, casters, toSun,
             blur);
  return cells.GetShaded();
}

CInstanceBatches::TBatches Batches(EMeshKind kind, const std::vector<SMeshInstance>& instances) {
  CInstanceBatches::TBatches batches;
  batches[static_cast<std::size_t>(kind)][0] = instances;
  return batches;
}

}  // namespace

TEST_CASE("ground cells: shadows lie away from the sun, from the foot of a solid to its top",
          "[offscreen]") {
  // at 45 degrees in the east: a shadow is as long as the solid is high, to the west
  const Eigen::Vector3d east = Eigen::Vector3d(1.0, 0.0, 1.0).normalized();
  const Eigen::Vector3d above = Eigen::Vector3d::UnitZ();
  using TAreas = std::vector<TGroundArea>;
  const SMeshInstance solid = MakeInstance(10.25, 20.25, 0.0);  // from 9.75 to 10.75 m
  for (const EMeshKind kind : {EMeshKind::Box, EMeshKind::Cylinder}) {
    CAPTURE(static_cast<int>(kind));
    CHECK(FindShaded(Batches(kind, {solid}), above) == TAreas{{9, 19, 11, 21}});
    CHECK(FindShaded(Batches(kind, {solid}), east) == TAreas{{7, 19, 11, 21}});
    CHECK(FindShaded(Batches(kind, {solid}), east, 1.0) == TAreas{{6, 18, 12, 22}});
    // below the ground it throws none
    CHECK(FindShaded(Batches(kind, {MakeInstance(10.25, 20.25, -3.0)}), east) ==
          TAreas{{9, 19, 11, 21}});
  }
  // a sphere is around its middle: half of it is below
  CHECK(FindShaded(Batches(EMeshKind::Sphere, {solid}), east) == TAreas{{8, 19, 11, 21}});
  CHECK(FindShaded(Batches(EMeshKind::Sphere, {MakeInstance(10.25, 20.25, 1.0)}), east) ==
        TAreas{{7, 19, 11, 21}});
}

TEST_CASE("ground cells: shadows at and beyond the ground's border are cut there", "[offscreen]") {
  const Eigen::Vector3d above = Eigen::Vector3d::UnitZ();
  const auto at = [&](double x, double y) {
    return FindShaded(Batches(EMeshKind::Box, {MakeInstance(x, y, 0.0)}), above);
  };
  using TAreas = std::vector<TGroundArea>;
  CHECK(at(0.0, 0.0) == TAreas{{0, 0, 1, 1}});
  CHECK(at(63.75, 63.75) == TAreas{{63, 63, 64, 64}});
  CHECK(at(-0.25, 10.25) == TAreas{{0, 9, 1, 11}});
  CHECK(at(-5.0, 10.0).empty());
  CHECK(at(10.0, -5.0).empty());
  CHECK(at(70.0, 10.0).empty());
  CHECK(at(10.0, 70.0).empty());
  CHECK(at(-1e9, 10.0).empty());
  CHECK(FindShaded({}, above).empty());
}

TEST_CASE("ground cells: cells that are shaded are covered once", "[offscreen]") {
  const Eigen::Vector3d above = Eigen::Vector3d::UnitZ();
  // beside each other, aside, and higher up with the same columns
  const std::vector<TGroundArea> areas = FindShaded(
      Batches(EMeshKind::Box, {MakeInstance(10.25, 10.25, 0), MakeInstance(12.25, 10.25, 0),
                               MakeInstance(20.25, 11.25, 0), MakeInstance(30.25, 10.25, 0),
                               MakeInstance(30.25, 14.25, 0)}),
      above);
  // two in one run; one that begins a row later; two that do not touch
  CHECK(areas == std::vector<TGroundArea>{
                     {9, 9, 13, 11}, {29, 9, 31, 11}, {19, 10, 21, 12}, {29, 13, 31, 15}});
}

}  // namespace ground_cells_test
