# tables, comparisons, figures and the page of a campaign
target_sources(argos3campaign PRIVATE
  report/boxplot.cpp
  report/campaign_report.cpp
  report/comparison_text.cpp
  report/comparisons.cpp
  report/difference_figure.cpp
  report/equal_levels.cpp
  report/figure_drawing.cpp
  report/figure_request.cpp
  report/figures.cpp
  report/gnuplot_text.cpp
  report/heatmap.cpp
  report/html_page.cpp
  report/mean_points.cpp
  report/means_figure.cpp
  report/page_results.cpp
  report/page_set_up.cpp
  report/page_style.cpp
  report/report_data.cpp
  report/report_files.cpp
  report/report_text.cpp
  report/scaling_figure.cpp
  report/series_figure.cpp
  report/series_lines.cpp
  report/series_times.cpp
  report/summary_tables.cpp)
