#ifndef ARGOS3_TESTING_UNIT_PLUGINS_PHYSICS_ENGINES_DYNAMICS3D_ONE_BODY_WORLD_H
#define ARGOS3_TESTING_UNIT_PLUGINS_PHYSICS_ENGINES_DYNAMICS3D_ONE_BODY_WORLD_H

#include <argos3/core/simulator/geometry/body_description.h>
#include <argos3/plugins/simulator/physics_engines/dynamics3d/ode_session.h>
#include <argos3/plugins/simulator/physics_engines/dynamics3d/rigid_world.h>

#include <array>

namespace argos {

/** A movable body of 1 kg: a cube of 0.1 m. */
struct SOneBodyWorld {
  SBodyDescription Description;
  std::array<Real, 2> Wheels{};  // m/s
  CRigidWorld World{SRigidSettings(), [] {}};

  SOneBodyWorld() {
    UseODEInThisThread();
    Description.Shapes.push_back(SShapeDescription::Box(CVector3(0.1, 0.1, 0.1)));
    Description.Mass = 1.0;
  }
  SRigidBody& Add() {
    SRigidSource source;
    source.Description = &Description;
    if (Description.Drive) {
      source.Drive = CDriveSource(Wheels.data(), Description.Drive->InterwheelDistance);
    }
    return World.Add(source, SRigidPose());
  }
};

}  // namespace argos

#endif
