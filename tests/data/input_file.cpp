#include <unistd.h>

#include <nipref/data/input_file.hpp>

#include "support/scratch.hpp"

using namespace nipref;

namespace {

std::string refusal_of_input(const std::string& path) {
  return refusal_of([&] { return data::open_input_file(path, "scene"); });
}

}  // namespace

TEST_CASE("a file that is missing, a folder, and a file that may not be read are told apart") {
  CHECK(refusal_of_input("/nowhere/x") ==
        "scene = /nowhere/x: must be a file that exists: there is none of that name");
  CHECK(refusal_of_input("/") == "scene = /: must be a file: this is a folder");
  const ScratchFile file("text");
  CHECK(refusal_of_input(file.path() + "/x")
            .ends_with("must be a file that exists: there is none of that name"));
  CHECK(refusal_of_input(std::string(300, 'a'))
            .ends_with("must be a file that can be read: File name too long"));
  std::filesystem::permissions(file.path(), std::filesystem::perms::none);
  // Root may read every file.
  CHECK(refusal_of_input(file.path()) ==
        (geteuid() == 0 ? "accepted"
                        : "scene = " + file.path() + ": must be a file that can be read: Permission denied"));
}

TEST_CASE("an input file is given whole, empty or with any bytes in it") {
  for (const std::string& text : {std::string(), std::string("a\r\n\0b", 5)})
    CHECK(data::text_of_input_file(ScratchFile(text).path(), "file") == text);
}
