#ifndef ARGOS3_PLUGINS_VISUALIZATIONS_DRAWING_DRAWING_FUNCTIONS_H
#define ARGOS3_PLUGINS_VISUALIZATIONS_DRAWING_DRAWING_FUNCTIONS_H

#include <argos3/core/simulator/entity/entity.h>
#include <argos3/core/simulator/geometry/body_pose.h>
#include <argos3/core/simulator/visualization/drawing.h>
#include <argos3/core/utility/configuration/base_configurable_resource.h>
#include <argos3/core/utility/plugins/factory.h>

#include <functional>
#include <string>
#include <vector>

namespace argos {

/** A key that the user of an interactive view presses or releases. */
struct SViewKey {
  std::string Name; /**< as browsers name it: the character, or "ArrowUp", "Enter", ... */
  bool IsDown = true;
  // keys that are down with it, this one included
  bool HasShift = false;
  bool HasControl = false;
  bool HasAlt = false;
  bool HasMeta = false;
};

/**
 * Base class of users' code that adds to the pictures of any view: `<user_functions library="..."
 * label="..." />` in the view's element.
 *
 * Hooks run alone, on the main thread, between ticks, once for each picture: first those of
 * entities, in the order of insertion into the space, then DrawInWorld(), then DrawInOverlay().
 * They may read everything, and must not change the experiment: a run without pictures does not
 * call them.
 */
class CDrawingFunctions : public CBaseConfigurableResource {
 public:
  CDrawingFunctions();
  ~CDrawingFunctions() override;

  /** @param tree the element `<user_functions>`. */
  void Init(TConfigurationNode&) override {}
  /** The experiment was reset. */
  void Reset() override {}
  void Destroy() override {}

  /** Draws in the world frame, after all entities. */
  virtual void DrawInWorld() {}
  /** Draws over the picture, in pixels. */
  virtual void DrawInOverlay() {}
  /** Calls the function that is registered for exactly the class of @p entity, if there is one. */
  virtual void Call(CEntity& entity);

  /**
   * What the user of an interactive view does, such as <live>: called between ticks, and may change
   * the experiment.
   * @param root  root entity that was selected; null: none is.
   */
  virtual void HandleSelection(CEntity* /*root*/) {}
  /** The selected entity was removed, by whatever: it must not be used any more. */
  virtual void ForgetSelection() {}
  virtual void HandleMove(CEntity& /*root*/, const SBodyPose& /*before*/,
                          const SBodyPose& /*now*/) {}
  /** @return true if these functions have used the key: the view does nothing with it then. */
  virtual bool HandleKey(const SViewKey& /*key*/) { return false; }

  /**
   * The list that a hook draws to.
   * @throws CARGoSException outside of hooks.
   */
  CDrawing& GetDrawing();
  /** The list of the hook that runs on this thread, whatever its functions; null outside of hooks.
   */
  static CDrawing* GetCurrentDrawing();
  /** The number of hooks that have begun on this thread: another number is another hook. */
  static UInt64 GetNumHooks();

  /**
   * Draws everything to a list.
   * @param roots  root entities of the space.
   */
  void DrawAll(CDrawing& drawing, const CEntity::TVector& roots);

  /**
   * Registers a hook for root entities of exactly the class ENTITY; a later one of the same class
   * replaces it. It draws in the entity's frame: that of its origin anchor, or of its position; the
   * world frame for an entity without either. Call it in the constructor.
   */
  template <typename USER_IMPL, typename ENTITY>
  void RegisterUserFunction(void (USER_IMPL::*function)(ENTITY&)) {
    Register(::argos::GetTag<ENTITY, CEntity>(), [this, function](CEntity& entity) {
      (static_cast<USER_IMPL&>(*this).*function)(static_cast<ENTITY&>(entity));
    });
  }

 private:
  typedef std::function<void(CEntity&)> TFunction;

  void Register(size_t tag, TFunction function);
  bool HasFunctionFor(CEntity& entity) const;

  std::vector<TFunction> m_functions;  // index: tag of the class of entities; may be empty
  CDrawing* m_drawing = nullptr;  // null outside of hooks
};

}  // namespace argos

#define REGISTER_DRAWING_FUNCTIONS(CLASSNAME, LABEL)                                          \
  REGISTER_SYMBOL(CDrawingFunctions, CLASSNAME, LABEL, "undefined", "undefined", "undefined", \
                  "undefined", "undefined")

#endif
