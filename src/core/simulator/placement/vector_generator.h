#ifndef ARGOS3_CORE_SIMULATOR_PLACEMENT_VECTOR_GENERATOR_H
#define ARGOS3_CORE_SIMULATOR_PLACEMENT_VECTOR_GENERATOR_H

#include <argos3/core/utility/configuration/argos_configuration.h>
#include <argos3/core/utility/math/rng.h>
#include <argos3/core/utility/math/vector3.h>

#include <memory>
#include <string>

namespace argos {

/** Gives the positions, or the Euler angles, of distributed entities one after the other. */
class CVectorGenerator {
 public:
  virtual ~CVectorGenerator() = default;
  /** The next triple. @param failed  true if the last one was rejected. */
  virtual CVector3 Next(bool failed) = 0;
  /** @return false if every call gives the same triple, so that a second trial is useless. */
  virtual bool CanRetry() const { return true; }
  /** @return true if all triples are within two corners, which are then set. */
  virtual bool GetExtent(CVector3& min, CVector3& max) const = 0;
  /** @throws CARGoSException if there are fewer than @p quantity triples. */
  virtual void RequireCapacity(UInt64 quantity) const { (void)quantity; }
  /** For messages: "drawn uniformly from (...) to (...)". */
  virtual std::string Describe() const = 0;
};

/**
 * Makes the generator of a `<position>` or `<orientation>` element.
 * @param node  the element. Its `method` is uniform (min, max), gaussian (mean, std_dev), constant
 *              (values) or grid (center, distances, layout).
 * @param rng   draws random triples; must outlive the generator.
 * @throws CARGoSException if the method is unknown or a parameter missing or out of range.
 */
std::unique_ptr<CVectorGenerator> CreateVectorGenerator(TConfigurationNode& node,
                                                        CRandom::CRNG& rng);

}  // namespace argos

#endif
