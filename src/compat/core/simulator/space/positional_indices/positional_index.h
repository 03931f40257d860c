#ifndef ARGOS3_COMPAT_CORE_SIMULATOR_SPACE_POSITIONAL_INDICES_POSITIONAL_INDEX_H
#define ARGOS3_COMPAT_CORE_SIMULATOR_SPACE_POSITIONAL_INDICES_POSITIONAL_INDEX_H

#include <argos3/core/simulator/entity/entity.h>
#include <argos3/core/utility/configuration/base_configurable_resource.h>
#include <argos3/core/utility/datatypes/set.h>
#include <argos3/core/utility/math/ray3.h>
#include <argos3/core/utility/math/vector2.h>
#include <argos3/core/utility/math/vector3.h>

namespace argos {

/**
 * Finds the entities near a place, for media.
 *
 * Results are as of the last Update() and conservative: an entity in range is always visited,
 * others may be, and one may be visited twice. Operations check distances themselves. The order of
 * visits depends on positions and on the order of additions only.
 *
 * Queries may run on several threads at once; no other function may.
 */
template <class ENTITY>
class CPositionalIndex : public CBaseConfigurableResource {
 public:
  /** The operation that a query calls for each entity. */
  class COperation {
   public:
    virtual ~COperation() = default;
    /** @return false to end the query. */
    virtual bool operator()(ENTITY& entity) = 0;
  };

  ~CPositionalIndex() override = default;

  void Init(TConfigurationNode&) override {}
  void Reset() override {}
  void Destroy() override {}

  /** Queries find the entity from the next Update() on. Adding it again changes nothing. */
  virtual void AddEntity(ENTITY& entity) = 0;
  /** Takes effect at once. Does nothing if the entity is not in the index. */
  virtual void RemoveEntity(ENTITY& entity) = 0;
  /** Reads the current positions of the entities. */
  virtual void Update() = 0;

  /** Replaces the content of @p entities by those in the cell of @p position (m). */
  virtual void GetEntitiesAt(CSet<ENTITY*, SEntityComparator>& entities,
                             const CVector3& position) const = 0;
  /** In order of addition, also of entities added since Update(). */
  virtual void ForAllEntities(COperation& operation) = 0;
  /** Lengths in m. */
  virtual void ForEntitiesInBoxRange(const CVector3& center, const CVector3& halfSize,
                                     COperation& operation) = 0;
  /** Visits the entities in the box around the sphere, unless overridden. */
  virtual void ForEntitiesInSphereRange(const CVector3& center, Real radius,
                                        COperation& operation) {
    ForEntitiesInBoxRange(center, CVector3(radius, radius, radius), operation);
  }
  /** The disc is horizontal, at the height of its centre. Visits the box around it. */
  virtual void ForEntitiesInCircleRange(const CVector3& center, Real radius,
                                        COperation& operation) {
    ForEntitiesInBoxRange(center, CVector3(radius, radius, 0.0), operation);
  }
  /** The rectangle is horizontal, at the height of its centre, with sides along x and y. */
  virtual void ForEntitiesInRectangleRange(const CVector3& center, const CVector2& halfSize,
                                           COperation& operation) {
    ForEntitiesInBoxRange(center, CVector3(halfSize.GetX(), halfSize.GetY(), 0.0), operation);
  }
  /**
   * Cell by cell from the start of the ray to its end.
   * @param stopAtClosestMatch  if true, an operation that returns false ends the query only after
   *        the other entities of that cell: the nearest match is then among those it has seen.
   */
  virtual void ForEntitiesAlongRay(const CRay3& ray, COperation& operation,
                                   bool stopAtClosestMatch = false) = 0;
};

}  // namespace argos

#endif
