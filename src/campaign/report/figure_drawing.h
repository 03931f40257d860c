#ifndef ARGOS3_CAMPAIGN_REPORT_FIGURE_DRAWING_H
#define ARGOS3_CAMPAIGN_REPORT_FIGURE_DRAWING_H

#include <argos3/campaign/report/figures.h>

#include <string>
#include <vector>

namespace argos {

/** A figure in a folder. */
struct SDrawnFigure {
  std::string Kind; /**< see SFigureRequest */
  std::string Name; /**< begins the names of the files NAME.svg, NAME.png, NAME.dat, NAME.gp */
  std::string Caption;
  std::string SVG; /**< becomes part of a page; empty if it was not drawn */
  std::string Problem; /**< why it was not drawn */
};

/**
 * The format of a figure's file, by its ending: "svg", "png" or "pdf".
 * @throws CARGoSException for another ending.
 */
std::string GetFigureFormat(const std::string& file);

/** @return what to install if there is no gnuplot; else empty. */
std::string FindGnuplotProblem();

/**
 * Draws figures into a folder, which is created: for each NAME.dat, NAME.gp, and, by gnuplot,
 * NAME.svg and NAME.png. `gnuplot NAME.gp` in that folder draws it again.
 *
 * What is wrong with one figure is its Problem, and the others are drawn. Without gnuplot, data and
 * scripts are written all the same.
 * @throws CARGoSException if a file cannot be written.
 */
std::vector<SDrawnFigure> DrawFigures(const CReportData& data,
                                      const std::vector<SFigureRequest>& requests,
                                      const std::string& folder);

/** Size and background of a figure. */
struct SFigureLook {
  UInt32 Width = 640, Height = 400; /**< pixels of an SVG file */
  bool IsOpaque = false; /**< an SVG file has a white background */
};

/**
 * Draws a figure that is computed already.
 * @param file  its ending is the format: .svg, .png or .pdf.
 * @throws CARGoSException for another ending, if there is no gnuplot or it fails, and if the file
 *   cannot be written.
 */
void DrawFigure(const SFigureDraft& draft, const SFigureLook& look, const std::string& file);

/**
 * Draws one figure.
 * @param file  its ending is the format: .svg, .png or .pdf.
 * @throws CARGoSException for another ending, as MakeFigure(), if there is no gnuplot or it fails,
 *   and if the file cannot be written.
 */
void DrawFigure(const CReportData& data, const SFigureRequest& request, const std::string& file);

}  // namespace argos

#endif
