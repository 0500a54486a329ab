// Writes a scene file as TOML, section by section. Defaults are written like given values.
#include "scene/write.hpp"

#include <algorithm>
#include <variant>

#include "scene/toml_value.hpp"
#include "scene/words.hpp"

namespace stokesbook {

namespace {

using namespace scene_text;

Entry node_entry(int n_nodes) {
  return n_nodes == automatic_nodes ? Entry("n_nodes", automatic_word) : Entry("n_nodes", n_nodes);
}

std::string own_entries(const QuiescentFlow&) {
  return lines({{"kind", "quiescent"}});
}

std::string own_entries(const UniformFlow& flow) {
  return lines({{"kind", "uniform"}, {"velocity", flow.velocity}});
}

std::string own_entries(const ShearFlow& flow) {
  return lines({{"kind", "shear"}, {"rate", flow.rate}});
}

std::string own_entries(const ExtensionalFlow& flow) {
  return lines({{"kind", "extensional"}, {"rate", flow.rate}});
}

std::string own_entries(const TaylorGreenFlow& flow) {
  return lines({{"kind", "taylor_green"}, {"rate", flow.rate}});
}

std::string own_entries(const LinearFlow& flow) {
  return lines({{"kind", "linear"}, {"gradient", flow.gradient}});
}

std::string flow_section(const Scene& scene) {
  std::string text = "\n[flow]\n";
  const bool enclosed = std::ranges::count(scene.walls, WallRole::outer, &Wall::role) > 0;
  if (!enclosed) {
    text += std::visit([](const auto& flow) { return own_entries(flow); }, scene.flow);
  }
  if (scene.gauge_length) text += lines({{"gauge_length", *scene.gauge_length}});
  if (!scene.reverse_at.empty()) text += lines({{"reverse_at", scene.reverse_at}});
  return text;
}

std::string section(const Wall& wall) {
  return "\n[[walls]]\n" + lines({{"role", name_of(wall.role, wall_roles)},
                                  {"shape", wall.shape},
                                  {"position", wall.position},
                                  {"orientation", wall.orientation},
                                  node_entry(wall.n_nodes),
                                  {"motion", wall.motion}});
}

std::string section(const Body& body) {
  const std::string driving =
      body.held ? lines({{"held", true}, {"velocity", body.velocity}, {"omega", body.omega}})
                : lines({{"force", body.force}, {"torque", body.torque}});
  return "\n[[bodies]]\n" +
         lines({{"shape", body.shape},
                {"position", body.position},
                {"orientation", body.orientation}}) +
         driving + lines({node_entry(body.n_nodes)});
}

std::string section(const Fill& fill) {
  std::string text = "\n[[fill]]\n" + lines({{"shape", fill.shape}});
  if (fill.area_fraction) text += lines({{"area_fraction", *fill.area_fraction}});
  if (fill.count) text += lines({{"count", *fill.count}});
  if (fill.box) text += "region = " + inline_table({{"box", *fill.box}}) + "\n";
  return text + lines({{"clearance", fill.clearance}, node_entry(fill.n_nodes)});
}

std::string section(const SolverSettings& solver) {
  std::string text = "\n[solver]\n" + lines({{"tolerance", solver.tolerance}});
  if (solver.gmres_tol) text += lines({{"gmres_tol", *solver.gmres_tol}});
  return text + lines({{"gmres_max_iterations", solver.gmres_max_iterations},
                       {"summation", name_of(solver.summation, summations)},
                       {"near_singular", name_of(solver.near_singular, near_singular_schemes)},
                       {"preconditioner", name_of(solver.preconditioner, preconditioners)},
                       {"coupling", name_of(solver.coupling, couplings)}});
}

std::string section(const TimeSettings& time) {
  std::string text = "\n[time]\n" + lines({{"t_final", time.t_final},
                                           {"method", name_of(time.method, stepping_methods)}});
  if (time.tolerance) text += lines({{"tolerance", *time.tolerance}});
  if (time.dt) text += lines({{"dt", *time.dt}});
  if (time.dt_min) text += lines({{"dt_min", *time.dt_min}});
  if (time.dt_max) text += lines({{"dt_max", *time.dt_max}});
  if (const std::optional<EffortBounds>& effort = time.effort) {
    text += "effort = " + inline_table({{"few", effort->few}, {"many", effort->many}}) + "\n";
  }
  return text;
}

std::string section(const ContactSettings& contact) {
  const double number = contact.minimum_separation;
  const Entry separation = contact.in_spacings
                               ? Entry("minimum_separation", toml_value(number) + "h")
                               : Entry("minimum_separation", number);
  return "\n[contact]\n" + lines({separation, {"allow_close", contact.allow_close}});
}

std::string section(const OutputSettings& output) {
  std::string text = "\n[output]\n";
  if (output.dt_write) text += lines({{"dt_write", *output.dt_write}});
  text += lines({{"formats", output.formats}});
  if (const std::optional<FieldSettings>& fields = output.fields) {
    text += "fields = " +
            inline_table({{"box", fields->box},
                          {"resolution", fields->resolution},
                          {"quantities", fields->quantities}}) +
            "\n";
  }
  return text;
}

}  // namespace

std::string to_toml(const SceneFile& file) {
  const auto& [scene, fills] = file;
  std::string text = lines({{"title", scene.title}, {"seed", scene.seed}});
  text += "\n[fluid]\n" + lines({{"viscosity", scene.viscosity}});
  text += flow_section(scene);
  for (const Wall& wall : scene.walls) text += section(wall);
  for (const Body& body : scene.bodies) text += section(body);
  for (const Fill& fill : fills) text += section(fill);
  text += section(scene.solver);
  if (scene.time) text += section(*scene.time);
  if (scene.contact) text += section(*scene.contact);
  return text + section(scene.output);
}

}  // namespace stokesbook
