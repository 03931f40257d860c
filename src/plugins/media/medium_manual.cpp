#include <argos3/plugins/simulator/media/medium_manual.h>

namespace argos {

namespace {

std::string InMedia(const std::string& heading, const std::string& medium) {
  return "\n" + heading + "\n\n  <media>\n    " + medium + "\n  </media>\n";
}

}  // namespace

std::string RequiredMediumXML(const std::string& medium) {
  return InMedia("REQUIRED XML", medium);
}

std::string OptionalMediumXML(const std::string& medium) {
  return InMedia("OPTIONAL XML", medium);
}

std::string IndexMediumManual(const std::string& tag, const std::string& id,
                              const std::string& members) {
  const std::string start = "<" + tag + " id=\"" + id + "\"";
  return RequiredMediumXML(start + " />") + R"(
ATTRIBUTES

  id         text, required: unique among the media.
  index      "grid" (default) or "hash": spatial index of the )" +
         members + R"(. It has no effect on results;
             "hash" takes less memory for few )" +
         members + R"( in a large arena.
  grid_size  "x,y,z", integers >= 1: number of grid cells along each axis; default
             one cell for each whole metre. It has no effect on results.
)" + InMedia("For example:", start + R"( index="grid" grid_size="20,20,1" />)");
}

}  // namespace argos
