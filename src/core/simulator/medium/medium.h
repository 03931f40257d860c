#ifndef ARGOS3_CORE_SIMULATOR_MEDIUM_MEDIUM_H
#define ARGOS3_CORE_SIMULATOR_MEDIUM_MEDIUM_H

#include <argos3/core/utility/configuration/base_configurable_resource.h>
#include <argos3/core/utility/plugins/factory.h>

#include <map>
#include <string>
#include <vector>

namespace argos {

class CDigest;
class CSimulator;
class CSpace;

/** Base of media, which transmit messages, lights and marks. Updated after physics. */
class CMedium : public CBaseConfigurableResource {
 public:
  typedef std::vector<CMedium*> TVector;
  typedef std::map<std::string, CMedium*> TMap;

  CMedium();
  ~CMedium() override = default;

  /** Reads `id`. @throws CARGoSException if it is missing. */
  void Init(TConfigurationNode& tree) override;
  void Reset() override {}
  void Destroy() override {}
  /** Called once after the arena is filled. */
  virtual void PostSpaceInit() {}
  /**
   * Called once a tick, after the actuators and before physics: applies the commands of actuators
   * while robots are still at the poses at which they gave them. Media are called one after the
   * other, and may use the thread pool.
   */
  virtual void TakeActs() {}
  /**
   * Called once a tick, after physics and before sensing; media of one space run in parallel, those
   * that use the thread pool themselves one after the other.
   */
  virtual void Update() = 0;
  /**
   * @return true if Update() spreads its work over the simulator's thread pool: it is then not
   * called from inside a parallel phase. Must not change during a run.
   */
  virtual bool UsesThreadPool() const { return false; }

  /** @return true if the medium works across the sides of a periodic arena. */
  virtual bool CanBePeriodic() const { return false; }

  /** Adds the state of the medium itself, without that of entities, to a digest of the world. */
  virtual void UpdateDigest(CDigest& /*digest*/) const {}

  const std::string& GetId() const { return m_id; }
  void SetId(const std::string& id) { m_id = id; }
  CSpace& GetSpace() { return m_cSpace; }

 protected:
  CSimulator& m_cSimulator;
  CSpace& m_cSpace;

 private:
  std::string m_id;
};

}  // namespace argos

#define REGISTER_MEDIUM(CLASSNAME, LABEL, AUTHOR, VERSION, BRIEF_DESCRIPTION, LONG_DESCRIPTION,    \
                        STATUS)                                                                    \
  REGISTER_SYMBOL(CMedium, CLASSNAME, LABEL, AUTHOR, VERSION, BRIEF_DESCRIPTION, LONG_DESCRIPTION, \
                  STATUS)

#endif
