#ifndef ARGOS3_CORE_SIMULATOR_TICK_LOOP_FUNCTIONS_H
#define ARGOS3_CORE_SIMULATOR_TICK_LOOP_FUNCTIONS_H

#include <argos3/core/simulator/entity/controllable_entity.h>
#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/simulator/entity/floor_painter.h>
#include <argos3/core/simulator/entity/positional_entity.h>
#include <argos3/core/simulator/space/space.h>
#include <argos3/core/utility/configuration/argos_configuration.h>
#include <argos3/core/utility/configuration/base_configurable_resource.h>
#include <argos3/core/utility/datatypes/color.h>
#include <argos3/core/utility/logging/argos_log.h>
#include <argos3/core/utility/math/angles.h>
#include <argos3/core/utility/math/general.h>
#include <argos3/core/utility/math/quaternion.h>
#include <argos3/core/utility/math/range.h>
#include <argos3/core/utility/math/ray2.h>
#include <argos3/core/utility/math/ray3.h>
#include <argos3/core/utility/math/rng.h>
#include <argos3/core/utility/math/vector2.h>
#include <argos3/core/utility/math/vector3.h>
#include <argos3/core/utility/plugins/factory.h>

// included for users of this header
#include <algorithm>
#include <cmath>
#include <cstring>
#include <fstream>
#include <functional>

namespace argos {

class CDrawing;
class CSimulator;

/**
 * Base class of users' loop functions: hooks that may read and change everything between the phases
 * of a tick.
 *
 * Hooks run alone, on the main thread. Created before engines and entities (the constructor can
 * access the space only); Init() runs when the arena is complete.
 */
class CLoopFunctions : public CBaseConfigurableResource, public CFloorPainter {
 public:
  CLoopFunctions();
  ~CLoopFunctions() override = default;

  /** Called once, when the arena is complete; the node is the element <loop_functions>. */
  void Init(TConfigurationNode&) override {}
  /** Called when the experiment is reset: restores the state that Init() left. */
  void Reset() override {}
  /** Called once, at the end, also after an error. */
  void Destroy() override {}

  /** After physics and media, before sensing. */
  virtual void PreStep() {}
  /** At the end of the tick. */
  virtual void PostStep() {}
  /** Called before each tick. @return true to end the run; its length ends it in any case. */
  virtual bool IsExperimentFinished() { return false; }
  /** Called once, after the last tick. */
  virtual void PostExperiment() {}
  /** Colour of the floor with `<floor source="loop_functions">`; @p positionOnFloor in m. */
  CColor GetFloorColor(const CVector2& positionOnFloor) override;

  /** Adds shapes to each picture that a view draws; must not change the experiment. */
  virtual void DrawInWorld(CDrawing&) {}
  /** The same, over the picture, in pixels, see CDrawing::SetOverlay(). */
  virtual void DrawInOverlay(CDrawing&) {}

  /**
   * Sets a metric of the run, which <metrics file="..."/> and `--csv` write once a tick; see
   * CMetrics::Set(). In hooks only; GetSimulator().GetMetrics().Record() is for robots, too. The
   * table has a column for each metric that was set before its second row is written; one that is
   * set for the first time later is left out, with a warning.
   * @throws CARGoSException if the name or the unit is wrong.
   */
  void SetMetric(const std::string& name, Real value, const std::string& unit = "");

  CSimulator& GetSimulator() { return m_cSimulator; }
  CSpace& GetSpace() { return m_cSpace; }
  const CSpace& GetSpace() const { return m_cSpace; }

  virtual void MoveEntity(CPositionalEntity& entity, const CVector3& position,
                          const CQuaternion& orientation);
  /** See CEmbodiedEntity::MoveTo(), also for the result. */
  virtual bool MoveEntity(CEmbodiedEntity& entity, const CVector3& position,
                          const CQuaternion& orientation, bool checkOnly = false,
                          bool ignoreCollisions = false);
  /**
   * Adds a root entity allocated with new; the space takes ownership, and deletes it if it cannot
   * be added. A body keeps its pose, without a check for collisions.
   *
   * In hooks at once. In code of robots, engines and media, such as ControlStep(), at the end of
   * the tick, in the order of the robots that request it; a new robot gets its controller then.
   * @throws CARGoSException if the id is taken, or if no physics engine accepts the body.
   */
  virtual void AddEntity(CEntity& entity);
  /**
   * Removes and deletes a root entity: in hooks at once, otherwise at the end of the tick, as
   * AddEntity().
   * @throws CARGoSException if the id is unknown; if a robot removes the same entity twice in a
   *   tick.
   */
  virtual void RemoveEntity(const std::string& id);
  virtual void RemoveEntity(CEntity& entity);

  /**
   * Calls the callback for each robot, possibly on several threads at once. What it adds and
   * removes is added and removed when all calls have returned. Not to be called by robots.
   */
  void IterateOverControllableEntities(const CSpace::TControllableEntityIterCBType& callback) const;

 private:
  CSimulator& m_cSimulator;
  CSpace& m_cSpace;
};

}  // namespace argos

#define REGISTER_LOOP_FUNCTIONS(CLASSNAME, LABEL)                                          \
  REGISTER_SYMBOL(CLoopFunctions, CLASSNAME, LABEL, "undefined", "undefined", "undefined", \
                  "undefined", "undefined")

#endif
