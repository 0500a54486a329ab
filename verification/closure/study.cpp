// Study of the closure: compares motions with closed forms, and shows the effect of scales on the
// condition number.
#include "experiments.hpp"
#include "studies.hpp"

namespace stokesbook {

study::Study closure_study() {
  using namespace verification::closure;
  return {.number = "03",
          .name = "closure",
          .title = "Closure: forces, torques and motions",
          .experiments = {loaded_ellipses(),
                          sheared_ellipses(),
                          closure_values(),
                          symmetry(),
                          spectrum(),
                          condition_and_size(),
                          condition_and_nodes(),
                          condition_and_viscosity(),
                          degenerate_scale(),
                          near_degenerate_scale(),
                          units(),
                          gaps(),
                          streams(),
                          pair_units(),
                          forms_at_work(),
                          graded_pairs(),
                          graded_tolerances(),
                          lubrication(),
                          nearly_touching_condition(),
                          nearly_touching_rounding()}};
}

}  // namespace stokesbook
