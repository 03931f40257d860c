#ifndef ARGOS3_PLUGINS_MEDIA_LED_MEDIUM_H
#define ARGOS3_PLUGINS_MEDIA_LED_MEDIUM_H

#include <argos3/plugins/simulator/entities/led_entity.h>
#include <argos3/plugins/simulator/media/positional_medium.h>

namespace argos {

/** Medium of LEDs and lights; its index contains those that were lit at the last Update(). */
class CLEDMedium
    : public CPositionalMedium<CLEDEntity, CLEDEntityGridUpdater, CLEDEntitySpaceHashUpdater> {
 public:
  bool CanBePeriodic() const override { return true; }
  CLEDMedium& AsMedium() override { return *this; }
};

}  // namespace argos

#endif
