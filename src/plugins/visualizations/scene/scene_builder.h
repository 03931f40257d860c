#ifndef ARGOS3_PLUGINS_VISUALIZATIONS_SCENE_SCENE_BUILDER_H
#define ARGOS3_PLUGINS_VISUALIZATIONS_SCENE_SCENE_BUILDER_H

#include <argos3/plugins/simulator/visualizations/scene/floor_image.h>
#include <argos3/plugins/simulator/visualizations/scene/scene_parts.h>

#include <cstddef>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace argos {

class CComposableEntity;
class CControllableEntity;
class CDirectionalLEDEquippedEntity;
class CEmbodiedEntity;
class CEntity;
class CLEDEquippedEntity;
class CLightEntity;
class CSpace;
struct SAppearance;
struct SVisualPart;

/**
 * Converts the contents of the arena to a scene.
 *
 * It reads only descriptions that every entity provides (SAppearance, poses, places and colours of
 * LEDs, rays recorded by sensors), and depends on no robot. It resets the floor's mark that it has
 * changed; apart from that it changes nothing in the space, and creates no entity.
 */
class CSceneBuilder {
 public:
  /** @param showRays  true: draw the rays that sensors record because of their show_rays attribute
   */
  explicit CSceneBuilder(bool showRays) : m_showRays(showRays) {}

  /**
   * Numbers of a renderer's models for a type of entities, each with the anchor whose solids it
   * replaces; empty: none.
   */
  typedef std::vector<std::pair<std::string, std::size_t>> TModels;
  typedef std::function<const TModels&(const std::string& type)> TFindModels;

  /**
   * Draws an entity that has no appearance, in the world frame.
   * @return false if it cannot: its solids are shown.
   */
  typedef std::function<bool(CEntity& entity, CDrawing& drawing)> TDrawEntity;
  /** Of all scenes of the process; called when a library is loaded. */
  static void SetDrawEntity(const TDrawEntity& draw);

  /** Entities whose type has models appear as such instead of as solids. */
  void SetModels(const TFindModels& find) { m_findModels = find; }

  /**
   * Refills @p scene; its settings (ShowGrid, ShowBoundary) and its memory are kept. Warns once of
   * each type of entities that have no appearance.
   */
  void Build(CSpace& space, SScene& scene);

 private:
  // a root entity while it is converted to a part of the scene
  struct SSubject {
    SPose Pose;
    CEmbodiedEntity* Body = nullptr;  // null: the entity has none
    CLEDEquippedEntity* LEDs = nullptr;  // null: the entity has none, or they are dark
    // a robot without LEDs of the other kind shows their colours; null likewise
    const CDirectionalLEDEquippedEntity* DirectionalLEDs = nullptr;
    const CLightEntity* Light = nullptr;  // its solids glow while its intensity is above 0
    const TModels* Models = nullptr;  // null: it has solids only
    bool IsDrawn = false;  // its class draws it in place of its solids
    bool IsRobot = false;
    bool IsQuarantined = false;  // a robot that errors have stopped (CSpace::QuarantineLater())
    double LargestVolume = 0.0;  // largest box around a part, m^3
    Eigen::Vector3d LargestSize = Eigen::Vector3d::Zero();  // size of that part, m
    double FootprintArea = 0.0;  // area of ContactShadow, m^2; 0: nothing touches the ground
    SContactShadow ContactShadow{};
  };

  void AddEntity(CEntity& entity, SScene& scene);
  void WarnUnseen(const CEntity& entity);
  void WarnOfSolids(const CEntity& entity);
  void AddPart(const SVisualPart& part, SSubject& subject, SScene& scene) const;

  static bool HasModel(const SSubject& subject, const std::string& anchor);
  void AddModels(CEntity& entity, SSubject& subject, SScene& scene) const;

  bool m_showRays;
  TFindModels m_findModels;  // may be empty
  CFloorImage m_floor;
  CDrawing m_drawing;  // shapes of entities that their classes draw
  std::set<std::string> m_unseenTypes;  // types that were reported
};

}  // namespace argos

#endif
