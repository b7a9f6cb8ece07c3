#include <fstream>
#include <iostream>

#include <nipref/verify/cli/verbs.hpp>

/// Writes the manual's page and bash's completion into the files that are named; run by the build alone.
int main(int argc, char** argv) {
  if (argc != 3) {
    std::cerr << "usage: nipref_manual PAGE COMPLETION\n";
    return 2;
  }
  std::ofstream page(argv[1]), completion(argv[2]);
  page << nipref::verify::manual_page();
  completion << nipref::verify::bash_completion();
  page.close();
  completion.close();
  return page && completion ? 0 : 1;
}
