#ifndef ARGOS3_CORE_SIMULATOR_ENTITY_ENTITY_OPERATION_H
#define ARGOS3_CORE_SIMULATOR_ENTITY_ENTITY_OPERATION_H

#include <argos3/core/utility/plugins/vtable.h>

namespace argos {

class CEntity;

/**
 * Base of an operation of a module (PLUGIN) on one concrete entity class.
 *
 * The cooperative visitor: every entity class has an integer tag, every kind of operation (LABEL) a
 * flat table indexed by tag. The hook casts statically; there is no dynamic_cast on the way.
 */
template <typename LABEL, typename PLUGIN, typename RETURN_TYPE>
class CEntityOperation {
 public:
  virtual ~CEntityOperation() = default;

  template <typename DERIVED, typename OPERATION_IMPL>
  RETURN_TYPE Hook(PLUGIN& plugin, CEntity& entity) {
    return static_cast<OPERATION_IMPL&>(*this).ApplyTo(plugin, static_cast<DERIVED&>(entity));
  }
};

/** Result of operations of physics engines: whether they did something. */
struct SOperationOutcome {
  bool Value;

  SOperationOutcome() : Value(false) {}
  SOperationOutcome(bool value) : Value(value) {}
  bool operator()() const { return Value; }
};

/** An operation instance bound to an entity class; entry of the table. */
template <typename LABEL, typename PLUGIN, typename RETURN_TYPE>
class CEntityOperationInstanceHolder {
 public:
  virtual ~CEntityOperationInstanceHolder() = default;
  virtual RETURN_TYPE Call(PLUGIN& plugin, CEntity& entity) = 0;
};

template <typename LABEL, typename PLUGIN, typename RETURN_TYPE, typename DERIVED,
          typename OPERATION_IMPL>
class CBoundEntityOperation final
    : public CEntityOperationInstanceHolder<LABEL, PLUGIN, RETURN_TYPE> {
 public:
  RETURN_TYPE Call(PLUGIN& plugin, CEntity& entity) override {
    return m_operation.template Hook<DERIVED, OPERATION_IMPL>(plugin, entity);
  }

 private:
  OPERATION_IMPL m_operation;
};

/** Calls the operation registered for exactly the entity's class; without one: RETURN_VALUE(). */
template <typename LABEL, typename PLUGIN, typename RETURN_VALUE>
RETURN_VALUE CallEntityOperation(PLUGIN& plugin, CEntity& entity);

}  // namespace argos

#define REGISTER_ENTITY_OPERATION(LABEL, PLUGIN, OPERATION, RETURN_VALUE, DERIVED)                \
  class C##OPERATION##DERIVED##Registrar {                                                        \
   public:                                                                                        \
    C##OPERATION##DERIVED##Registrar() {                                                          \
      static argos::CBoundEntityOperation<LABEL, PLUGIN, RETURN_VALUE, DERIVED, OPERATION> bound; \
      argos::GetVTable<LABEL, argos::CEntity,                                                     \
                       argos::CEntityOperationInstanceHolder<LABEL, PLUGIN, RETURN_VALUE>*>()     \
          .template Add<DERIVED>(&bound);                                                         \
    }                                                                                             \
  } C##OPERATION##DERIVED##RegistrarInstance;

#endif
