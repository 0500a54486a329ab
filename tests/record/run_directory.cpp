// Tests run directories: the directories that they refuse, and the files that they keep, remove and
// write again.

#include "record/run_directory.hpp"

#include <algorithm>

#include <boost/test/unit_test.hpp>
#include <sys/stat.h>

#include "folder.hpp"
#include "record/atomic_file.hpp"
#include "record/checkpoint.hpp"
#include "record/csv.hpp"
#include "record/vtk.hpp"
#include "sample_run.hpp"

using namespace stokesbook;
using namespace stokesbook::test;

namespace {

RunDirectory create(const Folder& folder, const RunContents& contents = sample_contents()) {
  return RunDirectory::create(folder.path(), contents, ExistingRun::refuse);
}

auto mentions(const std::string& first, const std::string& second) {
  return [=](const RecordError& error) {
    const std::string message = error.what();
    return message.find(first) != std::string::npos && message.find(second) != std::string::npos;
  };
}

}  // namespace

BOOST_AUTO_TEST_SUITE(run_directory)

BOOST_AUTO_TEST_CASE(directories_are_made) {
  const Folder folder;
  RunDirectory::create(folder.at("a") / "b", sample_contents(), ExistingRun::refuse);
  BOOST_TEST(std::filesystem::exists(folder.at("a") / "b" / "trajectory.csv"));
}

BOOST_AUTO_TEST_CASE(only_files_asked_for_are_written) {
  RunContents contents = sample_contents();
  contents.vtk = contents.svg = contents.html = contents.fields = contents.contacts = false;
  contents.tracers = false;
  const auto names = [](const RunContents& asked, int k) {
    const Folder folder;
    Frame frame = sample_frame(k);
    if (!asked.fields) frame.field.reset();
    if (!asked.contacts) frame.contacts.clear();
    create(folder, asked).write_frame(frame);
    std::string list;
    for (const auto& [name, text] : read_all(folder.path())) list += name + ' ';
    return list;
  };
  BOOST_TEST(
      names(sample_contents(), 0) ==
      "animation.html bodies.pvd bodies_000000.vtp configuration.svg contacts.csv contacts.pvd "
      "contacts_000000.vtp fields.pvd fields_000000.vti "
      "fields_dissipation.svg fields_pressure.svg fields_shear_stress.svg "
      "fields_velocity.svg fields_vorticity.svg rheology.csv steps.csv tracers.csv tracers.pvd "
      "tracers_000000.vtp trajectory.csv walls.csv ");
  BOOST_TEST(names(contents, 0) == "rheology.csv steps.csv trajectory.csv walls.csv ");
  contents.contacts = true;
  BOOST_TEST(names(contents, 0) == "contacts.csv rheology.csv steps.csv trajectory.csv walls.csv ");
  contents.csv = false;
  BOOST_TEST(names(contents, 1) == "steps.csv ");
  contents.vtk = true;
  BOOST_TEST(names(contents, 1) ==
             "bodies.pvd bodies_000000.vtp contacts.pvd contacts_000000.vtp steps.csv ");
  contents.contacts = false;
  BOOST_TEST(names(contents, 1) == "bodies.pvd bodies_000000.vtp steps.csv ");
  contents.vtk = false;
  contents.fields = true;
  BOOST_TEST(names(contents, 0) == "fields.pvd fields_000000.vti steps.csv ");
  contents.fields = false;
  contents.svg = true;
  BOOST_TEST(names(contents, 0) == "configuration.svg steps.csv ");
  contents.svg = false;
  contents.html = true;
  BOOST_TEST(names(contents, 0) == "animation.html steps.csv ");
}

BOOST_AUTO_TEST_CASE(no_table_of_walls_without_walls) {
  const Folder folder;
  RunContents contents = sample_contents();
  contents.outlines.walls.clear();
  Frame frame = sample_frame(0);
  frame.walls.clear();
  create(folder, contents).write_frame(frame);
  BOOST_TEST(!std::filesystem::exists(folder.at("walls.csv")));
}

BOOST_AUTO_TEST_CASE(a_run_is_not_overwritten_unasked) {
  for (const std::string name : {"checkpoint", "run.json", "trajectory.csv", "steps.csv",
                                 "animation.html", "bodies_000003.vtp", "fields.pvd",
                                 "configuration.svg", "fields_pressure.svg", "scene.toml"}) {
    const Folder folder;
    write(folder.at(name), "precious");
    BOOST_CHECK_EXCEPTION(create(folder), RecordError, mentions("already contains a run", name));
    BOOST_TEST((read_all(folder.path()) == std::map<std::string, std::string>{{name, "precious"}}));
  }
}

