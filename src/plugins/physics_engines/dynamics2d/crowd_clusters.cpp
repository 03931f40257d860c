#include <argos3/plugins/simulator/physics_engines/dynamics2d/crowd_clusters.h>

#include <algorithm>
#include <cmath>

namespace argos {

namespace {

// discs of a strip, at least
constexpr UInt32 kDiscsOfStrip = 256;
// A strip is at least so many times as wide as two discs that can meet are apart: most pairs are
// then inside.
constexpr Real kStripWidth = 6.0;

}  // namespace

void CCrowdClusters::Reserve(size_t items) {
  m_parent.reserve(items);
  m_isAwake.reserve(items);
  m_clusterOf.reserve(items);
  m_patchOf.reserve(items);
  m_memberOf.reserve(items);
  m_clusters.reserve(items);
  m_patches.reserve(items);
  m_members.reserve(items);
  m_pairs.reserve(2 * items);
  m_walls.reserve(items);
  m_sort.Reserve(2 * items, 2 * items);
}

void CCrowdClusters::Unite(UInt32 a, UInt32 b) {
  Connect(m_parent, a, b);
}

void CCrowdClusters::Unite(const CDiscPairs& discPairs, const CCrowdSolids& solids) {
  m_discPairs = &discPairs;
  m_solids = &solids;
  const size_t count = discPairs.GetDiscs().size() + solids.GetSolids().size();
  ResetForest(m_parent, count);
  m_grips = nullptr;
  for (const CDiscPairs::SPart& part : discPairs.GetParts()) {
    for (const CDiscPairs::SPair& pair : part.Pairs) {
      Unite(pair.A, pair.B);
    }
  }
  for (const CCrowdSolids::SPair& pair : solids.GetPairs()) {
    if (pair.B != CCrowdSolids::kNone) {
      Unite(pair.A, pair.B);
    }
  }
}

void CCrowdClusters::Unite(const std::vector<SCrowdGrip>& grips) {
  m_grips = &grips;
  for (const SCrowdGrip& grip : grips) {
    Unite(grip.Holder, grip.Held);
  }
}

void CCrowdClusters::Build(Real pairReach, const SPeriodicity& period) {
  FindAwake();
  NumberClusters();
  CutIntoStrips(pairReach, period);
  SortMembers();
  SortPairs();
  SortWalls();
  SortTouches();
  SortGrips();
}

SPlanarVector CCrowdClusters::GetCentre(UInt32 item) const {
  if (m_solids->IsSolid(item)) {
    const CCrowdSolids::SSolid& solid = m_solids->GetSolid(item);
    return {solid.X, solid.Y};
  }
  const CDiscPairs::SDisc& disc = m_discPairs->GetDiscs()[item];
  return {disc.X, disc.Y};
}

// Solids that are connected with a disc or with something that moves.
void CCrowdClusters::FindAwake() {
  if (m_solids->GetSolids().empty()) {
    return;
  }
  m_isAwake.assign(GetNumItems(), 0);
  for (UInt32 item = 0; item < GetNumItems(); ++item) {
    if (m_solids->IsSolid(item) ? m_solids->GetSolid(item).IsAwake : m_discPairs->IsNear(item)) {
      m_isAwake[FindRoot(item)] = 1;
    }
  }
}

void CCrowdClusters::NumberClusters() {
  m_clusters.clear();
  m_clusterOf.resize(GetNumItems());
  for (UInt32 item = 0; item < GetNumItems(); ++item) {
    m_clusterOf[item] = kNone;
    if (!m_solids->IsSolid(item) && !m_discPairs->IsNear(item)) {
      continue;
    }
    const UInt32 root = FindRoot(item);
    if (m_solids->IsSolid(item) && m_isAwake[root] == 0) {
      continue;
    }
    const SPlanarVector centre = GetCentre(item);
    if (root == item) {
      m_clusterOf[item] = static_cast<UInt32>(m_clusters.size());
      SExtent& cluster = m_clusters.emplace_back();
      cluster.MinX = cluster.MaxX = centre.X;
      cluster.MinY = cluster.MaxY = centre.Y;
    } else {
      m_clusterOf[item] = m_clusterOf[root];
    }
    SExtent& cluster = m_clusters[m_clusterOf[item]];
    ++cluster.Size;
    cluster.MinX = std::min(cluster.MinX, centre.X);
    cluster.MaxX = std::max(cluster.MaxX, centre.X);
    cluster.MinY = std::min(cluster.MinY, centre.Y);
    cluster.MaxY = std::max(cluster.MaxY, centre.Y);
  }
}

// Small clusters come first, so that each is a patch of its number.
void CCrowdClusters::CutIntoStrips(Real pairReach, const SPeriodicity& period) {
  // bodies that meet across a seam are nearly a period apart
  const auto mayCross = [](const SPeriodicAxis& axis, Real length) {
    return axis.IsOn() && length > 0.5 * axis.Period;
  };
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
    if (mayCross(period.X, width) || mayCross(period.Y, height)) {
      cluster.NumStrips = 1;
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

UInt32 CCrowdClusters::ComputePatch(const SPlanarVector& centre, const SExtent& cluster) const {
  if (cluster.NumStrips == 1) {
    return cluster.FirstPatch;
  }
  const Real along = cluster.AlongX ? centre.X - cluster.MinX : centre.Y - cluster.MinY;
  const UInt32 strip = static_cast<UInt32>(along * cluster.StripsPerMetre);
  return cluster.FirstPatch + std::min(strip, cluster.NumStrips - 1);
}

void CCrowdClusters::SortMembers() {
  m_patchOf.resize(GetNumItems());
  m_memberOf.resize(GetNumItems());
  m_sort.Start(GetNumItems(), m_patches.size());
  for (UInt32 item = 0; item < GetNumItems(); ++item) {
    if (m_clusterOf[item] == kNone) {
      m_patchOf[item] = kNone;
      m_sort.LeaveOut(item);
    } else {
      m_patchOf[item] = ComputePatch(GetCentre(item), m_clusters[m_clusterOf[item]]);
      m_sort.SetKey(item, m_patchOf[item]);
    }
  }
  m_members.resize(m_sort.Finish());
  for (UInt32 item = 0; item < GetNumItems(); ++item) {
    if (m_patchOf[item] != kNone) {
      m_memberOf[item] = m_sort.GetPlace(item);
      m_members[m_memberOf[item]] = {item, m_solids->IsSolid(item)
                                               ? item - m_solids->GetNumDiscs()
                                               : m_discPairs->GetDiscs()[item].Number};
    }
  }
  for (UInt32 patch = 0; patch < m_patches.size(); ++patch) {
    m_patches[patch].FirstDisc = m_sort.Begin(patch);
    m_patches[patch].EndDisc = m_sort.End(patch);
  }
}

// By patch; in each, those inside before those on its border with the next one.
void CCrowdClusters::SortPairs() {
  size_t count = 0;
  for (const CDiscPairs::SPart& part : m_discPairs->GetParts()) {
    count += part.Pairs.size();
  }
  m_sort.Start(count, 2 * m_patches.size());
  size_t item = 0;
  for (const CDiscPairs::SPart& part : m_discPairs->GetParts()) {
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
  for (const CDiscPairs::SPart& part : m_discPairs->GetParts()) {
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

void CCrowdClusters::SortWalls() {
  size_t count = 0;
  for (const CDiscPairs::SPart& part : m_discPairs->GetParts()) {
    count += part.ObstaclePairs.size();
  }
  m_sort.Start(count, m_patches.size());
  size_t item = 0;
  for (const CDiscPairs::SPart& part : m_discPairs->GetParts()) {
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
  for (const CDiscPairs::SPart& part : m_discPairs->GetParts()) {
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

// In the order of pairs.
void CCrowdClusters::SortTouches() {
  const std::vector<CCrowdSolids::SPair>& pairs = m_solids->GetPairs();
  m_sort.Start(pairs.size(), 2 * m_patches.size());
  for (size_t i = 0; i < pairs.size(); ++i) {
    const UInt32 a = m_patchOf[pairs[i].A];
    const UInt32 b = pairs[i].B != CCrowdSolids::kNone ? m_patchOf[pairs[i].B] : a;
    if (a == kNone) {
      m_sort.LeaveOut(i);
    } else {
      m_sort.SetKey(i, 2 * std::min(a, b) + (a == b ? 0 : 1));
    }
  }
  m_touches.resize(m_sort.Finish());
  for (size_t i = 0; i < pairs.size(); ++i) {
    if (!m_sort.IsLeftOut(i)) {
      const CCrowdSolids::SPair& pair = pairs[i];
      m_touches[m_sort.GetPlace(i)] = {m_memberOf[pair.A],
                                       pair.B != CCrowdSolids::kNone ? m_memberOf[pair.B] : kNone,
                                       pair.PartA, pair.PartB};
    }
  }
  for (UInt32 patch = 0; patch < m_patches.size(); ++patch) {
    m_patches[patch].Touches = {m_sort.Begin(2 * patch), m_sort.End(2 * patch)};
    m_patches[patch].BorderTouches = {m_sort.Begin(2 * patch + 1), m_sort.End(2 * patch + 1)};
  }
}

// In the order of grips.
void CCrowdClusters::SortGrips() {
  m_sortedGrips.clear();
  if (m_grips == nullptr || m_grips->empty()) {
    return;
  }
  m_sort.Start(m_grips->size(), 2 * m_patches.size());
  for (size_t i = 0; i < m_grips->size(); ++i) {
    const UInt32 a = m_patchOf[(*m_grips)[i].Holder];
    const UInt32 b = m_patchOf[(*m_grips)[i].Held];
    m_sort.SetKey(i, 2 * std::min(a, b) + (a == b ? 0 : 1));
  }
  m_sortedGrips.resize(m_sort.Finish());
  for (UInt32 i = 0; i < m_grips->size(); ++i) {
    const SCrowdGrip& grip = (*m_grips)[i];
    m_sortedGrips[m_sort.GetPlace(i)] = {m_memberOf[grip.Holder], m_memberOf[grip.Held], i};
  }
  for (UInt32 patch = 0; patch < m_patches.size(); ++patch) {
    m_patches[patch].Grips = {m_sort.Begin(2 * patch), m_sort.End(2 * patch)};
    m_patches[patch].BorderGrips = {m_sort.Begin(2 * patch + 1), m_sort.End(2 * patch + 1)};
  }
}

}  // namespace argos
