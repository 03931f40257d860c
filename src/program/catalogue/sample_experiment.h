#ifndef ARGOS3_PROGRAM_CATALOGUE_SAMPLE_EXPERIMENT_H
#define ARGOS3_PROGRAM_CATALOGUE_SAMPLE_EXPERIMENT_H

#include <functional>
#include <string>
#include <vector>

namespace argos {

class CSimulator;

/** A small experiment, as texts of the contents of its sections. */
struct SSampleExperiment {
  std::string Framework;
  std::string RobotTypes;
  std::string Actuators;
  std::string Sensors;
  std::string Arena;
  std::string Engines; /**< empty: the first engine that accepts what is in the arena */
  std::string Media;
  std::string Visualization;
  std::string Outputs;
  std::string Sections; /**< whole sections: <loop_functions> */

  /** Each robot has a controller in Lua with these devices, whatever its "config" is. */
  std::string ToXml(const std::string& engines) const;
};

/**
 * Loads sample experiments in a temporary folder, which is the working directory until the loader
 * is destroyed, without messages. So files that parts write disappear.
 */
class CSampleLoader {
 public:
  CSampleLoader();
  ~CSampleLoader();
  CSampleLoader(const CSampleLoader&) = delete;
  CSampleLoader& operator=(const CSampleLoader&) = delete;

  /**
   * Loads a sample, calls @p use, and destroys the experiment.
   * @return the error; "" if there was none.
   */
  std::string Load(const SSampleExperiment& sample,
                   const std::function<void(CSimulator&)>& use = nullptr);

  /** The same with an experiment as text. */
  static std::string LoadXml(const std::string& xml,
                             const std::function<void(CSimulator&)>& use = nullptr);
  /** The element of the engine that was used last. */
  std::string GetEngine() const { return m_engines.empty() ? "" : m_engines.front(); }

 private:
  std::string m_folder;
  std::string m_previousFolder;
  std::vector<std::string> m_engines;  // elements; the one that was used last is the first
};

}  // namespace argos

#endif
