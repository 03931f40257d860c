#include <argos3/plugins/simulator/physics_engines/dynamics2d/crowd_clusters.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace argos {

namespace {

// discs of a strip, at least
constexpr UInt32 kDiscsOfStrip = 256;
// A strip is at least so many times as wide as two discs that can meet are apart: most pairs are
// then inside.
constexpr Real kStripWidth = 6.0;

}  // namespace

void CCrowdClusters::Reserve(size_t discs) {
  m_parent.reserve(discs);
  m_isExcluded.reserve(discs);
  m_clusterOf.reserve(discs);
  m_patchOf.reserve(discs);
  m_memberOf.reserve(discs);
  m_clusters.reserve(discs);
  m_patches.reserve(discs);
  m_members.reserve(discs);
  m_pairs.reserve(2 * discs);
  m_walls.reserve(discs);
  m_sort.Reserve(2 * discs, 2 * discs);
}

void CCrowdClusters::Unite(const CDiscPairs& discPairs) {
  const size_t count = discPairs.GetDiscs().size();
  m_parent.resize(count);
  std::iota(m_parent.begin(), m_parent.end(), 0U);
  m_isExcluded.assign(count, 0);
  m_hasExcluded = false;
  for (const CDiscPairs::SPart& part : discPairs.GetParts()) {
    for (const CDiscPairs::SPair& pair : part.Pairs) {
      // the first place is the root
      const UInt32 a = FindRoot(pair.A);
      const UInt32 b = FindRoot(pair.B);
      m_parent[std::max(a, b)] = std::min(a, b);
    }
  }
}

void CCrowdClusters::Build(const CDiscPairs& discPairs, Real pairReach) {
  NumberClusters(discPairs);
  CutIntoStrips(pairReach);
  SortMembers(discPairs);
  SortPairs(discPairs);
  SortWalls(discPairs);
}

void CCrowdClusters::NumberClusters(const CDiscPairs& discPairs) {
  const std::vector<CDiscPairs::SDisc>& discs = discPairs.GetDiscs();
  m_clusters.clear();
  m_clusterOf.resize(discs.size());
  for (UInt32 place = 0; place < discs.size(); ++place) {
    m_clusterOf[place] = kNone;
    if (!discPairs.IsNear(place)) {
      continue;
    }
    const UInt32 root = FindRoot(place);
    if (m_isExcluded[root] != 0) {
      continue;
    }
    const CDiscPairs::SDisc& disc = discs[place];
    if (root == place) {
      m_clusterOf[place] = static_cast<UInt32>(m_clusters.size());
      SExtent& cluster = m_clusters.emplace_back();
      cluster.MinX = cluster.MaxX = disc.X;
      cluster.MinY = cluster.MaxY = disc.Y;
    } else {
      m_clusterOf[place] = m_clusterOf[root];
    }
    SExtent& cluster = m_clusters[m_clusterOf[place]];
    ++cluster.Size;
    cluster.MinX = std::min(cluster.MinX, disc.X);
    cluster.MaxX = std::max(cluster.MaxX, disc.X);
    cluster.MinY = std::min(cluster.MinY, disc.Y);
    cluster.MaxY = std::max(cluster.MaxY, disc.Y);
  }
}

// Small clusters come first, so that each is a patch of its number.
void CCrowdClusters::CutIntoStrips(Real pairReach) {
  m_numSmall = 0;
  for (SExtent& cluster : m_clusters) {
    const Real width = cluster.MaxX - cluster.MinX;
    const Real height = cluster.MaxY - cluster.MinY;
    const Real length = std::max(width, height);
    const Real most = std::max(1.0, std::floor(length / (kStripWidth * pairReach)));
    cluster.NumStrips = std::max(1U, cluster.Size / kDiscsOfStrip);
    if (static_cast<Real>(cluster.NumStrips) > most) {
      cluster.NumStrips = static_cast<UInt32>(most);
    }
    cluster.AlongX = width > height;
    cluster.StripsPerMetre = length > 0.0 ? static_cast<Real>(cluster.NumStrips) / length : 0.0;
    if (cluster.NumStrips == 1) {
      cluster.FirstPatch = static_cast<UInt32>(m_numSmall++);
    }
  }
  UInt32 patch = static_cast<UInt32>(m_numSmall);
  m_large.clear();
  for (SExtent& cluster : m_clusters) {
    if (cluster.NumStrips > 1) {
      cluster.FirstPatch = patch;
      patch += cluster.NumStrips;
      m_large.push_back({cluster.FirstPatch, patch});
    }
  }
  m_patches.assign(patch, SCrowdPatch());
}

