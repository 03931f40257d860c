#ifndef ARGOS3_PLUGINS_MEDIA_DIRECTIONAL_LED_MEDIUM_H
#define ARGOS3_PLUGINS_MEDIA_DIRECTIONAL_LED_MEDIUM_H

#include <argos3/plugins/simulator/entities/directional_led_entity.h>
#include <argos3/plugins/simulator/media/positional_medium.h>

namespace argos {

/** Medium of directional LEDs; its index contains those that were lit at the last Update(). */
class CDirectionalLEDMedium
    : public CPositionalMedium<CDirectionalLEDEntity, CDirectionalLEDEntityGridUpdater,
                               CDirectionalLEDEntitySpaceHashUpdater> {
 public:
  bool CanBePeriodic() const override { return true; }
  CDirectionalLEDMedium& AsMedium() override { return *this; }
};

}  // namespace argos

#endif
