#include <argos3/core/simulator/context/simulation_context.h>
#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/simulator/physics_engine/physics_engine.h>
#include <argos3/core/simulator/simulator.h>
#include <argos3/core/simulator/space/space.h>
#include <argos3/core/simulator/visualization/overlay.h>
#include <argos3/core/utility/errors/argos_exception.h>
#include <argos3/plugins/simulator/entities/value_checks.h>
#include <argos3/plugins/simulator/visualizations/overlays/color_rule.h>
#include <argos3/plugins/simulator/visualizations/overlays/overlay_attributes.h>
#include <argos3/plugins/simulator/visualizations/overlays/robots_in_view.h>

#include <cmath>
#include <deque>
#include <string>
#include <unordered_map>

namespace argos {

/** Draws the paths that robots have taken. */
class CTrailsOverlay : public COverlay {
 public:
  void Init(TConfigurationNode& tree) override;
  void Reset() override { m_trails.clear(); }
  void Observe(CSimulator& simulator) override;
  void Draw(CSimulator& simulator, CDrawing& drawing) override;

 private:
  struct SPoint {
    CVector3 Position;  // m
    UInt32 Tick;
    bool IsStart;  // there is no line from the point before
  };
  struct STrail {
    std::deque<SPoint> Points;
    CColor Color;
    UInt32 LastSeen = 0;  // tick
  };

  void Append(STrail& trail, const CVector3& position, const SPeriodicity& period,
              UInt32 tick) const;
  void DrawTrail(const STrail& trail, UInt32 tick, CDrawing& drawing) const;
  CColor ComputeColor(const STrail& trail, UInt32 age) const;

  CRobotsInView m_robots;
  std::unordered_map<std::string, STrail> m_trails;  // keys are the ids of robots
  Real m_duration = 0.0;  // s; 0: all of the run
  UInt32 m_ticks = 0;  // length of the duration
  Real m_width = 2.0;  // pixels
  Real m_step = 0.005;  // m, between points
  bool m_fades = true;
  CColorRule m_color;
};

void CTrailsOverlay::Init(TConfigurationNode& tree) {
  m_robots.Init(tree);
  ReadLineWidth(tree, m_width);
  m_color.Init(tree);
  GetNodeAttributeOrDefault(tree, "fade", m_fades, m_fades);
  GetNodeAttributeOrDefault(tree, "duration", m_duration, m_duration);
  RequireNotNegative(m_duration, OwnerOf(tree), "attribute \"duration\" (s)");
  const Real ticks = std::ceil(m_duration / CPhysicsEngine::GetSimulationClockTick());
  if (ticks > 4e9) {
    THROW_ARGOSEXCEPTION(OwnerOf(tree) << ": attribute \"duration\" (s) must be 0, for the whole "
                                          "run, or less than 4e9 ticks, got "
                                       << m_duration);
  }
  m_ticks = static_cast<UInt32>(ticks);
}

void CTrailsOverlay::Append(STrail& trail, const CVector3& position, const SPeriodicity& period,
                            UInt32 tick) const {
  // a robot that moves farther in a tick was placed there
  constexpr Real kJump = 0.5;  // m
  std::deque<SPoint>& points = trail.Points;
  while (m_ticks > 0 && !points.empty() && tick - points.front().Tick > m_ticks) {
    points.pop_front();
  }
  const bool hasMissed = points.empty() || trail.LastSeen + 1 < tick;
  const CVector3 way = points.empty() ? CVector3() : position - points.back().Position;
  const Real distance = way.Length();
  // it has left through a side of a periodic arena
  const bool hasCrossed = period.Shorten(way) != way;
  if (hasMissed || distance > kJump || hasCrossed) {
    points.push_back({position, tick, true});
  } else if (distance >= m_step) {
    points.push_back({position, tick, false});
  }
}

void CTrailsOverlay::Observe(CSimulator& simulator) {
  CSpace& space = simulator.GetSpace();
  const UInt32 tick = space.GetSimulationClock();
  for (const CRobotsInView::SRobot& robot : m_robots.List(space)) {
    STrail& trail = m_trails[robot.Root->GetId()];
    trail.Color = m_color.Choose(*robot.Root);
    Append(trail, robot.Pose.Position, space.GetContext().Arena.Period, tick);
    trail.LastSeen = tick;
  }
  // trails of removed robots
  std::erase_if(m_trails, [tick](const auto& entry) { return entry.second.LastSeen != tick; });
}

CColor CTrailsOverlay::ComputeColor(const STrail& trail, UInt32 age) const {
  CColor color = trail.Color;
  if (m_fades) {
    const UInt32 whole = m_ticks > 0 ? m_ticks : trail.LastSeen + 1;
    const Real share = 1.0 - static_cast<Real>(age) / whole;
    color.SetAlpha(static_cast<UInt8>(std::lround(color.GetAlpha() * std::max(0.0, share))));
  }
  return color;
}

void CTrailsOverlay::DrawTrail(const STrail& trail, UInt32 tick, CDrawing& drawing) const {
  const std::deque<SPoint>& points = trail.Points;
  for (size_t i = 1; i < points.size(); ++i) {
    if (!points[i].IsStart) {
      ARGOS_ASSERT(i > 0, "the first point of a trail has no line");
      drawing.DrawLine(points[i - 1].Position, points[i].Position,
                       ComputeColor(trail, tick - points[i].Tick), m_width);
    }
  }
}

void CTrailsOverlay::Draw(CSimulator& simulator, CDrawing& drawing) {
  CSpace& space = simulator.GetSpace();
  // drawn in the order of the robots, not of the map
  for (const CRobotsInView::SRobot& robot : m_robots.List(space)) {
    const auto found = m_trails.find(robot.Root->GetId());
    if (found == m_trails.end()) {
      continue;
    }
    ARGOS_ASSERT(!found->second.Points.empty(), "a trail has a point for its robot's place");
    DrawTrail(found->second, space.GetSimulationClock(), drawing);
    const CVector3& last = found->second.Points.back().Position;
    drawing.DrawLine(last, robot.Pose.Position, ComputeColor(found->second, 0), m_width);
  }
}

REGISTER_OVERLAY(CTrailsOverlay, "trails", "the authors of this project", "1.0",
                 "Draws the paths that robots have taken.",
                 OverlayXML("<trails />",
                            R"( A path has a point wherever its robot has moved by 5 mm
since the last one, and is interrupted where a robot was placed elsewhere.)") +
                     R"(  <trails of="foot-bot" duration="10" fade="true" width="2" color="blue" />
  <trails color_by="battery" min="0" max="1" />

  of        types of robots, separated by commas: "foot-bot,e-puck". Default: all robots.
  duration  s, >= 0: the last part of the path that is drawn; default 0: all of it.
  fade      bool, default true: the older, the more transparent.
  width     pixels, > 0, default 2.
  color     of all trails; by default each robot has one of seven colours that can be told apart.
  color_by  in place of color: robot, type, team (the robot's controller), led (its brightest one), or a field of tables, such
            as value:food or battery.
  min       real number, default 0: value of the field that is dark blue.
  max       real number, default 1: value of the field that is yellow.
)",
                 "Usable")

}  // namespace argos
