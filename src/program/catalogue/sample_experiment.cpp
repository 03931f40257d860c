#include <argos3/program/catalogue/sample_experiment.h>

#include <argos3/core/simulator/physics_engine/physics_engine.h>
#include <argos3/core/simulator/simulator.h>
#include <argos3/core/utility/configuration/configuration_document.h>
#include <argos3/program/catalogue/log_silence.h>

#include <stdlib.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <regex>
#include <set>

namespace argos {

namespace {

namespace fs = std::filesystem;

constexpr const char* kScript = "argos3_sample.lua";

std::string Section(const std::string& tag, const std::string& contents) {
  return "<" + tag + ">" + contents + "</" + tag + ">\n";
}

// one for each id that a robot names
std::string Controllers(const std::string& arena, const std::string& devices) {
  static const std::regex kConfig("\\bconfig=[\"']([^\"']*)[\"']");
  std::set<std::string> ids;
  for (std::sregex_iterator it(arena.begin(), arena.end(), kConfig), end; it != end; ++it) {
    ids.insert((*it)[1]);
  }
  std::string controllers;
  for (const std::string& id : ids) {
    controllers += "<lua_controller id=\"" + id + "\">" + devices + "<params script=\"" + kScript +
                   "\" /></lua_controller>\n";
  }
  return controllers;
}

}  // namespace

std::string SSampleExperiment::ToXml(const std::string& engines) const {
  const std::string framework =
      Framework.empty() ? "<experiment length=\"1\" ticks_per_second=\"10\" random_seed=\"1\" />"
                        : Framework;
  return "<argos-configuration>\n" + Section("framework", framework) +
         (RobotTypes.empty() ? "" : Section("robot_types", RobotTypes)) +
         Section("controllers", Controllers(Arena, Section("actuators", Actuators) +
                                                       Section("sensors", Sensors))) +
         "<arena size=\"20,20,10\">" + Arena + "</arena>\n" + Section("physics_engines", engines) +
         Section("media", Media) +
         (Visualization.empty() ? "" : Section("visualization", Visualization)) +
         (Outputs.empty() ? "" : Section("outputs", Outputs)) + Sections +
         "</argos-configuration>\n";
}

CSampleLoader::CSampleLoader() : m_previousFolder(fs::current_path()) {
  std::string name = (fs::temp_directory_path() / "argos3_sample_XXXXXX").string();
  if (mkdtemp(name.data()) == nullptr) {
    THROW_ARGOSEXCEPTION("cannot create a temporary folder " << name);
  }
  m_folder = name;
  fs::current_path(m_folder);
  std::ofstream(kScript) << "function init() end function step() end function reset() end "
                            "function destroy() end\n";
  for (const std::string& label : CFactory<CPhysicsEngine>::GetLabels()) {
    m_engines.push_back("<" + label + " id=\"sample_engine\" />");
  }
}

CSampleLoader::~CSampleLoader() {
  std::error_code failure;
  fs::current_path(m_previousFolder, failure);
  fs::remove_all(m_folder, failure);
}

std::string CSampleLoader::LoadXml(const std::string& xml,
                                   const std::function<void(CSimulator&)>& use) {
  const CLogSilence silence;
  try {
    CConfigurationDocument document;
    document.Parse(xml, "sample.argos");
    CSimulator simulator;
    const CSimulator::CScope scope(simulator);
    simulator.Load(document);
    if (use) {
      use(simulator);
    }
    simulator.Destroy();
  } catch (const std::exception& error) {
    return error.what();
  } catch (...) {
    return "an exception that is not a std::exception was thrown";
  }
  return "";
}

std::string CSampleLoader::Load(const SSampleExperiment& sample,
                                const std::function<void(CSimulator&)>& use) {
  if (!sample.Engines.empty()) {
    return LoadXml(sample.ToXml(sample.Engines), use);
  }
  std::string first;
  for (size_t i = 0; i < m_engines.size(); ++i) {
    const std::string error = LoadXml(sample.ToXml(m_engines[i]), use);
    if (error.empty()) {
      std::rotate(m_engines.begin(), m_engines.begin() + static_cast<std::ptrdiff_t>(i),
                  m_engines.begin() + static_cast<std::ptrdiff_t>(i) + 1);
      return "";
    }
    first = i == 0 ? error : first;
    // other engines accept other bodies; all else is the same with each of them
    if (error.find("engine") == std::string::npos) {
      break;
    }
  }
  return first;
}

}  // namespace argos
