// A library of a controller, a sensor, an actuator, a medium and loop functions that do on request
// what users' code must not do, or may do only in some places.

#include <argos3/core/control_interface/ci_controller.h>
#include <argos3/core/simulator/actuator.h>
#include <argos3/core/simulator/loop_functions.h>
#include <argos3/core/simulator/medium/medium.h>
#include <argos3/core/simulator/sensor.h>
#include <argos3/core/simulator/simulator.h>
#include <argos3/plugins/robots/e-puck/simulator/epuck_entity.h>
#include <argos3/plugins/robots/generic/control_interface/ci_differential_steering_actuator.h>
#include <argos3/plugins/simulator/entities/box_entity.h>

#include <malloc.h>

#include <csignal>
#include <cstdlib>
#include <functional>
#include <map>
#include <new>
#include <stdexcept>

using namespace argos;

namespace {

CSimulator& Simulator() {
  return CSimulator::GetInstance();
}

CLoopFunctions& Loop() {
  return Simulator().GetLoopFunctions();
}

// calls itself until the stack is full; the compiler must not turn it into a loop
__attribute__((noinline)) int OverflowStack(volatile int* previous) {
  volatile int frame[1024];
  frame[0] = previous != nullptr ? *previous + 1 : 0;
  // never reached, but the compiler must not know
  if (frame[0] < 0) {
    return 0;
  }
  return OverflowStack(frame) + frame[0];
}

// overwrites what follows a block in memory; the C library aborts in one of the next allocations,
// with its locks held
void DamageHeap() {
  constexpr size_t kBlock = 100000;  // from the free end of the heap
  for (int i = 0; i < 100; ++i) {
    auto* const block = static_cast<volatile size_t*>(std::malloc(kBlock));
    const size_t end = malloc_usable_size(const_cast<size_t*>(block)) / sizeof(size_t);
    block[end] = 3;
  }
}

void RemoveAll() {
  const CEntity::TVector roots = Loop().GetSpace().GetRootEntityVector();
  for (CEntity* root : roots) {
    Loop().RemoveEntity(*root);
  }
}

void RemoveUntilNothingIsLeft() {
  CEntity::TVector& roots = Loop().GetSpace().GetRootEntityVector();
  while (!roots.empty()) {
    Loop().RemoveEntity(*roots.back());
  }
}

/*
 * What is done on request, by name.
 * @param robot  its id; empty in loop functions and media.
 */
using TDeed = std::function<void(const std::string& robot)>;

const std::map<std::string, TDeed>& Deeds() {
  static const std::map<std::string, TDeed> deeds = {
      {"throw", [](const std::string&) { throw std::runtime_error("deliberate error"); }},
      {"throw_int", [](const std::string&) { throw 42; }},
      {"throw_bad_alloc", [](const std::string&) { throw std::bad_alloc(); }},
      {"segv", [](const std::string&) { *static_cast<volatile int*>(nullptr) = 1; }},
      {"overflow", [](const std::string&) { OverflowStack(nullptr); }},
      {"damage_heap", [](const std::string&) { DamageHeap(); }},
      {"abort", [](const std::string&) { std::abort(); }},
      {"fpe", [](const std::string&) { raise(SIGFPE); }},
      {"bus", [](const std::string&) { raise(SIGBUS); }},
      {"ill", [](const std::string&) { raise(SIGILL); }},
      {"remove_self", [](const std::string& robot) { Loop().RemoveEntity(robot); }},
      {"remove_all", [](const std::string&) { RemoveAll(); }},
      {"remove_until_empty", [](const std::string&) { RemoveUntilNothingIsLeft(); }},
      {"remove_by_operation",
       [](const std::string& robot) {
         CSpace& space = Loop().GetSpace();
         CallEntityOperation<CSpaceOperationRemoveEntity, CSpace, void>(space,
                                                                        space.GetEntity(robot));
       }},
      {"exit", [](const std::string&) { std::exit(7); }},
      {"add_box",
       [](const std::string& robot) {
         Loop().AddEntity(*new CBoxEntity("box_of_" + robot, CVector3(8, 8, 0), CQuaternion(),
                                          false, CVector3(0.1, 0.1, 0.1)));
       }},
      {"add_robot",
       [](const std::string& robot) {
         Loop().AddEntity(
             *new CEPuckEntity("child_of_" + robot, "idle", CVector3(4, 4, 0), CQuaternion()));
       }},
      {"destroy", [](const std::string&) { Simulator().Destroy(); }},
      {"reset", [](const std::string&) { Simulator().Reset(); }},
      {"update_space", [](const std::string&) { Simulator().UpdateSpace(); }},
      {"update_of_space", [](const std::string&) { Loop().GetSpace().Update(); }},
      {"reset_of_space", [](const std::string&) { Loop().GetSpace().Reset(); }},
      {"destroy_of_space", [](const std::string&) { Loop().GetSpace().Destroy(); }},
      {"execute", [](const std::string&) { Simulator().Execute(); }},
      {"load", [](const std::string&) { Simulator().LoadExperiment(); }},
      {"iterate",
       [](const std::string&) {
         Loop().IterateOverControllableEntities([](CControllableEntity*) {});
       }},
      {"set_controller",
       [](const std::string& robot) {
         dynamic_cast<CEPuckEntity&>(Loop().GetSpace().GetEntity(robot))
             .GetControllableEntity()
             .SetController("idle");
       }},
  };
  return deeds;
}

/* One deed, in one place, in one tick (0: in any), by one robot (empty: by each). */
class CPlan {
 public:
  void Init(TConfigurationNode& node) {
    GetNodeAttributeOrDefault(node, "where", m_where, m_where);
    GetNodeAttributeOrDefault(node, "what", m_what, m_what);
    GetNodeAttributeOrDefault(node, "robot", m_robot, m_robot);
    GetNodeAttributeOrDefault(node, "tick", m_tick, m_tick);
  }
  void Do(const std::string& where, const std::string& robot) const {
    const bool isNow = m_tick == 0 || Loop().GetSpace().GetSimulationClock() == m_tick;
    if (where == m_where && isNow && (m_robot.empty() || m_robot == robot)) {
      Deeds().at(m_what)(robot);
    }
  }

