#include <argos3/plugins/simulator/physics_engines/dynamics2d/planar_limits.h>
#include <argos3/plugins/simulator/physics_engines/dynamics2d/substep_policy.h>

#include <catch2/catch.hpp>

#include <limits>

namespace argos::substep_policy_test {

namespace {

SPlanarSettings MakeSettings(UInt32 substeps, bool refineInCrowds) {
  SPlanarSettings settings;
  settings.Substeps = substeps;
  settings.RefineInCrowds = refineInCrowds;
  return settings;
}

}  // namespace

TEST_CASE("substep policy: a calm tick has the requested number", "[dynamics2d]") {
  CHECK(CSubstepPolicy(MakeSettings(2, true)).ChooseSubsteps({}) == 2);
  CHECK(CSubstepPolicy(MakeSettings(100, false)).ChooseSubsteps({}) == 100);
}

TEST_CASE("substep policy: fast bodies get more substeps, up to a limit", "[dynamics2d]") {
  const CSubstepPolicy policy(MakeSettings(2, false));
  SSubstepNeeds needs;
  needs.ForMotion = 4.2F;
  CHECK(policy.ChooseSubsteps(needs) == 5);
  needs.ForMotion = 1e9F;
  CHECK(policy.ChooseSubsteps(needs) == kMaxSubsteps);
  needs.ForMotion = std::numeric_limits<float>::quiet_NaN();
  CHECK(policy.ChooseSubsteps(needs) == kMaxSubsteps);
}

TEST_CASE("substep policy: overlaps add substeps, calm ticks remove them", "[dynamics2d]") {
  CSubstepPolicy policy(MakeSettings(2, true));
  for (UInt32 tick = 1; tick <= kMaxExtraSubsteps; ++tick) {
    policy.FinishTick(2.0F * kTooDeep, 0.0F);
    CHECK(policy.ChooseSubsteps({}) == 2 + tick);
  }
  policy.FinishTick(2.0F * kTooDeep, 0.0F);
  CHECK(policy.ChooseSubsteps({}) == 2 + kMaxExtraSubsteps);
  // a medium overlap restarts the count of calm ticks
  for (UInt32 tick = 1; tick < kCalmTicks; ++tick) {
    policy.FinishTick(0.0F, 0.0F);
  }
  policy.FinishTick(0.5F * (kShallow + kTooDeep), 0.0F);
  policy.FinishTick(0.0F, 0.0F);
  CHECK(policy.ChooseSubsteps({}) == 2 + kMaxExtraSubsteps);
  for (UInt32 tick = 1; tick < kCalmTicks; ++tick) {
    policy.FinishTick(0.0F, 0.0F);
  }
  CHECK(policy.ChooseSubsteps({}) == 1 + kMaxExtraSubsteps);
}

TEST_CASE("substep policy: an explicit number is not refined for crowds or grips", "[dynamics2d]") {
  CSubstepPolicy policy(MakeSettings(2, false));
  policy.FinishTick(2.0F * kTooDeep, 1e6F);
  SSubstepNeeds needs;
  needs.IsHolding = true;
  needs.WeakestDrive = 1e-3;
  CHECK_FALSE(policy.UsesWeakestDrive());
  CHECK(policy.ChooseSubsteps(needs) == 2);
}

TEST_CASE("substep policy: a grip bounds the substep", "[dynamics2d]") {
  const CSubstepPolicy policy(MakeSettings(2, true));
  SSubstepNeeds needs;
  needs.IsHolding = true;
  // a tick of 0.1 s, substeps of at most 0.01 s
  CHECK(policy.ChooseSubsteps(needs) == 10);
  CHECK(policy.ChooseIterations(10, true) == kVelocityIterations);
  CHECK(policy.ChooseIterations(2, true) == kMaxGripIterations);
}

TEST_CASE("substep policy: contact forces of a crowd add substeps in proportion", "[dynamics2d]") {
  CSubstepPolicy policy(MakeSettings(2, true));
  SSubstepNeeds needs;
  needs.WeakestDrive = 0.0025;  // its root is 0.05 N s, 0.5 in units of 0.1 m
  CHECK_FALSE(policy.UsesWeakestDrive());
  // 0.1 s * 100 kg units / s^2 = 10 kg units / s, 20 times the weakest drive
  policy.FinishTick(0.0F, 100.0F);
  REQUIRE(policy.UsesWeakestDrive());
  CHECK(policy.ChooseSubsteps(needs) == static_cast<UInt32>(20.0F * kSubstepsPerDrive));
  policy.FinishTick(0.0F, 200.0F);
  CHECK(policy.ChooseSubsteps(needs) == static_cast<UInt32>(40.0F * kSubstepsPerDrive));
  policy.FinishTick(0.0F, 1e9F);
  CHECK(policy.ChooseSubsteps(needs) == kMaxSubsteps);
}

TEST_CASE("substep policy: crowds with many substeps need fewer iterations", "[dynamics2d]") {
  const CSubstepPolicy policy(MakeSettings(2, true));
  CHECK(policy.ChooseIterations(kFewSubsteps, false) == kVelocityIterations);
  CHECK(policy.ChooseIterations(kFewSubsteps + 1, false) == kCrowdVelocityIterations);
}

}  // namespace argos::substep_policy_test
