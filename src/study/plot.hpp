#pragma once

#include <string>
#include <vector>

namespace stokesbook::study {

/// @addtogroup study
/// @{

/// A point of a plot; what a fit left out is drawn hollow.
struct PlotPoint {
  double x;             ///< abscissa
  double y;             ///< ordinate
  bool hollow = false;  ///< drawn without filling
};

/// Points of one method, joined in order.
struct PlotLine {
  std::string label;                   ///< in the legend
  std::vector<PlotPoint> points = {};  ///< in the order in which they are joined
};

/// A straight line to compare with: the law that a line of the plot is claimed to follow.
struct Guide {
  std::size_t line;       ///< whose colour it has
  PlotPoint from;         ///< one end
  PlotPoint to;           ///< the other
  bool triangle = false;  ///< draws the slope as a triangle below instead, with the label beside it
  std::string label = {};  ///< of a triangle
};

/// A plot of positive numbers over a logarithmic y axis.
struct Plot {
  std::string title;                 ///< read out, not shown
  std::string x_label;               ///< below the axis
  std::string y_label;               ///< above the axis
  bool log_x = true;                 ///< else the x axis is linear
  std::vector<PlotLine> lines = {};  ///< methods, in the order of the legend
  std::vector<Guide> guides = {};    ///< laws to compare with
  std::vector<double> floors = {};   ///< levels of rounding, dotted
};

/// Draws a plot as SVG whose colours follow a light or dark page.
///
/// The drawing is our own: gnuplot and Matplotlib write colours into their SVG that cannot follow
/// the page, and have no slope triangles; what is left of a plot is a scale and some paths.
/// Points that a logarithmic axis cannot show are left out; zeros of y lie on the lower edge.
/// @param  plot  lines and labels
/// @return       an svg element; a sentence where no point can be shown
std::string draw_plot(const Plot& plot);

/// @}

}  // namespace stokesbook::study