 private:
  std::string m_where;
  std::string m_what;
  std::string m_robot;
  UInt32 m_tick = 0;
};

/* Drives in circles, logs its steps if asked to, and carries out its plan. */
class CMisbehaves : public CCI_Controller {
 public:
  void Init(TConfigurationNode& params) override {
    m_plan.Init(params);
    GetNodeAttributeOrDefault(params, "logs", m_logs, m_logs);
    if (HasActuator("differential_steering")) {
      m_wheels = GetActuator<CCI_DifferentialSteeringActuator>("differential_steering");
    }
    m_plan.Do("init", GetId());
  }
  void ControlStep() override {
    if (m_logs) {
      LOG << GetId() << " steps" << std::endl;
    }
    if (m_wheels != nullptr) {
      m_wheels->SetLinearVelocity(5.0, 4.0);
    }
    m_plan.Do("step", GetId());
  }
  void Reset() override { m_plan.Do("reset", GetId()); }
  void Destroy() override { m_plan.Do("destroy", GetId()); }

 private:
  CPlan m_plan;
  CCI_DifferentialSteeringActuator* m_wheels = nullptr;
  bool m_logs = false;
};

class CIdle : public CCI_Controller {};

/** @tparam SIMULATED, INTERFACE  those of sensors or of actuators. */
template <typename SIMULATED, typename INTERFACE>
class CMisbehavingDevice : public SIMULATED, public INTERFACE {
 public:
  void SetRobot(CComposableEntity& robot) override { m_robot = robot.GetId(); }
  void Init(TConfigurationNode& node) override {
    INTERFACE::Init(node);
    m_plan.Init(node);
    m_plan.Do("init", m_robot);
  }
  void Update() override { m_plan.Do("update", m_robot); }
  void Reset() override { m_plan.Do("reset", m_robot); }
  void Destroy() override { m_plan.Do("destroy", m_robot); }

 private:
  CPlan m_plan;
  std::string m_robot;
};

class CMisbehavingSensor : public CMisbehavingDevice<CSimulatedSensor, CCI_Sensor> {};
class CMisbehavingActuator : public CMisbehavingDevice<CSimulatedActuator, CCI_Actuator> {};

class CMisbehavingMedium : public CMedium {
 public:
  void Init(TConfigurationNode& node) override {
    CMedium::Init(node);
    m_plan.Init(node);
    m_plan.Do("init", "");
  }
  void Update() override { m_plan.Do("update", ""); }

 private:
  CPlan m_plan;
};

class CMisbehavingLoop : public CLoopFunctions {
 public:
  void Init(TConfigurationNode& node) override {
    m_plan.Init(node);
    m_plan.Do("init", "ep0");
  }
  void Reset() override { m_plan.Do("reset", "ep0"); }
  void Destroy() override { m_plan.Do("destroy", "ep0"); }
  void PreStep() override { DoAndCount("pre_step"); }
  void PostStep() override { DoAndCount("post_step"); }
  bool IsExperimentFinished() override {
    m_plan.Do("is_experiment_finished", "ep0");
    return false;
  }
  void PostExperiment() override { m_plan.Do("post_experiment", "ep0"); }
  CColor GetFloorColor(const CVector2&) override {
    m_plan.Do("floor_color", "ep0");
    return CColor::WHITE;
  }

 private:
  // what hooks add and remove is added and removed at once
  void DoAndCount(const std::string& hook) {
    const size_t before = GetSpace().GetRootEntityVector().size();
    m_plan.Do(hook, "ep0");
    const size_t after = GetSpace().GetRootEntityVector().size();
    if (before != after) {
      LOG << "from " << before << " to " << after << " roots in " << hook << std::endl;
    }
  }

  CPlan m_plan;
};

}  // namespace

REGISTER_CONTROLLER(CMisbehaves, "test_misbehaves")
REGISTER_CONTROLLER(CIdle, "test_stays_idle")
REGISTER_SENSOR(CMisbehavingSensor, "test_misbehaving", "default", "the authors of this project",
                "1.0", "For tests.", "For tests.", "Under development")
REGISTER_ACTUATOR(CMisbehavingActuator, "test_misbehaving", "default",
                  "the authors of this project", "1.0", "For tests.", "For tests.",
                  "Under development")
REGISTER_MEDIUM(CMisbehavingMedium, "test_misbehaving_medium", "the authors of this project", "1.0",
                "For tests.", "For tests.", "Under development")
REGISTER_LOOP_FUNCTIONS(CMisbehavingLoop, "test_misbehaving_loop")
