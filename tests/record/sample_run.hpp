#pragma once

#include <filesystem>
#include <string>

#include "record/run_directory.hpp"

namespace stokesbook::test {

/// An ellipse and a concave star between a round outer wall and an inner wall. read_outputs.py
/// knows these numbers too.
RunContents sample_contents();

/// The sample at the k-th written time, with k mod 3 contacts.
Frame sample_frame(int k);

/// Whether a text has this part.
bool contains(const std::string& text, const std::string& part);

/// A run of a chaotic map, so that a resumed run which forgot one bit would end elsewhere.
///
/// Goes on from the checkpoint in the directory or, without one, starts afresh.
/// @param  last_step  after which the run stops; it writes a frame every 2 and a checkpoint every 3
/// steps
/// @return whether there was a checkpoint
bool run_or_resume(const std::filesystem::path& directory, const RunContents& contents,
                   int last_step);

}  // namespace stokesbook::test
