#include <argos3/campaign/design/campaign.h>

#include <argos3/campaign/design/combinations.h>
#include <argos3/campaign/design/element_reading.h>
#include <argos3/campaign/design/factor_reader.h>
#include <argos3/campaign/design/section_readers.h>
#include <argos3/campaign/design/setting_checks.h>
#include <argos3/core/utility/configuration/configuration_document.h>
#include <argos3/core/utility/files/input_file.h>
#include <argos3/core/utility/text/string_utilities.h>

#include <algorithm>
#include <filesystem>
#include <set>

namespace argos {

namespace {

constexpr const char* kRootTag = "argos-campaign";
constexpr const char* kExperimentTag = "argos-configuration";

/** Reads one campaign file. */
class CCampaignReader {
 public:
  explicit CCampaignReader(const std::string& file) { m_campaign.File = file; }

  SCampaign Read() {
    LoadFile();
    TConfigurationNode& root = m_document.GetRoot();
    ReadRootAttributes(root);
    ReadSections(root);
    for (const std::string& line : m_document.DescribeUnread()) {
      m_errors.Add("", CARGoSException(line));
    }
    m_errors.Try("", [this] { CheckExperiment(); });
    m_errors.ThrowIfAny("errors in the campaign");
    return m_campaign;
  }

 private:
  void LoadFile() {
    std::string problem;
    if (!ReadInputFile(m_campaign.File, m_campaign.Text, problem)) {
      THROW_ARGOSEXCEPTION("the campaign file \"" << m_campaign.File
                                                  << "\" cannot be read: " << problem);
    }
    m_document.Parse(m_campaign.Text, m_campaign.File);
    TConfigurationNode& root = m_document.GetRoot();
    if (root.Value() != kRootTag) {
      THROW_ARGOSEXCEPTION(root.GetLocation()
                           << ": the root element is <" << root.Value() << ">, expected <"
                           << kRootTag << ">; is it a campaign file?");
    }
  }

  // relative to the campaign file
  std::string ResolvePath(const std::string& path) const {
    return (std::filesystem::path(m_campaign.File).parent_path() / path).string();
  }

  void ReadExperimentFile(TConfigurationNode& root) {
    m_campaign.ExperimentFile = ResolvePath(ReadText(root, "experiment"));
    std::string problem;
    if (!ReadInputFile(m_campaign.ExperimentFile, m_campaign.ExperimentText, problem)) {
      ThrowAt(root, "attribute \"experiment\": \"" + m_campaign.ExperimentFile +
                        "\" cannot be read: " + problem);
    }
  }

  void ReadRootAttributes(TConfigurationNode& root) {
    m_errors.Try("", [&] { ReadExperimentFile(root); });
    m_campaign.Title = ReadOptionalText(root, "title");
    m_errors.Try("", [&] {
      const std::string stem = std::filesystem::path(m_campaign.File).stem().string();
      const std::string results = ReadOptionalText(root, "results");
      m_campaign.ResultsFile = ResolvePath(results.empty() ? stem + ".sqlite" : results);
    });
  }

