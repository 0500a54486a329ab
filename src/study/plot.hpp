#pragma once

#include <string>
#include <vector>

namespace stokesbook::study {

/// A point of a plot; points that a fit left out are hollow.
struct PlotPoint {
  double x;             ///< abscissa
  double y;             ///< ordinate
  bool hollow = false;  ///< drawn without filling
  double error = 0.0;   ///< half the height of an error bar; 0: no bar
};

/// A line of a plot: points joined in order, such as those of one method.
struct PlotLine {
  std::string label;                   ///< name in the legend
  std::vector<PlotPoint> points = {};  ///< in the order in which they are joined
};

/// A straight line for comparison: the law that is claimed for a line of the plot.
struct Guide {
  std::size_t line;        ///< index of the line whose colour the guide has
  PlotPoint from;          ///< one end
  PlotPoint to;            ///< the other
  std::string slope = {};  ///< label of a slope triangle below; empty: a dashed line
};

/// A plot of lines, of positive numbers unless the y axis is linear.
struct Plot {
  std::string title;                 ///< read by screen readers, not shown
  std::string x_label;               ///< below the axis
  std::string y_label;               ///< above the axis
  bool log_x = true;                 ///< false: the x axis is linear
  bool log_y = true;                 ///< false: the y axis is linear
  bool cells = false;                ///< true: a heat map over whole numbers x, a row for each line
  std::vector<PlotLine> lines = {};  ///< methods, in the order of the legend
  std::vector<Guide> guides = {};    ///< laws to compare with
  std::vector<double> floors = {};   ///< levels of rounding, dotted
};

/// Draws a plot as SVG whose colours follow a light or dark page.
///
/// The function does not use gnuplot or Matplotlib, because the colours in their SVG cannot follow
/// the page, and because they have no slope triangles; the rest of a plot is a scale and some
/// paths. Of slope triangles with the same number that would cover each other, one is drawn. Points
/// that a logarithmic axis cannot show are left out; zeros of y lie on the lower edge. A heat map
/// has neither guides nor floors. Lines of more than 40 points have markers at some of their
/// points. A plot without any point that can be shown becomes a sentence.
std::string draw_plot(const Plot& plot);

}  // namespace stokesbook::study
