// Prints the numbers of the interactive figures, computed by the libraries: a line of JSON for each case.
#include "interactive/numbers.hpp"

#include <cstdio>

namespace {

void print(const char* name, const interactive::Numbers& numbers) {
  std::printf(", \"%s\": {", name);
  const char* separator = "";
  for (const auto& [key, value] : numbers) {
    std::printf("%s\"%s\": %.17g", separator, key.c_str(), value);
    separator = ", ";
  }
  std::printf("}");
}

void print_cases(const char* figure, const std::vector<interactive::Case>& cases) {
  for (const auto& [settings, numbers] : cases) {
    std::printf("{\"figure\": \"%s\"", figure);
    print("settings", settings);
    print("numbers", numbers);
    std::printf("}\n");
  }
}

}  // namespace

int main() {
  print_cases("bearing", interactive::bearing());
  print_cases("close", interactive::close());
  print_cases("disks", interactive::disks());
  print_cases("fmm", interactive::fmm());
  print_cases("gmres", interactive::gmres());
  print_cases("mistake", interactive::mistake());
  print_cases("mobility", interactive::mobility());
  print_cases("pole", interactive::pole());
  print_cases("preimage", interactive::preimage());
  print_cases("push", interactive::push());
}