  void ReadSections(TConfigurationNode& root) {
    // figures and tests name factors and metrics, which may follow them in the file
    TConfigurationNode* figures = nullptr;
    TConfigurationNode* tests = nullptr;
    std::string runs;
    bool hasAllMetrics = true;
    ReadChildren(
        m_errors, root,
        {{"factors", [&](TConfigurationNode& node) { m_design = ReadFactors(m_errors, node); }},
         {"set", [&](TConfigurationNode& node) { m_constants.push_back(ReadSetting(node)); }},
         {"runs",
          [&](TConfigurationNode& node) {
            runs = node.GetLocation() + ": <runs>";
            ReadRuns(node, m_campaign);
          }},
         {"limits", [&](TConfigurationNode& node) { ReadLimits(node, m_campaign); }},
         {"execution",
          [&](TConfigurationNode& node) {
            m_hasThreads = NodeAttributeExists(node, "threads");
            ReadExecution(node, m_campaign);
          }},
         {"collect",
          [&](TConfigurationNode& node) {
            hasAllMetrics = ReadCollected(m_errors, node, m_campaign);
          }},
         {"figures", [&](TConfigurationNode& node) { figures = &GetNode(root, node.Value()); }},
         {"tests", [&](TConfigurationNode& node) { tests = &GetNode(root, node.Value()); }},
         {"slurm", [&](TConfigurationNode& node) { ReadSlurm(m_errors, node, m_campaign); }}},
        {"factors", "runs", "limits", "execution", "collect", "figures", "tests", "slurm"});
    if (runs.empty()) {
      m_errors.Add("", CARGoSException(root.GetLocation() + ": <" + kRootTag +
                                       ">: the element <runs seeds=\"...\"/> is missing"));
    }
    if (m_design.IsComplete) {
      MakeCombinations(m_errors, m_design, m_campaign);
    }
    for (const SLocatedSetting& constant : m_constants) {
      m_campaign.Constants.push_back(constant.Setting);
    }
    if (m_design.IsComplete && hasAllMetrics) {
      m_errors.Try("", [&] { CheckStopping(m_campaign, runs); });
      ReadElementIfAny(figures, ReadFigures);
      ReadElementIfAny(tests, ReadTests);
    } else {
      // names that could not be read would be reported as unknown
      ReadElementIfAny(figures, SkipElement);
      ReadElementIfAny(tests, SkipElement);
    }
  }

  typedef void TReader(CLoadErrors&, TConfigurationNode&, SCampaign&);

  static void SkipElement(CLoadErrors&, TConfigurationNode& node, SCampaign&) {
    MarkSubtreeRead(node);
  }

  void ReadElementIfAny(TConfigurationNode* node, TReader* read) {
    if (node != nullptr) {
      read(m_errors, *node, m_campaign);
    }
  }

  void CheckExperiment() {
    if (m_campaign.ExperimentText.empty()) {
      throw CAlreadyReported("no experiment");
    }
    const std::string original = m_campaign.ExperimentText;
    CConfigurationDocument document;
    document.Parse(original, m_campaign.ExperimentFile);
    if (document.GetRoot().Value() != kExperimentTag) {
      THROW_ARGOSEXCEPTION(document.GetRoot().GetLocation()
                           << ": the root element is <" << document.GetRoot().Value()
                           << ">, expected <" << kExperimentTag << ">; is it an experiment?");
    }
    m_campaign.ExperimentSource = original;
    ApplyConstants(m_errors, m_campaign.ExperimentFile, m_constants, m_campaign.ExperimentText);
    const std::set<std::string> ofThreads = CheckSettings(
        m_errors, m_campaign.ExperimentFile, m_campaign.ExperimentText, m_constants, m_design);
    NoteThreads(ofThreads);
  }

  // the number of threads is that of <execution>, unless a setting has another
  void NoteThreads(const std::set<std::string>& paths) {
    for (const SLocatedSetting& constant : m_constants) {
      if (paths.count(constant.Setting.Path) == 0) {
        continue;
      }
      if (m_hasThreads) {
        THROW_ARGOSEXCEPTION(constant.Location << ": \"" << constant.Setting.Path
                                               << "\" is set twice, also by <execution threads=\""
                                               << m_campaign.Threads << "\">");
      }
      if (ParseNumber(constant.Setting.Value, m_campaign.Threads) != ENumberParsing::Ok) {
        THROW_ARGOSEXCEPTION(constant.Location << ": \"" << constant.Setting.Value
                                               << "\" is no number of threads");
      }
    }
    const auto isOfThreads = [&paths](const std::string& path) { return paths.count(path) > 0; };
    for (SFactor& factor : m_campaign.Factors) {
      factor.SetsThreads = true;
      for (const SLevel& level : factor.Levels) {
        factor.SetsThreads = factor.SetsThreads && !level.Settings.empty() &&
                             std::ranges::all_of(level.Settings, isOfThreads, &SSetting::Path);
      }
    }
  }

  SCampaign m_campaign;
  CConfigurationDocument m_document;
  CLoadErrors m_errors;
  SDesignSource m_design;
  std::vector<SLocatedSetting> m_constants;
  bool m_hasThreads = false;  // <execution> has a number
};

}  // namespace

SCampaign ReadCampaign(const std::string& file) {
  return CCampaignReader(file).Read();
}

}  // namespace argos
