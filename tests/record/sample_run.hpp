#pragma once

#include <filesystem>
#include <string>

#include "record/run_directory.hpp"

namespace stokesbook::test {

/// Returns an ellipse and a concave star between a round outer wall and an inner wall.
/// read_outputs.py contains the same numbers.
RunContents sample_contents();

/// Returns the sample at the k-th written time, with k mod 3 contacts.
Frame sample_frame(int k);

/// Returns whether a text contains a part.
bool contains(const std::string& text, const std::string& part);

/// Runs a chaotic map, so that a resumed run that lost one bit would end elsewhere.
///
/// Continues from the checkpoint in the directory or, without one, starts afresh. The run writes a
/// frame every 2 steps and a checkpoint every 3.
/// @param  last_step  step after which the run stops
/// @return whether there was a checkpoint
bool run_or_resume(const std::filesystem::path& directory, const RunContents& contents,
                   int last_step);

}  // namespace stokesbook::test
