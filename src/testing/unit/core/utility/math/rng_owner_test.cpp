#include <argos3/core/utility/math/rng_owner.h>

#include <catch2/catch.hpp>

#include <memory>
#include <set>
#include <string>
#include <thread>
#include <vector>

namespace rng_owner_test {

using namespace argos;

namespace {

using TScope = CRandom::COwner::CScope;

std::unique_ptr<CRandom::COwner> MakeOwner(const std::string& id) {
  auto owner = std::make_unique<CRandom::COwner>();
  static std::set<std::string> ids;  // to which the owners refer
  owner->SetId([](const void* subject) { return *static_cast<const std::string*>(subject); },
               &*ids.insert(id).first);
  return owner;
}

CRandom::CRNG* CreateFor(CRandom::CCategory& category, CRandom::COwner& owner, UInt64 birth) {
  const TScope scope(&owner, birth);
  return category.CreateRNG();
}

}  // namespace

TEST_CASE("random owners: generators are destroyed with their owner, others are kept",
          "[core][math]") {
  CRandom::CCategory category("argos", 42);
  category.CreateRNG();
  for (int i = 0; i < 1000; ++i) {
    const auto owner = MakeOwner("robot" + std::to_string(i));
    CreateFor(category, *owner, 3);
    CreateFor(category, *owner, 3);
    REQUIRE(category.GetNumRNGs() == 3);
    REQUIRE(owner->GetNumRNGs() == 2);
  }
  CHECK(category.GetNumRNGs() == 1);
}

TEST_CASE("random owners: a category that ends before an owner takes the generators with it",
          "[core][math]") {
  const auto owner = MakeOwner("robot");
  CRandom::CCategory kept("kept", 1);
  CreateFor(kept, *owner, 0);
  {
    CRandom::CCategory category("argos", 42);
    CreateFor(category, *owner, 0);
    CHECK(owner->GetNumRNGs() == 2);
  }
  CHECK(owner->GetNumRNGs() == 1);
  owner->DestroyGenerators();
  CHECK(kept.GetNumRNGs() == 0);
}

TEST_CASE("random owners: while loading, seeds follow the order of creation", "[core][math]") {
  CRandom::CCategory category("argos", 42);
  CRandom::CCategory plain("argos", 42);
  const auto first = MakeOwner("a");
  const auto second = MakeOwner("b");
  CHECK(category.CreateRNG()->GetSeed() == plain.CreateRNG()->GetSeed());
  CHECK(CreateFor(category, *first, TScope::kLoading)->GetSeed() == plain.CreateRNG()->GetSeed());
  CHECK(CreateFor(category, *second, TScope::kLoading)->GetSeed() == plain.CreateRNG()->GetSeed());
  CHECK(CreateFor(category, *first, TScope::kLoading)->GetSeed() == plain.CreateRNG()->GetSeed());
}

TEST_CASE("random owners: seeds do not depend on destroyed generators", "[core][math]") {
  CRandom::CCategory category("argos", 42);
  auto first = MakeOwner("a");
  const auto second = MakeOwner("b");
  const UInt32 firstSeed = CreateFor(category, *first, TScope::kLoading)->GetSeed();
  const CRandom::CRNG* const kept = CreateFor(category, *second, TScope::kLoading);
  const UInt32 keptSeed = kept->GetSeed();
  const CRandom::CRNG* const common = category.CreateRNG();
  const UInt32 commonSeed = common->GetSeed();

  // owners of a run that are destroyed and created again in another order
  const auto seedsOf = [&](const std::vector<std::string>& ids) {
    std::vector<std::unique_ptr<CRandom::COwner>> owners;
    std::set<std::pair<std::string, UInt32>> seeds;
    for (const std::string& id : ids) {
      owners.push_back(MakeOwner(id));
      seeds.emplace(id, CreateFor(category, *owners.back(), 7)->GetSeed());
      seeds.emplace(id, CreateFor(category, *owners.back(), 7)->GetSeed());
    }
    return seeds;
  };
  const auto seeds = seedsOf({"c", "d", "e"});
  CHECK(seeds.size() == 6);
  CHECK(seedsOf({"e", "c", "d"}) == seeds);

  first.reset();
  category.ResetRNGs();
  CHECK(kept->GetSeed() == keptSeed);
  CHECK(common->GetSeed() == commonSeed);
  CHECK(seedsOf({"d", "e", "c"}) == seeds);

  // another birth is another stream; at clock 0 that of the start is repeated
  const auto again = MakeOwner("a");
  const CRandom::CRNG* const reborn = CreateFor(category, *again, 5);
  CHECK(reborn->GetSeed() != firstSeed);
  category.ResetRNGs();
  CHECK(reborn->GetSeed() == firstSeed);
  again->DestroyGenerators();
  CHECK(CreateFor(category, *again, 0)->GetSeed() == firstSeed);

  // all of them follow the category's seed
  category.SetSeed(43);
  category.ResetRNGs();
  CHECK(kept->GetSeed() != keptSeed);
  CHECK(seedsOf({"c", "d", "e"}) != seeds);
}

TEST_CASE("random owners: reseeding gives owned generators other streams", "[core][math]") {
  CRandom::CCategory category("argos", 42);
  const auto owner = MakeOwner("a");
  const CRandom::CRNG* const late = CreateFor(category, *owner, 5);
  const UInt32 seed = late->GetSeed();
  category.ReseedRNGs();
  CHECK(late->GetSeed() != seed);
  category.ResetRNGs();
  CHECK(late->GetSeed() == seed);
}

TEST_CASE("random owners: a scope ends with the owner that was current before", "[core][math]") {
  CRandom::CCategory category("argos", 42);
  const auto outer = MakeOwner("a");
  const auto inner = MakeOwner("b");
  {
    const TScope scope(outer.get(), 1);
    CreateFor(category, *inner, 1);
    category.CreateRNG();
  }
  category.CreateRNG();
  CHECK(inner->GetNumRNGs() == 1);
  CHECK(outer->GetNumRNGs() == 1);
  CHECK(category.GetNumRNGs() == 3);
}

TEST_CASE("random owners: several threads may create generators at a time",
          "[core][math][threads]") {
  constexpr size_t kThreads = 4;
  constexpr size_t kEach = 200;
  CRandom::CCategory category("argos", 42);
  std::vector<std::unique_ptr<CRandom::COwner>> owners;
  for (size_t i = 0; i < kThreads * kEach; ++i) {
    owners.push_back(MakeOwner("robot" + std::to_string(i)));
  }
  std::vector<UInt32> seeds(owners.size());
  std::vector<std::thread> threads;
  for (size_t thread = 0; thread < kThreads; ++thread) {
    threads.emplace_back([&, thread] {
      for (size_t i = thread; i < owners.size(); i += kThreads) {
        seeds[i] = CreateFor(category, *owners[i], 1)->GetSeed();
      }
    });
  }
  for (std::thread& thread : threads) {
    thread.join();
  }
  CHECK(category.GetNumRNGs() == owners.size());
  for (size_t i = 0; i < owners.size(); ++i) {
    owners[i]->DestroyGenerators();
    REQUIRE(CreateFor(category, *owners[i], 1)->GetSeed() == seeds[i]);
  }
}

}  // namespace rng_owner_test