UInt32 CCrowdClusters::ComputePatch(const CDiscPairs::SDisc& disc, const SExtent& cluster) const {
  if (cluster.NumStrips == 1) {
    return cluster.FirstPatch;
  }
  const Real along = cluster.AlongX ? disc.X - cluster.MinX : disc.Y - cluster.MinY;
  const UInt32 strip = static_cast<UInt32>(along * cluster.StripsPerMetre);
  return cluster.FirstPatch + std::min(strip, cluster.NumStrips - 1);
}

void CCrowdClusters::SortMembers(const CDiscPairs& discPairs) {
  const std::vector<CDiscPairs::SDisc>& discs = discPairs.GetDiscs();
  m_patchOf.resize(discs.size());
  m_memberOf.resize(discs.size());
  m_sort.Start(discs.size(), m_patches.size());
  for (UInt32 place = 0; place < discs.size(); ++place) {
    if (m_clusterOf[place] == kNone) {
      m_patchOf[place] = kNone;
      m_sort.LeaveOut(place);
    } else {
      m_patchOf[place] = ComputePatch(discs[place], m_clusters[m_clusterOf[place]]);
      m_sort.SetKey(place, m_patchOf[place]);
    }
  }
  m_members.resize(m_sort.Finish());
  for (UInt32 place = 0; place < discs.size(); ++place) {
    if (m_patchOf[place] != kNone) {
      m_memberOf[place] = m_sort.GetPlace(place);
      m_members[m_memberOf[place]] = {place, discs[place].Number};
    }
  }
  for (UInt32 patch = 0; patch < m_patches.size(); ++patch) {
    m_patches[patch].FirstDisc = m_sort.Begin(patch);
    m_patches[patch].EndDisc = m_sort.End(patch);
  }
}

// By patch; in each, those inside before those on its border with the next one.
void CCrowdClusters::SortPairs(const CDiscPairs& discPairs) {
  size_t count = 0;
  for (const CDiscPairs::SPart& part : discPairs.GetParts()) {
    count += part.Pairs.size();
  }
  m_sort.Start(count, 2 * m_patches.size());
  size_t item = 0;
  for (const CDiscPairs::SPart& part : discPairs.GetParts()) {
    for (const CDiscPairs::SPair& pair : part.Pairs) {
      const UInt32 a = m_patchOf[pair.A];
      const UInt32 b = m_patchOf[pair.B];
      if (a == kNone) {
        m_sort.LeaveOut(item);
      } else {
        m_sort.SetKey(item, 2 * std::min(a, b) + (a == b ? 0 : 1));
      }
      ++item;
    }
  }
  m_pairs.resize(m_sort.Finish());
  item = 0;
  for (const CDiscPairs::SPart& part : discPairs.GetParts()) {
    for (const CDiscPairs::SPair& pair : part.Pairs) {
      if (!m_sort.IsLeftOut(item)) {
        m_pairs[m_sort.GetPlace(item)] = {m_memberOf[pair.A], m_memberOf[pair.B]};
      }
      ++item;
    }
  }
  for (UInt32 patch = 0; patch < m_patches.size(); ++patch) {
    m_patches[patch].FirstPair = m_sort.Begin(2 * patch);
    m_patches[patch].EndPair = m_patches[patch].FirstBorder = m_sort.End(2 * patch);
    m_patches[patch].EndBorder = m_sort.End(2 * patch + 1);
  }
}

void CCrowdClusters::SortWalls(const CDiscPairs& discPairs) {
  size_t count = 0;
  for (const CDiscPairs::SPart& part : discPairs.GetParts()) {
    count += part.ObstaclePairs.size();
  }
  m_sort.Start(count, m_patches.size());
  size_t item = 0;
  for (const CDiscPairs::SPart& part : discPairs.GetParts()) {
    for (const CDiscPairs::SObstaclePair& pair : part.ObstaclePairs) {
      if (m_patchOf[pair.Disc] == kNone) {
        m_sort.LeaveOut(item);
      } else {
        m_sort.SetKey(item, m_patchOf[pair.Disc]);
      }
      ++item;
    }
  }
  m_walls.resize(m_sort.Finish());
  item = 0;
  for (const CDiscPairs::SPart& part : discPairs.GetParts()) {
    for (const CDiscPairs::SObstaclePair& pair : part.ObstaclePairs) {
      if (!m_sort.IsLeftOut(item)) {
        m_walls[m_sort.GetPlace(item)] = {m_memberOf[pair.Disc], pair.Obstacle};
      }
      ++item;
    }
  }
  for (UInt32 patch = 0; patch < m_patches.size(); ++patch) {
    m_patches[patch].FirstWall = m_sort.Begin(patch);
    m_patches[patch].EndWall = m_sort.End(patch);
  }
}

}  // namespace argos