BOOST_AUTO_TEST_CASE(overwriting_spares_foreign_files) {
  const Folder folder;
  run_or_resume(folder.path(), sample_contents(), 4);
  const std::map<std::string, std::string> foreign{
      {"bodies.csv", "1"},   {"bodies_1.vtp", "2"},   {"bodies_000001.vtp.old", "3"},
      {"notes", "4"},        {"fits.partial", "5"},   {"scene.toml", "6"},
      {"fields_1.vti", "7"}, {"fields_old.svg", "8"}, {"fields_000001.vtp", "9"},
      {"contacts.vtp", "10"}};
  for (const auto& [name, text] : foreign) write(folder.at(name), text);
  for (const std::string name : {"checkpoint", "trajectory.csv", "trajectory.csv.partial"}) {
    write(folder.at(name + ".partial"), "left by a kill");
  }
  RunContents contents = sample_contents();
  contents.csv = contents.html = false;
  RunDirectory::create(folder.path(), contents, ExistingRun::overwrite);
  std::map<std::string, std::string> rest = read_all(folder.path());
  BOOST_TEST(rest.erase("steps.csv") == 1u);
  BOOST_TEST((rest == foreign));
}

BOOST_AUTO_TEST_CASE(a_restart_takes_the_place_of_a_run_only) {
  const Folder folder;
  const auto restart = [&] {
    RunDirectory::create(folder.path(), sample_contents(), ExistingRun::restart);
  };
  const std::map<std::string, std::string> mine{{"animation.html", "mine"}, {"walls.csv", "mine"}};
  for (const auto& [name, text] : mine) write(folder.at(name), text);
  BOOST_CHECK_EXCEPTION(restart(), RecordError, mentions("already contains a run", "--overwrite"));
  BOOST_TEST((read_all(folder.path()) == mine));
  write(folder.at("steps.csv"), "of a run that was killed");
  restart();
  BOOST_TEST(read(folder.at("walls.csv")) != "mine");
  const Folder empty;
  RunDirectory::create(empty.at("a"), sample_contents(), ExistingRun::restart);
  BOOST_TEST(std::filesystem::exists(empty.at("a") / "steps.csv"));
}

BOOST_AUTO_TEST_CASE(one_run_at_a_time_writes_a_directory) {
  const Folder folder;
  const auto refused = mentions(folder.path().string(), "is being written by another run");
  {
    RunDirectory run = create(folder);
    run.save({});
    const std::map<std::string, std::string> files = read_all(folder.path());
    for (const ExistingRun existing :
         {ExistingRun::refuse, ExistingRun::restart, ExistingRun::overwrite}) {
      BOOST_CHECK_EXCEPTION(RunDirectory::create(folder.path(), sample_contents(), existing),
                            RecordError, refused);
    }
    BOOST_CHECK_EXCEPTION(RunDirectory::resume(folder.path(), sample_contents()), RecordError,
                          refused);
    BOOST_TEST((read_all(folder.path()) == files));
  }
  const ResumedRun resumed = RunDirectory::resume(folder.path(), sample_contents());
  BOOST_CHECK_EXCEPTION(RunDirectory::resume(folder.path(), sample_contents()), RecordError,
                        refused);
}

BOOST_AUTO_TEST_CASE(another_program_is_noticed) {
  const Folder folder;
  RunContents contents = sample_contents();
  contents.program = "first";
  create(folder, contents).save({});
  BOOST_TEST(RunDirectory::resume(folder.path(), contents).by_this_program);
  contents.program = "second";
  BOOST_TEST(!RunDirectory::resume(folder.path(), contents).by_this_program);
}

/// Files that cannot be removed simulate a kill before their removal.
BOOST_AUTO_TEST_CASE(removing_a_run_begins_with_the_checkpoint_and_ends_with_the_steps) {
  const Folder folder;
  write(folder.at("checkpoint"), "of files that go");
  write(folder.at("steps.csv"), "of a run");
  for (const std::string name : {"animation.html", "bodies.pvd", "contacts.csv", "fields.pvd",
                                 "rheology.csv", "run.json", "trajectory.csv", "walls.csv"}) {
    std::filesystem::create_directories(folder.at(name) / "in the way");
  }
  BOOST_CHECK_EXCEPTION(
      RunDirectory::create(folder.path(), sample_contents(), ExistingRun::overwrite), RecordError,
      mentions(folder.path().string(), "removing"));
  BOOST_TEST(!std::filesystem::exists(folder.at("checkpoint")));
  BOOST_TEST(std::filesystem::exists(folder.at("steps.csv")));
}

