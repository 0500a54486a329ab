// Reads the name of the processor from Linux's /proc/cpuinfo.
#include <fstream>

#include "cli/build_info.hpp"

namespace stokesbook {

std::string machine_name() {
  std::ifstream processors("/proc/cpuinfo");
  for (std::string line; std::getline(processors, line);) {
    if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
  }
  return "unknown";
}

}  // namespace stokesbook
