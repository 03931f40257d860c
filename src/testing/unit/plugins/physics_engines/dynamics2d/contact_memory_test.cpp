#include <argos3/plugins/simulator/physics_engines/dynamics2d/contact_memory.h>

#include <catch2/catch.hpp>

namespace argos::contact_memory_test {

namespace {

SContactForce Force(float normal) {
  SContactForce force;
  force.Take(normal, 0.0F);
  force.Take(normal, 0.1F);
  return force;
}

}  // namespace

TEST_CASE("contact memory: forces are found by slot and partner", "[dynamics2d][crowd]") {
  CContactMemory memory;
  CHECK(memory.Find(3, 5).Normal == 0.0F);
  memory.StartCollecting();
  memory.Collect({3, 5, Force(2.0F)});
  memory.Collect({0, 1, Force(1.0F)});
  memory.Collect({3, 4, Force(3.0F)});
  memory.FinishCollecting(6);
  CHECK(memory.Find(0, 1).Normal == 1.0F);
  CHECK(memory.Find(3, 4).Normal == 3.0F);
  CHECK(memory.Find(3, 5).Normal == 2.0F);
  CHECK(memory.Find(3, 5).Tangent == 0.1F);
  CHECK(memory.Find(1, 0).Normal == 0.0F);
  CHECK(memory.Find(7, 0).Normal == 0.0F);

  // what is not collected again is forgotten
  memory.StartCollecting();
  memory.Collect({3, 4, Force(4.0F)});
  memory.FinishCollecting(6);
  CHECK(memory.Find(3, 4).Normal == 4.0F);
  CHECK(memory.Find(0, 1).Normal == 0.0F);
  memory.Clear();
  CHECK(memory.Find(3, 4).Normal == 0.0F);
}

TEST_CASE("contact memory: another robot in a slot has none of its forces", "[dynamics2d][crowd]") {
  CContactMemory memory;
  memory.StartCollecting();
  memory.Collect({1, 2, Force(1.0F)});
  memory.Collect({2, 3, Force(2.0F)});
  memory.Collect({3, 4, Force(3.0F)});
  memory.FinishCollecting(5);
  memory.Forget(2);
  CHECK(memory.Find(1, 2).Normal == 0.0F);
  CHECK(memory.Find(2, 3).Normal == 0.0F);
  CHECK(memory.Find(3, 4).Normal == 3.0F);
}

TEST_CASE("contact memory: the force of an impact is not the start of the next substep",
          "[dynamics2d][crowd]") {
  SContactForce force;
  force.Take(8.0F, 1.0F);
  CHECK(force.Steady == 0.0F);
  force.Take(2.0F, 0.5F);
  CHECK(force.Steady == 2.0F);
  force.Take(2.5F, 0.5F);
  CHECK(force.Steady == 2.5F);
  force.Take(8.0F, 0.5F);
  CHECK(force.Steady == 2.5F * SContactForce::kMaxGrowth);
}

}  // namespace argos::contact_memory_test
