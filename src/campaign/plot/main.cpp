#include <argos3/campaign/plot/table_figures.h>
#include <argos3/campaign/report/figure_request.h>
#include <argos3/core/utility/errors/argos_exception.h>
#include <argos3/core/utility/errors/exception_text.h>
#include <argos3/core/utility/text/string_utilities.h>
#include <argos3/program/catalogue/version_text.h>

#include <cstdio>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace argos {

namespace {

constexpr char kUsage[] =
    R"(Usage: argos3-plot trajectories FILE -o PICTURE [--robots ID,ID,...] [--run N] [--from S] [--to S]
       argos3-plot metrics NAME[,NAME...] FILE... -o PICTURE [--label TEXT] [--log] [--xlog] [--from S] [--to S] [--ended RULE]

trajectories  the paths of the robots over the arena, with its walls and objects where they were at the
              start, from a table with the columns x and y. Circles are the ends, dots the starts.
metrics       columns of tables against time: the median over all files and runs, and the band between
              the quartiles. Each file has the run, or the runs, of one seed.

FILE     .csv or .csv.gz, as <table>, <metrics> and --csv of argos3 write it
PICTURE  its ending chooses the format: .svg, .png or .pdf

  -o, --output PICTURE  the file to write
  --robots ID,...       of trajectories: only these robots
  --run N               of trajectories: only this run of an experiment that was reset; the default is 0
  --from S, --to S      only these simulated seconds
  --label TEXT          of metrics: of the vertical axis; the default is the name and the unit of the first column
  --log                 of metrics: logarithmic axis of the values; medians of 0 or less are left out
  --xlog                of metrics: logarithmic axis of time; the state at 0 s is left out
  --ended RULE          runs that end before others: survivors (default) do not count them any more,
                        hold keeps their last value, drop leaves out the times after the first end
  -h, --help            print this text
  --version             print the version, the commit and the compiler

Example, ten seeds:
  for seed in {1..10}; do argos3 -zc foraging.argos --seed $seed --csv out/$seed; done
  argos3-plot trajectories out/1/robots.csv -o paths.png
  argos3-plot metrics food out/*/metrics.csv -o food.svg
  argos3-plot metrics squared_displacement out/*/metrics.csv --log --xlog -o diffusion.svg

It needs gnuplot.
)";

constexpr const char* kSeeHelp = "; see argos3-plot --help";

struct SPlotOptions {
  bool ShowsHelp = false;
  bool ShowsVersion = false;
  std::string Kind, Output;
  std::vector<std::string> Words;
  STrajectoryRequest Trajectories;
  SMetricRequest Metrics;
};

Real ParseSeconds(const std::string& option, const std::string& text) {
  Real seconds = 0.0;
  if (ParseNumber(text, seconds) != ENumberParsing::Ok) {
    THROW_ARGOSEXCEPTION(option << " must be a number of seconds, found \"" << text << '"');
  }
  return seconds;
}

std::vector<std::string> SplitList(const std::string& text) {
  std::vector<std::string> words;
  Tokenize(text, words, ",");
  return words;
}

struct SPlotOption {
  const char* Name;
  const char* Kind = ""; /**< to which the option belongs; empty: to both */
  bool HasValue = true;
};

constexpr SPlotOption kPlotOptions[] = {
    {"-o"},
    {"--output"},
    {"--from"},
    {"--to"},
    {"--robots", "trajectories"},
    {"--run", "trajectories"},
    {"--label", "metrics"},
    {"--ended", "metrics"},
    {"--log", "metrics", false},
    {"--xlog", "metrics", false},
};

const SPlotOption& FindOption(const std::string& name) {
  std::vector<std::string> names;
  for (const SPlotOption& option : kPlotOptions) {
    if (option.Name == name) {
      return option;
    }
    names.emplace_back(option.Name);
  }
  THROW_ARGOSEXCEPTION("unknown option " << name << DidYouMean(name, names) << kSeeHelp);
}

// @param value  of an option that has one.
void SetOption(SPlotOptions& options, const std::string& name, const std::string& value) {
  STrajectoryRequest& trajectories = options.Trajectories;
  SMetricRequest& metrics = options.Metrics;
  if (name == "-o" || name == "--output") {
    options.Output = value;
  } else if (name == "--from") {
    trajectories.Span.From = metrics.Span.From = ParseSeconds(name, value);
  } else if (name == "--to") {
    trajectories.Span.To = metrics.Span.To = ParseSeconds(name, value);
  } else if (name == "--robots") {
    trajectories.Robots = SplitList(value);
  } else if (name == "--run") {
    if (ParseNumber(value, trajectories.Run) != ENumberParsing::Ok) {
      THROW_ARGOSEXCEPTION("--run must be a whole number, found \"" << value << '"');
    }
  } else if (name == "--label") {
    metrics.Label = value;
  } else if (name == "--ended") {
    metrics.Ended = ParseEndedRuns(value);
  } else if (name == "--log") {
    metrics.IsLogarithmic = true;
  } else if (name == "--xlog") {
    metrics.IsTimeLogarithmic = true;
  }
}