BOOST_AUTO_TEST_CASE(resuming_drops_what_followed_the_checkpoint) {
  const Folder folder;
  const auto saved_files = [&] {
    RunDirectory run = create(folder);
    run.write_frame(sample_frame(0));
    run.write_step({.t = 0.1});
    run.save({.t = 0.1, .step = 1, .state = Eigen::Vector2d(1.0, 2.0), .history = {}});
    const auto files = read_all(folder.path());
    run.write_step({.t = 0.2});
    run.write_frame(sample_frame(1));
    run.write_frame(sample_frame(2));
    return files;
  }();
  write(folder.at("bodies_000003.vtp.partial"), "half");
  write(folder.at("contacts_000003.vtp.partial"), "half");
  write(folder.at("fields_000003.vti.partial"), "half");
  const ResumedRun run = RunDirectory::resume(folder.path(), sample_contents());
  BOOST_TEST(run.directory.frame_count() == 1u);
  BOOST_TEST(run.checkpoint.step == 1);
  BOOST_TEST(run.checkpoint.state == Eigen::VectorXd(Eigen::Vector2d(1.0, 2.0)));
  std::map<std::string, std::string> files = read_all(folder.path());
  // Pictures show the latest frame until the next frame is written.
  for (auto& [name, text] : files) {
    if (name.ends_with(".svg")) text = saved_files.at(name);
  }
  BOOST_TEST((files == saved_files));
}

// In a periodic cell, contacts.csv has two more columns.
BOOST_AUTO_TEST_CASE(contacts_with_images) {
  ContactForce contact{{false, 2}, {false, 0}, {0.5, 0.25}, 1.0, 3.0, 0.125};
  contact.image = {-1, 4};
  Frame frame{.t = 2.0, .bodies = {}, .walls = {}, .contacts = {contact}};
  BOOST_TEST(contact_rows(frame) == "2,body:2,body:0,0.5,0.25,1,0,3,0.125\n");
  frame.cell = FrameCell{{1.0, {0.0, 1.0}}, 0.0, {}};
  BOOST_TEST(contact_rows(frame) == "2,body:2,body:0,0.5,0.25,1,0,3,0.125,-1,4\n");
  const Folder folder;
  RunContents contents = sample_contents();
  contents.cell = true;
  create(folder, contents);
  BOOST_TEST(read(folder.at("contacts.csv")) == "t,a,b,x,y,nx,ny,force,gap,image_1,image_2\n");
}

BOOST_AUTO_TEST_CASE(contacts_are_cut_back_too) {
  const Folder folder;
  const auto rows = [&] {
    const std::string text = read(folder.at("contacts.csv"));
    return std::ranges::count(text, '\n') - 1;
  };
  {
    RunDirectory run = create(folder);
    run.write_frame(sample_frame(1));
    run.save({});
    BOOST_TEST(rows() == 1);
    run.write_frame(sample_frame(2));
  }
  BOOST_TEST(rows() == 3);
  RunDirectory run = RunDirectory::resume(folder.path(), sample_contents()).directory;
  BOOST_TEST(rows() == 1);
  BOOST_TEST(!std::filesystem::exists(folder.at("contacts_000001.vtp")));
  run.write_frame(sample_frame(2));
  run.save({});
  BOOST_TEST(rows() == 3);
  BOOST_TEST(std::filesystem::exists(folder.at("contacts_000001.vtp")));
}

BOOST_AUTO_TEST_CASE(resuming_without_frames_spares_foreign_files) {
  const Folder folder;
  create(folder).save({});
  write(folder.at("notes"), "mine");
  RunDirectory::resume(folder.path(), sample_contents());
  BOOST_TEST(read(folder.at("notes")) == "mine");
}

BOOST_AUTO_TEST_CASE(what_cannot_be_resumed) {
  const Folder folder;
  BOOST_CHECK_EXCEPTION(RunDirectory::resume(folder.path(), sample_contents()), RecordError,
                        mentions("checkpoint", "No such file"));
  create(folder).save({});
  RunContents other = sample_contents();
  other.scene += "# changed\n";
  BOOST_CHECK_EXCEPTION(RunDirectory::resume(folder.path(), other), RecordError,
                        mentions("checkpoint", "another scene"));
  write(folder.at("trajectory.csv"), "");
  BOOST_CHECK_EXCEPTION(RunDirectory::resume(folder.path(), sample_contents()), RecordError,
                        mentions("trajectory.csv", "has 0 bytes"));
}

