#ifndef ARGOS3_PLUGINS_ENTITIES_LIGHTS_H
#define ARGOS3_PLUGINS_ENTITIES_LIGHTS_H

#include <argos3/core/simulator/space/space.h>

#include <vector>

namespace argos {

class CLightEntity;

/** The lights of a space, for light sensors: space.GetExtension<CLights>(). */
class CLights : public CSpaceExtension {
 public:
  /** All lights, in the order of addition. */
  const std::vector<CLightEntity*>& Get() const { return m_lights; }

  /** Space operations of lights only. */
  void Add(CLightEntity& light);
  /** Does nothing if the light is unknown. */
  void Remove(CLightEntity& light);

 private:
  std::vector<CLightEntity*> m_lights;  // are not owned
};

}  // namespace argos

#endif
