// The nonsmooth nonlinear conjugate gradient method, whose steps are the solver's sweeps.

#include <argos3/plugins/simulator/physics_engines/dynamics2d/crowd_solver.h>

#include <argos3/plugins/simulator/physics_engines/dynamics2d/planar_limits.h>

#include <algorithm>

namespace argos {

namespace {

template <typename SEARCH, typename CONTACT>
void Keep(SEARCH& search, const CONTACT& contact) {
  search.Normal = contact.Normal;
  search.Tangent = contact.Tangent;
}

// Makes the change of a sweep the direction, and adds a share of the direction before. @return by
// which impulses along the normal and the tangent are to be changed.
template <typename SEARCH, typename CONTACT>
std::pair<float, float> Turn(SEARCH& search, CONTACT& contact, float share) {
  const float normal = share * search.StepNormal;
  const float tangent = share * search.StepTangent;
  search.StepNormal = normal + contact.Normal - search.Normal;
  search.StepTangent = tangent + contact.Tangent - search.Tangent;
  contact.Normal += normal;
  contact.Tangent += tangent;
  return {normal, tangent};
}

// Of the direction before; 0 starts anew, after a change that has grown.
float ComputeShare(double energy, double before) {
  constexpr double kGrowth = 1.02;
  return energy < kGrowth * before ? static_cast<float>(std::min(1.0, energy / before)) : 0.0F;
}

double Square(float value) {
  return static_cast<double>(value) * static_cast<double>(value);
}

}  // namespace

bool CCrowdSolver::HasTouches(const SCrowdCluster& cluster) const {
  const auto& patches = m_clusters->GetPatches();
  return std::any_of(patches.begin() + cluster.FirstPatch, patches.begin() + cluster.EndPatch,
                     [](const SCrowdPatch& patch) {
                       return patch.Touches.GetSize() + patch.BorderTouches.GetSize() > 0;
                     });
}

void CCrowdSolver::KeepImpulses(UInt32 number) {
  const SCrowdPatch& patch = m_clusters->GetPatches()[number];
  const SPatchState& state = m_states[number];
  for (UInt32 i = patch.FirstDisc; i < patch.EndDisc; ++i) {
    const SCrowdDrive& drive = m_drives[i];
    SDriveSearch& search = m_driveSearches[i];
    search.X = drive.X;
    search.Y = drive.Y;
    search.Angular = drive.Angular;
  }
  for (UInt32 i = patch.FirstPair; i < patch.FirstPair + state.NumContacts; ++i) {
    Keep(m_contactSearches[i], m_contacts[i]);
  }
  for (UInt32 i = patch.FirstWall; i < patch.FirstWall + state.NumWalls; ++i) {
    Keep(m_wallSearches[i], m_wallContacts[i]);
  }
  for (UInt32 i = 2 * patch.Touches.First; i < 2 * patch.Touches.First + state.NumTouches; ++i) {
    Keep(m_touchSearches[i], m_touches[i]);
  }
}

void CCrowdSolver::KeepBorderImpulses(UInt32 number) {
  const SCrowdPatch& patch = m_clusters->GetPatches()[number];
  const SPatchState& state = m_states[number];
  for (UInt32 i = patch.FirstBorder; i < patch.FirstBorder + state.NumBorder; ++i) {
    Keep(m_contactSearches[i], m_contacts[i]);
  }
  const UInt32 first = 2 * patch.BorderTouches.First;
  for (UInt32 i = first; i < first + state.NumBorderTouches; ++i) {
    Keep(m_touchSearches[i], m_touches[i]);
  }
}

// The sum of the squared changes of impulses, each over the mass that resists: an energy, so that
// forces and torques of light and heavy bodies can be added.
void CCrowdSolver::MeasureChange(UInt32 number) {
  const SCrowdPatch& patch = m_clusters->GetPatches()[number];
  SPatchState& state = m_states[number];
  double energy = 0.0;
  for (UInt32 i = patch.FirstDisc; i < patch.EndDisc; ++i) {
    const SCrowdDrive& drive = m_drives[i];
    const SDriveSearch& search = m_driveSearches[i];
    const SCrowdDisc& disc = m_discs[i];
    energy += static_cast<double>(disc.InverseMass) *
                  (Square(drive.X - search.X) + Square(drive.Y - search.Y)) +
              static_cast<double>(disc.InverseInertia) * Square(drive.Angular - search.Angular);
  }
  for (UInt32 i = patch.FirstPair; i < patch.FirstPair + state.NumContacts; ++i) {
    energy += Square(m_contacts[i].Normal - m_contactSearches[i].Normal) /
                  static_cast<double>(m_contacts[i].Mass) +
              Square(m_contacts[i].Tangent - m_contactSearches[i].Tangent) /
                  static_cast<double>(m_contacts[i].TangentMass);
  }
  for (UInt32 i = patch.FirstWall; i < patch.FirstWall + state.NumWalls; ++i) {
    const SCrowdDisc& disc = m_discs[m_wallContacts[i].Disc];
    energy += static_cast<double>(disc.InverseMass) *
              (Square(m_wallContacts[i].Normal - m_wallSearches[i].Normal) +
               Square(m_wallContacts[i].Tangent - m_wallSearches[i].Tangent));
  }
  for (UInt32 i = 2 * patch.Touches.First; i < 2 * patch.Touches.First + state.NumTouches; ++i) {
    energy += Square(m_touches[i].Normal - m_touchSearches[i].Normal) /
                  static_cast<double>(m_touches[i].Mass) +
              Square(m_touches[i].Tangent - m_touchSearches[i].Tangent) /
                  static_cast<double>(m_touches[i].TangentMass);
  }
  state.Energy = energy;
}

void CCrowdSolver::MeasureBorderChange(UInt32 number) {
  const SCrowdPatch& patch = m_clusters->GetPatches()[number];
  SPatchState& state = m_states[number];
  double energy = 0.0;
  for (UInt32 i = patch.FirstBorder; i < patch.FirstBorder + state.NumBorder; ++i) {
    energy += Square(m_contacts[i].Normal - m_contactSearches[i].Normal) /
                  static_cast<double>(m_contacts[i].Mass) +
              Square(m_contacts[i].Tangent - m_contactSearches[i].Tangent) /
                  static_cast<double>(m_contacts[i].TangentMass);
  }
  const UInt32 first = 2 * patch.BorderTouches.First;
  for (UInt32 i = first; i < first + state.NumBorderTouches; ++i) {
    energy += Square(m_touches[i].Normal - m_touchSearches[i].Normal) /
                  static_cast<double>(m_touches[i].Mass) +
              Square(m_touches[i].Tangent - m_touchSearches[i].Tangent) /
                  static_cast<double>(m_touches[i].TangentMass);
  }
  state.BorderEnergy = energy;
}

void CCrowdSolver::StepOn(UInt32 number, float share) {
  const SCrowdPatch& patch = m_clusters->GetPatches()[number];
  const SPatchState& state = m_states[number];
  for (UInt32 i = patch.FirstDisc; i < patch.EndDisc; ++i) {
    SCrowdDrive& drive = m_drives[i];
    SDriveSearch& search = m_driveSearches[i];
    SCrowdDisc& disc = m_discs[i];
    const float x = share * search.StepX;
    const float y = share * search.StepY;
    const float angular = share * search.StepAngular;
    search.StepX = x + drive.X - search.X;
    search.StepY = y + drive.Y - search.Y;
    search.StepAngular = angular + drive.Angular - search.Angular;
    drive.X += x;
    drive.Y += y;
    drive.Angular += angular;
    disc.VX += disc.InverseMass * x;
    disc.VY += disc.InverseMass * y;
    disc.W += disc.InverseInertia * angular;
  }
  for (UInt32 i = patch.FirstPair; i < patch.FirstPair + state.NumContacts; ++i) {
    const auto [normal, tangent] = Turn(m_contactSearches[i], m_contacts[i], share);
    ApplyImpulse(m_contacts[i], normal, tangent);
  }
  for (UInt32 i = patch.FirstWall; i < patch.FirstWall + state.NumWalls; ++i) {
    const auto [normal, tangent] = Turn(m_wallSearches[i], m_wallContacts[i], share);
    ApplyImpulse(m_wallContacts[i], normal, tangent);
  }
  for (UInt32 i = 2 * patch.Touches.First; i < 2 * patch.Touches.First + state.NumTouches; ++i) {
    const auto [normal, tangent] = Turn(m_touchSearches[i], m_touches[i], share);
    ApplyImpulse(m_touches[i], normal, tangent);
  }
}

void CCrowdSolver::StepBorderOn(UInt32 number, float share) {
  const SCrowdPatch& patch = m_clusters->GetPatches()[number];
  const SPatchState& state = m_states[number];
  for (UInt32 i = patch.FirstBorder; i < patch.FirstBorder + state.NumBorder; ++i) {
    const auto [normal, tangent] = Turn(m_contactSearches[i], m_contacts[i], share);
    ApplyImpulse(m_contacts[i], normal, tangent);
  }
  const UInt32 first = 2 * patch.BorderTouches.First;
  for (UInt32 i = first; i < first + state.NumBorderTouches; ++i) {
    const auto [normal, tangent] = Turn(m_touchSearches[i], m_touches[i], share);
    ApplyImpulse(m_touches[i], normal, tangent);
  }
}

// The last thing is a sweep, so that no impulse exceeds its bounds. All sweeps have one direction:
// steps of the method are comparable then.
void CCrowdSolver::IterateSmall(UInt32 number, float tolerance) {
  const SPatchState& state = m_states[number];
  double before = 0.0;
  for (UInt32 sweep = 0; sweep < kMaxTouchSweeps; ++sweep) {
    KeepImpulses(number);
    if (SweepPatch(number, 0) <= tolerance) {
      break;
    }
    MeasureChange(number);
    if (sweep + 1 < kMaxTouchSweeps) {
      StepOn(number, ComputeShare(state.Energy, before));
    }
    before = state.Energy;
  }
}

void CCrowdSolver::IterateLarge(CThreadPool& pool, const SCrowdCluster& cluster, float tolerance) {
  double before = 0.0;
  for (UInt32 sweep = 0; sweep < kMaxTouchSweeps; ++sweep) {
    ForPatches(pool, cluster, [&](UInt32 number) {
      KeepImpulses(number);
      KeepBorderImpulses(number);
    });
    if (!SweepLarge(pool, cluster, 0, tolerance)) {
      break;
    }
    ForPatches(pool, cluster, [&](UInt32 number) {
      MeasureChange(number);
      MeasureBorderChange(number);
      m_states[number].IsDue = true;
    });
    double energy = 0.0;
    for (UInt32 number = cluster.FirstPatch; number < cluster.EndPatch; ++number) {
      energy += m_states[number].Energy + m_states[number].BorderEnergy;
    }
    if (sweep + 1 < kMaxTouchSweeps) {
      const float share = ComputeShare(energy, before);
      ForPatches(pool, cluster, [&](UInt32 number) { StepOn(number, share); });
      ForBorders(pool, cluster, [&](UInt32 number) { StepBorderOn(number, share); });
    }
    before = energy;
  }
}

}  // namespace argos
