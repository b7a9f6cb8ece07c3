#include <algorithm>
#include <map>
#include <sstream>

#include <nipref/data/bad_input.hpp>
#include <nipref/verify/cli/changed.hpp>
#include <nipref/verify/cli/output_of.hpp>

namespace nipref::verify {
namespace {

using Subjects = std::set<std::string>;

const Subjects everything{"sheet",       "memory",           "half_space", "material",
                          "elastic_nip", "viscoelastic_nip", "contacts"};

/// What is computed from a subject of ref or fast.
const std::map<std::string, Subjects> users{
    {"sheet", {"sheet", "memory", "elastic_nip", "viscoelastic_nip", "contacts"}},
    {"memory", {"memory", "viscoelastic_nip", "contacts"}},
    {"half_space", {"half_space", "contacts"}},
    {"material", {"material"}},
    {"nip", {"elastic_nip", "viscoelastic_nip", "contacts"}},
    {"elastic_nip", {"elastic_nip", "contacts"}},
    {"viscoelastic_nip", {"viscoelastic_nip", "contacts"}}};

std::vector<std::string> parts_of(const std::string& path) {
  std::vector<std::string> parts;
  std::istringstream text(path);
  for (std::string part; std::getline(text, part, '/');) parts.push_back(part);
  return parts;
}

Subjects touched_by(const std::string& file) {
  const std::vector<std::string> parts = parts_of(file);
  const auto part = [&](std::size_t i) { return i < parts.size() ? parts[i] : ""; };
  const std::string& room = parts.front();
  if (room == "verify") {
    if (part(1) != "catalogue") return part(1) == "solve" ? Subjects{"contacts"} : Subjects{};
    return users.contains(part(2)) ? Subjects{part(2)} : everything;
  }
  if (room == "ref" || room == "fast") {
    const auto found = users.find(part(1));
    return found == users.end() ? everything : found->second;  // numbers, and how they are compiled
  }
  if (room == "data")
    return part(1) == "material" || part(1) == "problem" || part(1) == "scene" ? Subjects{"contacts"}
                                                                               : Subjects{};
  return file == "CMakeLists.txt" ? everything : Subjects{};
}

/// Lines that git prints.
std::vector<std::string> lines_of_git(std::vector<std::string> words, const std::string& revision) {
  words.insert(words.begin(), "git");
  const ProgramOutput output = output_of(words);
  if (output.status != 0)
    throw data::BadInput("since", revision, "must be a revision that git knows in the current folder");
  std::vector<std::string> lines;
  std::istringstream stream(output.text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

}  // namespace

std::vector<std::string> changed_files(const std::string& revision) {
  std::vector<std::string> files =
      lines_of_git({"diff", "--name-only", "--no-renames", "--end-of-options", revision}, revision);
  std::ranges::copy(
      lines_of_git({"ls-files", "--others", "--exclude-standard", "--full-name", "--", ":/"}, revision),
      std::back_inserter(files));
  return files;
}

std::set<std::string> touched_subjects(const std::vector<std::string>& files) {
  Subjects touched;
  for (const std::string& file : files) touched.merge(touched_by(file));
  return touched;
}

}  // namespace nipref::verify