BOOST_AUTO_TEST_CASE(a_changed_scene_may_add_files) {
  const Folder folder;
  RunContents contents = sample_contents();
  contents.vtk = contents.html = contents.fields = false;
  const auto frame = [](int k) {
    Frame sample = sample_frame(k);
    sample.field.reset();
    return sample;
  };
  {
    RunDirectory run = create(folder, contents);
    run.keep_checkpoint();  // there is none to keep
    BOOST_TEST(!std::filesystem::exists(folder.at(kept_checkpoint)));
    run.write_frame(frame(0));
    run.save({.t = 0.1, .state = {}, .history = {}});
    run.keep_checkpoint();
    run.write_frame(frame(1));
    run.save({.t = 0.2, .state = {}, .history = {}});
  }
  const std::string kept = read(folder.at(kept_checkpoint));
  const ChangedScene change{.before = contents.scene, .before_end = true};
  RunContents more = contents, fewer = contents, other = contents;
  more.scene = fewer.scene = other.scene = "another scene";
  more.vtk = more.html = true;
  fewer.csv = false;
  const auto resume = [&](const RunContents& changed, const ChangedScene& from) {
    return RunDirectory::resume(folder.path(), changed, from);
  };
  BOOST_CHECK_EXCEPTION(resume(fewer, change), RecordError, mentions("checkpoint", "other files"));
  BOOST_CHECK_EXCEPTION(resume(other, {.before = "a third scene"}), RecordError,
                        mentions("checkpoint", "another scene"));
  BOOST_TEST(resume(other, {.before = contents.scene}).directory.frame_count() == 2u);
  {
    ResumedRun resumed = resume(more, change);
    BOOST_TEST(resumed.checkpoint.t == 0.1);
    BOOST_TEST(resumed.directory.frame_count() == 1u);
    BOOST_TEST(read(folder.at("checkpoint")) == kept);  // a kill here is a kill before the change
    BOOST_TEST(!contains(read(folder.at("bodies.pvd")), "vtp"));
    resumed.directory.save(resumed.checkpoint);
    resumed.directory.write_frame(frame(1));
    resumed.directory.save({.t = 0.2, .state = {}, .history = {}});
  }
  BOOST_TEST(!contains(read(folder.at("bodies.pvd")), "bodies_000000.vtp"));
  BOOST_TEST(contains(read(folder.at("bodies.pvd")), "bodies_000001.vtp"));
  BOOST_TEST(RunDirectory::resume(folder.path(), more).checkpoint.t == 0.2);
}

// A checkpoint from another person may name any file, and its checksum can be recomputed.
BOOST_AUTO_TEST_CASE(files_of_others_are_left_alone) {
  const Folder folder, other;
  write_atomically(other.at("precious"), "text", SafeFrom::kill);
  {
    RunDirectory run = create(folder);
    run.write_frame(sample_frame(0));
    run.save({});
  }
  const SavedRun saved = read_saved_run(folder.at("checkpoint"));
  const auto resume = [&](const SavedRun& changed) {
    write_atomically(folder.at("checkpoint"), to_text(changed), SafeFrom::kill);
    RunDirectory::resume(folder.path(), sample_contents());
  };
  BOOST_CHECK_NO_THROW(resume(saved));
  for (const std::string& name :
       {other.at("precious").string(), "../" + other.at("precious").filename().string(),
        std::string("precious"), std::string("run.json")}) {
    SavedRun more = saved;
    more.table_sizes[name] = 0;
    BOOST_CHECK_EXCEPTION(resume(more), RecordError, mentions("checkpoint", "other files"));
  }
  SavedRun fewer = saved;
  fewer.table_sizes.erase("trajectory.csv");
  BOOST_CHECK_EXCEPTION(resume(fewer), RecordError, mentions("checkpoint", "other files"));
  std::filesystem::remove(folder.at("trajectory.csv"));
  std::filesystem::create_symlink(other.at("precious"), folder.at("trajectory.csv"));
  SavedRun cut = saved;
  cut.table_sizes["trajectory.csv"] = 0;
  BOOST_CHECK_EXCEPTION(resume(cut), RecordError, mentions("trajectory.csv", "symbolic link"));
  BOOST_TEST(read_text(other.at("precious")) == "text");
}

