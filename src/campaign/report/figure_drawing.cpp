#include <argos3/campaign/report/figure_drawing.h>

#include <argos3/campaign/report/gnuplot_text.h>
#include <argos3/campaign/report/report_files.h>
#include <argos3/campaign/report/report_text.h>
#include <argos3/core/utility/errors/argos_exception.h>
#include <argos3/core/utility/files/input_file.h>
#include <argos3/core/utility/text/string_utilities.h>
#include <argos3/support/child_process.h>
#include <argos3/support/scratch_folder.h>

#include <fmt/format.h>

#include <array>
#include <filesystem>
#include <set>

namespace argos {

namespace {

namespace fs = std::filesystem;

std::string ReadFile(const fs::path& path) {
  std::string content;
  std::string problem;
  if (!ReadInputFile(path.string(), content, problem)) {
    THROW_ARGOSEXCEPTION("gnuplot has not written \"" << path.string() << "\": " << problem);
  }
  return content;
}

void WriteSources(const fs::path& folder, const std::string& name, const SFigureDraft& draft,
                  const SFigureLook& look, const std::vector<std::string>& formats) {
  // the plot command comes once for each format
  const size_t plot = draft.Script.rfind("\nplot ") + 1;
  std::string script =
      fmt::format("# run it in its folder: gnuplot {0}.gp\n{1} = '{0}.dat'\n", name, kDataName) +
      draft.Script.substr(0, plot);
  for (const std::string& format : formats) {
    script += MakeTerminal(format, look.Width, look.Height, look.IsOpaque);
    script += fmt::format("set output '{}.{}'\n", name, format) + draft.Script.substr(plot) +
              "unset output\n";
  }
  WriteReportFile(folder / (name + ".dat"), draft.Data);
  WriteReportFile(folder / (name + ".gp"), script);
}

void RunGnuplot(const fs::path& folder, const std::string& name) {
  // the user's own settings are ignored
  CChildProcess gnuplot({"gnuplot", "-d", name + ".gp"}, folder.string());
  const SProcessEnd end = gnuplot.Finish();
  if (!end.IsSuccess) {
    THROW_ARGOSEXCEPTION("gnuplot has failed (" << end.Description
                                                << "): " << MakeLine(gnuplot.GetErrorText()));
  }
}

// the element <svg> without what is for stand-alone files, with names of its own
std::string MakeInline(std::string svg, const std::string& caption, size_t number) {
  const size_t start = svg.find("<svg");
  svg.erase(0, start == std::string::npos ? 0 : start);
  const size_t title = svg.find("<title>");
  const size_t end = svg.find("</desc>");
  if (title != std::string::npos && end != std::string::npos) {
    svg.replace(title, end + 7 - title, "<title>" + EscapeHTML(caption) + "</title>");
  }
  const std::string prefix = fmt::format("figure{}_", number);
  for (const char* name :
       {"gnuplot_canvas", "gnuplot_plot_", "gpDot", "gpPt", "textbox", "greybox"}) {
    for (const char* before : {"id=\"", "id='", "href='#", "url(#"}) {
      Replace(svg, std::string(before) + name, before + prefix + name);
    }
  }
  // a browser would show them beside the pointer
  for (size_t i = svg.find("<title>gnuplot_plot_"); i != std::string::npos;
       i = svg.find("<title>gnuplot_plot_", i)) {
    svg.erase(i, svg.find("</title>", i) + 8 - i);
  }
  Replace(svg, "<svg", "<svg role=\"img\"");
  return svg;
}

std::string MakeUnique(const std::string& name, std::set<std::string>& names) {
  std::string unique = name;
  for (int number = 2; !names.insert(StringToLowerCase(unique)).second; ++number) {
    unique = fmt::format("{}_{}", name, number);
  }
  return unique;
}

}  // namespace

std::string GetFigureFormat(const std::string& file) {
  const std::string ending = StringToLowerCase(fs::path(file).extension().string());
  if (ending != ".svg" && ending != ".png" && ending != ".pdf") {
    THROW_ARGOSEXCEPTION("the figure \"" << file << "\" must end in .svg, .png or .pdf");
  }
  return ending.substr(1);
}

std::string FindGnuplotProblem() {
  return FindProgram("gnuplot").empty() ? "gnuplot is not installed, which draws the figures "
                                          "(Debian: apt-get install gnuplot-nox)"
                                        : "";
}

std::vector<SDrawnFigure> DrawFigures(const CReportData& data,
                                      const std::vector<SFigureRequest>& requests,
                                      const std::string& folder) {
  if (!requests.empty()) {
    CreateReportFolder(folder);
  }
  const std::string gnuplotProblem = FindGnuplotProblem();
  std::set<std::string> names;
  std::vector<SDrawnFigure> figures;
  for (const SFigureRequest& request : requests) {
    SDrawnFigure& figure = figures.emplace_back();
    figure.Kind = request.Kind;
    figure.Name = MakeUnique(MakeFigureName(request), names);
    SFigureDraft draft;
    try {
      draft = MakeFigure(data, request);
    } catch (const CARGoSException& error) {
      figure.Problem = DescribeProblem(error);
      continue;
    }
    figure.Caption = draft.Caption;
    WriteSources(folder, figure.Name, draft, {request.Width, request.Height, false},
                 {"svg", "png"});
    if (!gnuplotProblem.empty()) {
      figure.Problem = gnuplotProblem;
      continue;
    }
    try {
      RunGnuplot(folder, figure.Name);
      figure.SVG = MakeInline(ReadFile(fs::path(folder) / (figure.Name + ".svg")), draft.Caption,
                              figures.size());
    } catch (const CARGoSException& error) {
      figure.Problem = DescribeProblem(error);
    }
  }
  return figures;
}

void DrawFigure(const SFigureDraft& draft, const SFigureLook& look, const std::string& file) {
  const std::string format = GetFigureFormat(file);
  const std::string problem = FindGnuplotProblem();
  if (!problem.empty()) {
    THROW_ARGOSEXCEPTION(problem);
  }
  const CScratchFolder folder("argos3_figure_");
  WriteSources(folder.GetPath(), "figure", draft, look, {format});
  RunGnuplot(folder.GetPath(), "figure");
  WriteReportFile(file, ReadFile(folder.GetPath() / ("figure." + format)));
}

void DrawFigure(const CReportData& data, const SFigureRequest& request, const std::string& file) {
  // this precedes what takes time
  GetFigureFormat(file);
  DrawFigure(MakeFigure(data, request), {request.Width, request.Height, false}, file);
}

}  // namespace argos
