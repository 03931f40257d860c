#ifndef ARGOS3_CORE_SIMULATOR_ENTITY_ENTITY_TYPE_H
#define ARGOS3_CORE_SIMULATOR_ENTITY_ENTITY_TYPE_H

#include <argos3/core/utility/configuration/argos_configuration.h>
#include <argos3/core/utility/plugins/factory.h>

#include <memory>

namespace argos {

class CEntity;

/**
 * A type of entities that an experiment file describes: a child of `<robot_types>`, whose `id` is
 * the tag of such entities in the arena. Outlives its entities.
 */
class CEntityType {
 public:
  virtual ~CEntityType() = default;

  /** Reads the description. @throws CARGoSException with file and line if it is wrong. */
  virtual void Init(TConfigurationNode& tree) = 0;
  /** Creates an entity, which is to be initialised with its own element. */
  virtual std::unique_ptr<CEntity> New() const = 0;
};

}  // namespace argos

/** Registers a class of types; LABEL is the tag of the child of `<robot_types>`. */
#define REGISTER_ENTITY_TYPE(CLASSNAME, LABEL, AUTHOR, VERSION, BRIEF_DESCRIPTION,   \
                             LONG_DESCRIPTION, STATUS)                               \
  REGISTER_SYMBOL(CEntityType, CLASSNAME, LABEL, AUTHOR, VERSION, BRIEF_DESCRIPTION, \
                  LONG_DESCRIPTION, STATUS)

#endif
