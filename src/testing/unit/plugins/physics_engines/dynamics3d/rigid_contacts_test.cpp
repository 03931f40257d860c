// What contacts keep of the last substep.

#include <argos3/plugins/simulator/physics_engines/dynamics3d/rigid_body.h>
#include <argos3/plugins/simulator/physics_engines/dynamics3d/rigid_contacts.h>

#include <catch2/catch.hpp>

#include <vector>

namespace rigid_contacts_test {

using namespace argos;

namespace {

/* Two bodies that do not move. */
struct SBodies {
  SRigidBody First;
  SRigidBody Second;

  SRigidContact& Touch(CRigidContacts& contacts, UInt64 key, Real x, Real force = 0.0) const {
    SRigidContact& contact = contacts.Add();
    contact.First = &First;
    contact.Second = &Second;
    contact.Key = key;
    contact.Place.Set(x, 0.0, 0.0);
    contact.Force = force;
    contact.Friction.Set(0.0, force, 0.0);
    contact.Settled = 0.5 * force;
    return contact;
  }
};

std::vector<Real> ListForces(const CRigidContacts& contacts) {
  std::vector<Real> forces;
  for (const SRigidContact& contact : contacts.Get()) {
    CHECK(contact.Friction == CVector3(0.0, contact.Force, 0.0));
    CHECK(contact.Settled == 0.5 * contact.Force);
    forces.push_back(contact.Force);
  }
  return forces;
}

}  // namespace

TEST_CASE("rigid contacts: each starts with the force of the nearest one that is left",
          "[dynamics3d]") {
  const SBodies bodies;
  CRigidContacts contacts;
  contacts.StartSubstep();
  bodies.Touch(contacts, 5, 0.0, 1.0);
  bodies.Touch(contacts, 5, 1.0, 2.0);
  bodies.Touch(contacts, 5, 3.0, 3.0);
  bodies.Touch(contacts, 9, 0.0, 7.0);
  contacts.StartSubstep();
  // the nearest, those that are left, and none; of two that are as near, the first
  for (const Real x : {0.9, 0.8, 0.7, 0.7}) {
    bodies.Touch(contacts, 5, x);
  }
  bodies.Touch(contacts, 9, 100.0);
  bodies.Touch(contacts, 4, 0.0);
  contacts.InheritForces();
  CHECK(ListForces(contacts) == std::vector<Real>{2.0, 1.0, 3.0, 0.0, 7.0, 0.0});
  contacts.StartSubstep();
  bodies.Touch(contacts, 5, 0.95);
  contacts.InheritForces();
  CHECK(ListForces(contacts) == std::vector<Real>{2.0});
  // what was not there in the last substep is forgotten
  contacts.StartSubstep();
  bodies.Touch(contacts, 9, 100.0);
  contacts.InheritForces();
  CHECK(ListForces(contacts) == std::vector<Real>{0.0});
  bodies.Touch(contacts, 9, 100.0, 4.0);
  contacts.Forget();
  contacts.StartSubstep();
  bodies.Touch(contacts, 9, 100.0);
  contacts.InheritForces();
  CHECK(ListForces(contacts) == std::vector<Real>{0.0});
}

TEST_CASE("rigid contacts: forces of bodies that doze are kept until they are awake",
          "[dynamics3d]") {
  SBodies bodies;
  // the first one cannot move, so that the second one counts
  bodies.First.Dozes = GENERATE(false, true);
  bodies.Second.Dozes = GENERATE(false, true);
  CAPTURE(bodies.First.Dozes, bodies.Second.Dozes);
  const bool isKept = bodies.Second.Dozes;
  CRigidContacts contacts;
  contacts.StartSubstep();
  bodies.Touch(contacts, 5, 0.0, 1.0);
  contacts.KeepDozing();
  for (int substep = 0; substep < 3; ++substep) {
    contacts.StartSubstep();
  }
  bodies.Touch(contacts, 5, 0.0);
  contacts.InheritForces();
  CHECK(ListForces(contacts) == std::vector<Real>{isKept ? 1.0 : 0.0});
  // those of the last substep come first
  contacts.Get()[0].Force = 4.0;
  contacts.Get()[0].Friction.Set(0.0, 4.0, 0.0);
  contacts.Get()[0].Settled = 2.0;
  contacts.StartSubstep();
  bodies.Touch(contacts, 5, 0.0);
  contacts.InheritForces();
  CHECK(ListForces(contacts) == std::vector<Real>{4.0});
  contacts.ForgetDozing();
  contacts.StartSubstep();
  contacts.StartSubstep();
  bodies.Touch(contacts, 5, 0.0);
  contacts.InheritForces();
  CHECK(ListForces(contacts) == std::vector<Real>{0.0});
}

}  // namespace rigid_contacts_test
