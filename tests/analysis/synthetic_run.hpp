#pragma once

#include <cmath>
#include <functional>
#include <limits>
#include <vector>

#include <boost/test/unit_test.hpp>

#include "analysis/run.hpp"
#include "text/word_list.hpp"

namespace stokesbook::test {

inline const auto within_rounding = boost::test_tools::tolerance(1e-12);

/// A scene of disks of radius 2 in a container; its run ends at t = 10.
inline Scene disks(std::size_t count) {
  Scene scene;
  scene.walls = {{.role = WallRole::outer, .shape = Circle{50.0}}};
  for (std::size_t k = 0; k < count; ++k) {
    scene.bodies.push_back({.shape = Circle{2.0}, .position = {10.0 * static_cast<double>(k), 0}});
  }
  scene.time = TimeSettings{.t_final = 10.0, .tolerance = default_step_tolerance};
  return scene;
}

inline NumberTable table(std::string_view header, const std::vector<std::vector<double>>& rows) {
  NumberTable result{"table.csv", {}, {}};
  for (const std::string_view name : split(header, ',')) result.names.emplace_back(name);
  result.columns.resize(result.names.size());
  for (const auto& row : rows) {
    for (std::size_t k = 0; k < row.size(); ++k) result.columns[k].push_back(row[k]);
  }
  return result;
}

/// A run of disks() that was never computed. Body k is at (10 k + x(t), t).
inline Run run_of(const Scene& scene, const std::vector<double>& times,
                  const std::function<double(double)>& x, double stresslet = 3.0) {
  std::vector<std::vector<double>> bodies, walls, rheology, steps;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double t : times) {
    for (std::size_t k = 0; k < scene.bodies.size(); ++k) {
      const auto number = static_cast<double>(k);
      bodies.push_back({t, number, 10.0 * number + x(t), t, 0.1 * t, 1, 1, 0.1, 0, 0, 0});
    }
    walls.push_back({t, 0, 0.5, 0, 7});
    rheology.push_back({t, 4, nan, nan, 0, stresslet, nan, nan});
    steps.push_back({t, 0.5, 3, 8, 0, 0, 0.1, 0, 0, 0, 0.01});
  }
  Run run{.path = "run", .scene = scene};
  run.bodies = table("t,body,x,y,theta,ux,uy,omega,fx,fy,torque", bodies);
  run.walls = table("t,wall,fx,fy,torque", walls);
  run.rheology =
      table("t,dissipation,torque_ratio,order_parameter,s11,s12,uniform_x,uniform_y", rheology);
  run.steps = table(
      "t,dt,gmres_iterations,matvecs,ncp_iterations,contacts,min_gap,residual,"
      "velocity_error,step_error,seconds",
      steps);
  return run;
}

}  // namespace stokesbook::test
