// Tests the files of a run with the readers of their users: NumPy, VTK, an XML and a JSON reader.

#include <cstdlib>

#include <boost/test/unit_test.hpp>

#include "folder.hpp"
#include "record/csv.hpp"
#include "record/run_info.hpp"
#include "sample_run.hpp"

using namespace stokesbook;
using namespace stokesbook::test;

BOOST_AUTO_TEST_SUITE(outputs)

BOOST_AUTO_TEST_CASE(python_reads_every_file) {
  const Folder folder;
  RunDirectory run = RunDirectory::create(folder.path(), sample_contents(), ExistingRun::refuse);
  for (int k = 0; k < 3; ++k) {
    run.write_frame(sample_frame(k));
    run.write_step({.t = k / 7.0,
                    .dt = 1.0 / 7.0,
                    .gmres_iterations = 10 + k,
                    .matvecs = 11 + k,
                    .ncp_iterations = 12 + k,
                    .contacts = 13 + k,
                    .min_gap = 1e-3 / 3.0,
                    .residual = 1e-9 / 3.0,
                    .velocity_error = 1e-7 / 3.0,
                    .step_error = 1e-5 / 3.0,
                    .seconds = 0.1,
                    .kkt_residual = 1e-6 / 3.0,
                    .force_imbalance = 1e-15 / 3.0,
                    .torque_imbalance = 1e-16 / 3.0,
                    .contact_power = -k / 7.0,
                    .energy_injected = 1e-4 / 3.0});
  }
  run.save({});
  run.write_text("run.json",
                 to_json({.version = "0.1.0",
                          .git_hash = "abc",
                          .compiler = "GNU \"12\"",
                          .flags = "-O3",
                          .machine = "x86\\64",
                          .threads = 2,
                          .plan = {"no walls: no N_0", "direct sum"},
                          .has_contact = true,
                          .totals = {1, 5, 2, 3, 4000000000, 6, 7, 0.5, 8, 1e-16, 2e-16, -0.25},
                          .resolution = {{32, 64}, {48, 64}, 2.5e-9, 1.5e-3, {{"pressure", 0.25}}},
                          .uniform_velocity = Complex{0.25, -3.0},
                          .wall_seconds = 1.5,
                          .peak_memory = 5000000000,
                          .exit_status = 2,
                          .message = "overlap in caf\xe9"}));
  const std::string command =
      "'" STOKESBOOK_PYTHON "' '" READ_OUTPUTS "' '" + folder.path().string() + "'";
  BOOST_TEST(std::system(command.c_str()) == 0);
}

BOOST_AUTO_TEST_CASE(zeros_have_no_sign) {
  Frame frame{.t = 1.0, .bodies = {BodyState{}}, .walls = {WallLoad{}}};
  frame.bodies[0].velocity = {-0.0, -1.0};
  frame.bodies[0].torque = -0.0;
  frame.walls[0].force = {-0.0, -0.0};
  BOOST_TEST(trajectory_rows(frame) == "1,0,0,0,0,0,-1,0,0,0,0\n");
  BOOST_TEST(wall_rows(frame) == "1,0,0,0,0\n");
}

BOOST_AUTO_TEST_CASE(totals_of_contact_are_those_of_scenes_with_contact) {
  RunInfo info;
  const auto mentions_contact = [&] {
    return to_json(info).find("ncp_iterations") != std::string::npos;
  };
  BOOST_TEST(!mentions_contact());
  info.has_contact = true;
  BOOST_TEST(mentions_contact());
}

BOOST_AUTO_TEST_SUITE_END()
