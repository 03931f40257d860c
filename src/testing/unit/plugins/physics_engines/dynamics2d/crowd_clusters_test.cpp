// Clusters are the connected components of the pairs, and strips of large ones adjoin.

#include <argos3/core/utility/threads/thread_pool.h>
#include <argos3/plugins/simulator/physics_engines/dynamics2d/crowd_clusters.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <set>

namespace argos::crowd_clusters_test {

namespace {

constexpr Real kRadius = 0.035;  // m
constexpr Real kReach = 0.007;  // m

struct SScene {
  CThreadPool Pool;
  CDiscPairs Pairs;
  CCrowdSolids Solids;
  CCrowdClusters Clusters;

  explicit SScene(UInt32 threads = 0) : Pool(threads, std::make_unique<CBalanceLengthSchedule>()) {}

  void Find(const std::vector<std::pair<Real, Real>>& places) {
    Pairs.Start(places.size());
    for (UInt32 i = 0; i < places.size(); ++i) {
      Pairs.Place(i, places[i].first, places[i].second, kRadius);
    }
    Pairs.Find(Pool, kReach);
    const CPlanarStore store{SPlanarSettings()};
    Solids.Find(store, Pairs, kReach, kReach);
    Clusters.Unite(Pairs, Solids);
  }
  void Build() { Clusters.Build(2.0 * (kRadius + kReach)); }
  // the cluster of each patch
  std::vector<size_t> ListClusters() const {
    std::vector<size_t> clusterOf(Clusters.GetPatches().size());
    for (size_t i = 0; i < Clusters.GetNumSmall(); ++i) {
      clusterOf[i] = i;
    }
    size_t next = Clusters.GetNumSmall();
    for (const SCrowdCluster& cluster : Clusters.GetLarge()) {
      for (UInt32 patch = cluster.FirstPatch; patch < cluster.EndPatch; ++patch) {
        clusterOf[patch] = next;
      }
      ++next;
    }
    return clusterOf;
  }
};

std::vector<std::pair<Real, Real>> Scatter(int count, Real width, Real height) {
  std::mt19937 generator(7);
  std::uniform_real_distribution<Real> along(0.0, width);
  std::uniform_real_distribution<Real> across(0.0, height);
  std::vector<std::pair<Real, Real>> places;
  for (int i = 0; i < count; ++i) {
    const Real x = along(generator);
    places.emplace_back(x, across(generator));
  }
  return places;
}

// the lowest number of the connected component of each disc, by comparing each with each
std::vector<UInt32> FindComponents(const std::vector<std::pair<Real, Real>>& places) {
  std::vector<UInt32> component(places.size());
  for (UInt32 i = 0; i < places.size(); ++i) {
    component[i] = i;
  }
  const Real near = 2.0 * (kRadius + kReach);
  for (bool hasChanged = true; hasChanged;) {
    hasChanged = false;
    for (UInt32 i = 0; i < places.size(); ++i) {
      for (UInt32 j = 0; j < places.size(); ++j) {
        if (component[i] < component[j] &&
            std::hypot(places[i].first - places[j].first, places[i].second - places[j].second) <=
                near) {
          component[j] = component[i];
          hasChanged = true;
        }
      }
    }
  }
  return component;
}

}  // namespace

TEST_CASE("crowd clusters: they are the connected components of discs that can meet",
          "[dynamics2d][crowd]") {
  const Real side = GENERATE(2.0, 4.0, 8.0);
  CAPTURE(side);
  const auto places = Scatter(600, side, side);
  SScene scene;
  scene.Find(places);
  scene.Build();
  const std::vector<UInt32> components = FindComponents(places);
  const std::vector<size_t> clusterOf = scene.ListClusters();
  std::map<size_t, UInt32> componentOfCluster;
  std::set<UInt32> members;
  for (size_t patch = 0; patch < scene.Clusters.GetPatches().size(); ++patch) {
    const SCrowdPatch& each = scene.Clusters.GetPatches()[patch];
    for (UInt32 i = each.FirstDisc; i < each.EndDisc; ++i) {
      const UInt32 number = scene.Clusters.GetMembers()[i].Number;
      members.insert(number);
      const auto [found, isNew] = componentOfCluster.emplace(clusterOf[patch], components[number]);
      REQUIRE(found->second == components[number]);
    }
  }
  // each component is one cluster, and discs that can meet none are in no cluster
  std::set<UInt32> inClusters;
  for (const auto& each : componentOfCluster) {
    REQUIRE(inClusters.insert(each.second).second);
  }
  std::map<UInt32, size_t> sizes;
  for (const UInt32 component : components) {
    ++sizes[component];
  }
  for (UInt32 i = 0; i < places.size(); ++i) {
    REQUIRE((sizes[components[i]] > 1) == (members.count(i) == 1));
  }
}

TEST_CASE("crowd clusters: strips of a large cluster have pairs with adjoining strips only",
          "[dynamics2d][crowd]") {
  const bool isWide = GENERATE(true, false);
  const auto places = Scatter(6000, isWide ? 8.0 : 2.0, isWide ? 2.0 : 8.0);
  SScene scene;
  scene.Find(places);
  scene.Build();
  REQUIRE(scene.Clusters.GetLarge().size() == 1);
  const SCrowdCluster& cluster = scene.Clusters.GetLarge().front();
  CHECK(cluster.EndPatch - cluster.FirstPatch >= 10);
  const auto& patches = scene.Clusters.GetPatches();
  const auto isIn = [&](UInt32 disc, UInt32 patch) {
    return disc >= patches[patch].FirstDisc && disc < patches[patch].EndDisc;
  };
  size_t numPairs = 0;
  for (UInt32 patch = 0; patch < patches.size(); ++patch) {
    for (UInt32 i = patches[patch].FirstPair; i < patches[patch].EndPair; ++i) {
      const auto& pair = scene.Clusters.GetPairs()[i];
      REQUIRE(isIn(pair.A, patch));
      REQUIRE(isIn(pair.B, patch));
      ++numPairs;
    }
    for (UInt32 i = patches[patch].FirstBorder; i < patches[patch].EndBorder; ++i) {
      const auto& pair = scene.Clusters.GetPairs()[i];
      REQUIRE(((isIn(pair.A, patch) && isIn(pair.B, patch + 1)) ||
               (isIn(pair.B, patch) && isIn(pair.A, patch + 1))));
      ++numPairs;
    }
  }
  size_t numFound = 0;
  for (const CDiscPairs::SPart& part : scene.Pairs.GetParts()) {
    numFound += part.Pairs.size();
  }
  CHECK(numPairs == numFound);
}

TEST_CASE("crowd clusters: grips unite clusters, and are in the patch of their bodies",
          "[dynamics2d][crowd]") {
  // 0 - 1 - 2 in a row; 3 - 4; 5 at an obstacle; 6 alone
  SScene scene;
  scene.Pairs.SetObstacles({{3.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.05}});
  scene.Find(
      {{0.0, 0.0}, {0.08, 0.0}, {0.16, 0.0}, {1.0, 0.0}, {1.08, 0.0}, {3.09, 0.0}, {2.0, 0.0}});
  std::vector<SCrowdGrip> grips(2);
  const auto connect = [&](SCrowdGrip& grip, UInt32 holder, UInt32 held) {
    grip.Holder = scene.Pairs.GetPlace(holder);
    grip.Held = scene.Pairs.GetPlace(held);
  };
  connect(grips[0], 5, 6);
  connect(grips[1], 4, 2);
  scene.Pairs.SetNear(grips[0].Held);
  scene.Clusters.Unite(grips);
  scene.Build();
  const auto& members = scene.Clusters.GetMembers();
  REQUIRE(scene.Clusters.GetNumSmall() == 2);
  REQUIRE(scene.Clusters.GetGrips().size() == 2);
  std::set<UInt32> sizes;
  for (const SCrowdPatch& patch : scene.Clusters.GetPatches()) {
    sizes.insert(patch.EndDisc - patch.FirstDisc);
    REQUIRE(patch.Grips.GetSize() == 1);
    CHECK(patch.BorderGrips.GetSize() == 0);
    const auto& grip = scene.Clusters.GetGrips()[patch.Grips.First];
    CHECK(members[grip.Holder].Item == grips[grip.Number].Holder);
    CHECK(members[grip.Held].Item == grips[grip.Number].Held);
    for (const UInt32 member : {grip.Holder, grip.Held}) {
      CHECK((patch.FirstDisc <= member && member < patch.EndDisc));
    }
  }
  CHECK(sizes == std::set<UInt32>{2, 5});
}

TEST_CASE("crowd clusters: their order does not depend on threads", "[dynamics2d][crowd]") {
  const auto places = Scatter(5000, 5.0, 5.0);
  SScene alone;
  alone.Find(places);
  alone.Build();
  SScene scene(3);
  scene.Find(places);
  scene.Build();
  REQUIRE(scene.Clusters.GetMembers().size() == alone.Clusters.GetMembers().size());
  for (size_t i = 0; i < scene.Clusters.GetMembers().size(); ++i) {
    REQUIRE(scene.Clusters.GetMembers()[i].Number == alone.Clusters.GetMembers()[i].Number);
  }
  REQUIRE(scene.Clusters.GetPairs().size() == alone.Clusters.GetPairs().size());
  for (size_t i = 0; i < scene.Clusters.GetPairs().size(); ++i) {
    REQUIRE(scene.Clusters.GetPairs()[i].A == alone.Clusters.GetPairs()[i].A);
    REQUIRE(scene.Clusters.GetPairs()[i].B == alone.Clusters.GetPairs()[i].B);
  }
}

}  // namespace argos::crowd_clusters_test