SPlotOptions ParseArguments(const std::vector<std::string>& arguments) {
  SPlotOptions options;
  std::map<std::string, std::string> kinds;  // of the options that are given
  for (size_t i = 0; i < arguments.size(); ++i) {
    const std::string& argument = arguments[i];
    if (argument == "-h" || argument == "--help") {
      options.ShowsHelp = true;
    } else if (argument == "--version") {
      options.ShowsVersion = true;
    } else if (argument.size() < 2 || argument[0] != '-') {
      (options.Kind.empty() ? options.Kind : options.Words.emplace_back()) = argument;
    } else {
      const SPlotOption& option = FindOption(argument);
      if (option.HasValue && ++i == arguments.size()) {
        THROW_ARGOSEXCEPTION(argument << " needs a value");
      }
      SetOption(options, argument, arguments[i]);
      kinds[argument] = option.Kind;
    }
  }
  for (const auto& [option, kind] : kinds) {
    if (!kind.empty() && !options.Kind.empty() && kind != options.Kind) {
      THROW_ARGOSEXCEPTION(option << " belongs to " << kind << kSeeHelp);
    }
  }
  return options;
}

void CheckFiles(const std::vector<std::string>& files) {
  for (const std::string& file : files) {
    std::error_code ignored;
    if (!std::filesystem::is_regular_file(file, ignored)) {
      THROW_ARGOSEXCEPTION("there is no file \"" << file << '"');
    }
    const std::string name = StringToLowerCase(file);
    if (!name.ends_with(".csv") && !name.ends_with(".csv.gz")) {
      THROW_ARGOSEXCEPTION("\"" << file << "\": only .csv and .csv.gz can be plotted");
    }
  }
}

void CheckPlotOptions(SPlotOptions& options) {
  if (options.Kind.empty()) {
    THROW_ARGOSEXCEPTION("what is to be plotted: trajectories or metrics?" << kSeeHelp);
  }
  if (options.Kind == "metrics") {
    if (options.Words.size() < 2) {
      THROW_ARGOSEXCEPTION("metrics needs the names of columns and at least one file" << kSeeHelp);
    }
    options.Metrics.Metrics = SplitList(options.Words.front());
    options.Metrics.Files.assign(options.Words.begin() + 1, options.Words.end());
    CheckFiles(options.Metrics.Files);
  } else if (options.Kind == "trajectories") {
    if (options.Words.size() != 1) {
      THROW_ARGOSEXCEPTION("trajectories needs one file, found " << options.Words.size());
    }
    options.Trajectories.File = options.Words.front();
    CheckFiles(options.Words);
  } else {
    THROW_ARGOSEXCEPTION('"' << options.Kind << "\" cannot be plotted; known: trajectories, metrics"
                             << kSeeHelp);
  }
  if (options.Output.empty()) {
    THROW_ARGOSEXCEPTION("-o PICTURE is missing");
  }
}

void Plot(const std::vector<std::string>& arguments) {
  SPlotOptions options = ParseArguments(arguments);
  if (options.ShowsHelp) {
    std::fputs(kUsage, stdout);
    return;
  }
  if (options.ShowsVersion) {
    std::fputs(DescribeVersion().c_str(), stdout);
    return;
  }
  CheckPlotOptions(options);
  // this precedes what takes time
  GetFigureFormat(options.Output);
  SFigureLook look{720, 432, true};
  const SFigureDraft draft = options.Kind == "metrics"
                                 ? MakeMetricFigure(options.Metrics)
                                 : MakeTrajectoryFigure(options.Trajectories, look);
  DrawFigure(draft, look, options.Output);
  if (!draft.Caption.empty()) {
    std::fprintf(stderr, "argos3-plot:%s\n", draft.Caption.c_str());
  }
}

// the lines of an exception without marks, for the user of a small program
std::string WithoutMarks(std::string text) {
  Replace(text, "[FATAL] ", "");
  return text;
}

// @return the exit status: 0, or 1 after an error, which is printed
int RunPlotProgram(int argc, const char* const* argv) noexcept {
  try {
    Plot({argv + 1, argv + argc});
    return 0;
  } catch (...) {
    std::fprintf(stderr, "argos3-plot: %s\n", WithoutMarks(DescribeCurrentException()).c_str());
    return 1;
  }
}

}  // namespace

}  // namespace argos

int main(int argc, char** argv) {
  return argos::RunPlotProgram(argc, argv);
}
