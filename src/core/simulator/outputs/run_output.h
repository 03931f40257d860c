#ifndef ARGOS3_CORE_SIMULATOR_OUTPUTS_RUN_OUTPUT_H
#define ARGOS3_CORE_SIMULATOR_OUTPUTS_RUN_OUTPUT_H

#include <argos3/core/utility/configuration/base_configurable_resource.h>
#include <argos3/core/utility/plugins/factory.h>

namespace argos {

class CSimulator;

/**
 * Something that a run leaves, such as frames, a recording or a table: a child of `<outputs>` or of
 * `<visualization>`, whose tag is the label of the class.
 *
 * Any number of outputs may watch a run. They read the space between ticks, on the thread that
 * steps the simulator, and change nothing in it: a run without them is the same.
 */
class CRunOutput : public CBaseConfigurableResource {
 public:
  /**
   * Called after the rest of the experiment was initialised. Checks what can be checked, and
   * creates and changes no file in a CLoadingCheck.
   * @param tree its element. @throws CARGoSException if a value is wrong.
   */
  void Init(TConfigurationNode&) override {}
  /** The experiment was reset: the next call of Observe() shows the first state again. */
  void Reset() override {}
  /** Also after errors: closes files, so that what was written stays readable. */
  void Destroy() override {}

  /**
   * Takes what it needs of the present state: called before the first tick and after each one,
   * when its PostStep() is done.
   * @throws CARGoSException ends the run.
   */
  virtual void Observe(CSimulator& simulator) = 0;
  /**
   * The run has ended, and the state is still there: at the end of CSimulator::Execute(), and for
   * a program that calls UpdateSpace() itself, in Reset() and Destroy(). Called once per run, but
   * not after an error.
   */
  virtual void Finish(CSimulator&) {}
};

}  // namespace argos

#define REGISTER_RUN_OUTPUT(CLASSNAME, LABEL, AUTHOR, VERSION, BRIEF_DESCRIPTION,   \
                            LONG_DESCRIPTION, STATUS)                               \
  REGISTER_SYMBOL(CRunOutput, CLASSNAME, LABEL, AUTHOR, VERSION, BRIEF_DESCRIPTION, \
                  LONG_DESCRIPTION, STATUS)

#endif
