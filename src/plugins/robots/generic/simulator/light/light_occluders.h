#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_LIGHT_LIGHT_OCCLUDERS_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_LIGHT_LIGHT_OCCLUDERS_H

#include <argos3/core/simulator/geometry/indexed_shape.h>
#include <argos3/core/utility/datatypes/datatypes.h>
#include <argos3/core/utility/math/ray3.h>

#include <vector>

namespace argos {

class CBodyIndex;
struct SLightEyes;

/**
 * Finds which lights other bodies occlude for the light sensors of a robot.
 *
 * The parts of the lines to lights that are near the robot share one query of the index; what is
 * beyond is searched for one light at a time, as long as a sensor still sees it. Results are equal
 * to the bit to those of CBodyIndex::Intersect() for each sensor, light and solid. Keeps its memory
 * allocated between uses.
 */
class CLightOccluders {
 public:
  CLightOccluders();

  /**
   * Searches the solids near the robot.
   * @param index    must exist until the last call of Occlude(), as must be the sensors' place.
   * @param ownBody  number of the body of the sensors, which occludes nothing.
   * @param lines    from the centre of the sensors to the lights, m, world frame.
   */
  void Find(const CBodyIndex& index, UInt32 ownBody, const SLightEyes& eyes,
            const std::vector<CRay3>& lines);
  /** Marks sensors as not clear for which solids occlude the light of the last LookAt(). */
  void Occlude(SLightEyes& eyes);

 private:
  struct SBeam;
  // Bounds of solids, one array for each number, so that the compiler vectorizes loops over them.
  struct SBlock {
    static constexpr size_t kSize = 16;

    Real X[kSize], Y[kSize], Radius[kSize], ZMin[kSize], ZMax[kSize];  // of SIndexedShape

    // the numbers of the solids that are not beside the beam, above it or below it, as bits
    UInt64 FindNear(const SBeam& beam) const;
  };
  struct SSolids {
    std::vector<SIndexedShape> Shapes;
    std::vector<SBlock> Blocks;  // of the shapes

    SSolids();
    void Clear();
    void Add(const SIndexedShape& shape);
  };

  bool OccludeBehind(const SIndexedShape& shape, SLightEyes& eyes) const;
  bool OccludeBehind(const SSolids& solids, const SBeam& beam, SLightEyes& eyes) const;
  void OccludeBeyond(const CRay3& line, const SBeam& beam, SLightEyes& eyes);

  const CBodyIndex* m_index = nullptr;
  UInt32 m_ownBody = 0;
  std::vector<CRay3> m_nearLines;  // m; parts of the lines to lights
  SSolids m_near, m_beyond;
};

}  // namespace argos

#endif
