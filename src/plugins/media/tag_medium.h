#ifndef ARGOS3_PLUGINS_MEDIA_TAG_MEDIUM_H
#define ARGOS3_PLUGINS_MEDIA_TAG_MEDIUM_H

#include <argos3/plugins/simulator/entities/tag_entity.h>
#include <argos3/plugins/simulator/media/positional_medium.h>

namespace argos {

/** Medium of the tags that cameras read. */
class CTagMedium
    : public CPositionalMedium<CTagEntity, CTagEntityGridUpdater, CTagEntitySpaceHashUpdater> {
 public:
  bool CanBePeriodic() const override { return true; }
  CTagMedium& AsMedium() override { return *this; }
};

}  // namespace argos

#endif