BOOST_AUTO_TEST_CASE(pipes_and_folders_are_no_files_of_a_run) {
  const Folder folder;
  BOOST_REQUIRE(::mkfifo(folder.at("pipe").c_str(), 0600) == 0);
  std::filesystem::create_directory(folder.at("folder"));
  BOOST_CHECK_EXCEPTION(AppendFile::reopen(folder.at("pipe"), 0), RecordError,
                        mentions("pipe", "not a regular file"));
  BOOST_CHECK_THROW(AppendFile::reopen(folder.at("folder"), 0), RecordError);
  BOOST_CHECK_THROW(read_text(folder.at("pipe")), RecordError);
  BOOST_CHECK_THROW(read_text(folder.at("folder")), RecordError);
}

BOOST_AUTO_TEST_CASE(places_that_cannot_be_written) {
  const Folder folder;
  write(folder.at("file"), "");
  BOOST_CHECK_EXCEPTION(
      RunDirectory::create(folder.at("file"), sample_contents(), ExistingRun::refuse), RecordError,
      mentions("file", "Not a directory"));
  BOOST_CHECK_THROW(
      RunDirectory::create(folder.at("file") / "x", sample_contents(), ExistingRun::refuse),
      RecordError);
  BOOST_CHECK_THROW(
      RunDirectory::create("/proc/stokesbook", sample_contents(), ExistingRun::refuse),
      RecordError);
}

BOOST_AUTO_TEST_CASE(files_of_frames_are_named_by_their_number) {
  BOOST_TEST(field_files.name(42) == "fields_000042.vti");
  BOOST_TEST(body_files.name(1234567) == "bodies_1234567.vtp");
  BOOST_TEST(body_files.collection() == "bodies.pvd");
  BOOST_TEST((field_files.frame_of("fields_000042.vti") == std::optional<std::size_t>(42)));
  BOOST_TEST((body_files.frame_of("bodies_1234567.vtp") == std::optional<std::size_t>(1234567)));
  for (const std::string name : {"fields_42.vti", "fields_000042.vtp", "bodies_000042.vti",
                                 "fields_000042.vti.old", "fields.vti", "fields_00004x.vti", ""}) {
    BOOST_TEST(!field_files.frame_of(name), name);
  }
}

BOOST_AUTO_TEST_CASE(a_field_is_written_if_it_is_asked_for_and_only_then) {
  const Folder folder;
  RunContents contents = sample_contents();
  Frame frame = sample_frame(0);
  frame.field.reset();
  BOOST_CHECK_THROW(create(folder, contents).write_frame(frame), std::invalid_argument);
  contents.fields = false;
  RunDirectory run = RunDirectory::create(folder.path(), contents, ExistingRun::overwrite);
  BOOST_CHECK_THROW(run.write_frame(sample_frame(0)), std::invalid_argument);
  BOOST_TEST(run.frame_count() == 0u);
}

BOOST_AUTO_TEST_CASE(contacts_are_of_what_the_frame_has_where_they_are_asked_for) {
  const Folder folder;
  RunContents contents = sample_contents();
  for (const ContactParty missing :
       {ContactParty{.is_wall = false, .number = 2}, ContactParty{.is_wall = true, .number = 2}}) {
    Frame frame = sample_frame(1);
    frame.contacts[0].b = missing;
    RunDirectory run = RunDirectory::create(folder.path(), contents, ExistingRun::overwrite);
    BOOST_CHECK_THROW(run.write_frame(frame), std::invalid_argument);
    BOOST_TEST(run.frame_count() == 0u);
  }
  contents.contacts = false;
  RunDirectory run = RunDirectory::create(folder.path(), contents, ExistingRun::overwrite);
  run.write_frame(sample_frame(0));
  BOOST_CHECK_THROW(run.write_frame(sample_frame(1)), std::invalid_argument);
  BOOST_TEST(run.frame_count() == 1u);
}

BOOST_AUTO_TEST_CASE(a_frame_of_other_bodies_is_refused) {
  const Folder folder;
  RunDirectory run = create(folder);
  Frame frame = sample_frame(0);
  frame.bodies.pop_back();
  BOOST_CHECK_THROW(run.write_frame(frame), std::invalid_argument);
  BOOST_TEST(run.frame_count() == 0u);
}

BOOST_AUTO_TEST_SUITE_END()
