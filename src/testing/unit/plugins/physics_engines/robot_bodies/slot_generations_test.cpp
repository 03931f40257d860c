#include <argos3/plugins/simulator/physics_engines/robot_bodies/slot_generations.h>
#include <argos3/testing/support/invariants.h>

#include <catch2/catch.hpp>

namespace slot_generations_test {

using namespace argos;

TEST_CASE("slot generations: a slot that is used again has another generation", "[engines]") {
  CSlotGenerations generations;
  const SSlotHandle first{0, generations.Add()};
  const SSlotHandle second{1, generations.Add()};
  generations.Check(first);
  generations.Check(second);

  // the second body gets slot 0
  const SSlotHandle moved{0, generations.Remove(0)};
  CHECK(moved.Generation == generations.Get(0));
  CHECK(generations.IsCurrent(0, moved.Generation));
  CHECK_FALSE(generations.IsCurrent(0, first.Generation));
  CHECK_FALSE(generations.IsCurrent(1, second.Generation));
  CheckCaught([&] { generations.Check(first); }, "stale handle of a body: generation 1 of slot 0");
  CheckCaught([&] { generations.Check(second); }, "slot 1, among 1 bodies");
  CheckCaught([&] { static_cast<void>(generations.Get(1)); }, "no body in slot 1 of 1");

  const SSlotHandle third{1, generations.Add()};
  CHECK(generations.IsCurrent(1, third.Generation));
  CHECK_FALSE(generations.IsCurrent(1, second.Generation));

  generations.Clear();
  const SSlotHandle fourth{0, generations.Add()};
  CHECK(generations.IsCurrent(0, fourth.Generation));
  CHECK_FALSE(generations.IsCurrent(0, moved.Generation));
}

}  // namespace slot_generations_test
