#pragma once

#include <string>
#include <vector>

namespace hada {

/// One axis of a plot.
struct Axis {
  std::string label;  // with its unit
  bool log = false;
  double low = 0.0;
  double high = 1.0;
};

/// What is drawn: measured values as points with error bars, models as lines.
struct Series {
  enum class Mark { points, line };
  std::string name;
  Mark mark = Mark::points;
  std::string colour = "var(--data)";
  std::vector<double> x = {};
  std::vector<double> y = {};
  std::vector<double> sigma = {};  // half the length of the error bars; may be empty
};

/// The axis over all positive (log) or all (linear) values of `values`, with a little air.
Axis axis_over(const std::string& label, bool log, const std::vector<double>& values);

/// Round numbers to label between low and high, about `wanted` (linear) or the decades (log).
std::vector<double> ticks(const Axis& axis, int wanted = 5);

/// A number as a person would write it on an axis.
std::string tick_text(double value);

/// The plot as an inline SVG, its text in the colours of the page.
std::string plot(const Axis& x, const Axis& y, const std::vector<Series>& series);

}  // namespace hada
