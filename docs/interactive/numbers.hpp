#pragma once

#include <string>
#include <utility>
#include <vector>

// The numbers of the interactive figures, computed by the libraries: a function for each figure.
namespace interactive {

using Numbers = std::vector<std::pair<std::string, double>>;

// Settings of a figure, and the numbers that the figure shows for them. The names are those of its script.
struct Case {
  Numbers settings, numbers;
};

std::vector<Case> bearing();
std::vector<Case> close();
std::vector<Case> disks();
std::vector<Case> fmm();
std::vector<Case> gmres();
std::vector<Case> mistake();
std::vector<Case> mobility();
std::vector<Case> pole();
std::vector<Case> preimage();
std::vector<Case> push();

}  // namespace interactive
