#include <nipref/verify/cli/house.hpp>
#include <nipref/verify/support/internal/process.hpp>
#include <nipref/verify/support/internal/toml_table.hpp>
#include <nipref/verify/support/text.hpp>

namespace nipref::verify {
namespace {

using Subjects = std::set<std::string>;

/// house.toml, whose text is put here by the build.
const TomlTable& house() {
  static const TomlTable all = parse_toml(
#include <nipref_house.inc>
      , "house", "house.toml");
  return all;
}

Arrows arrows_in(const TomlTable& table) {
  Arrows arrows;
  for (const auto& [name, included] : table.words) arrows[name] = {included.begin(), included.end()};
  return arrows;
}

const Subjects in_catalogue{"sheet", "memory", "half_space", "material", "elastic_nip", "viscoelastic_nip"};

/// The subjects of the catalogue, with "contacts", that are computed from a subject of ref or fast.
Subjects users_of(const std::string& room, const std::string& subject) {
  Subjects users{subject};
  for (std::size_t before = 0; before != users.size();) {
    before = users.size();
    for (const auto& [user, included] : subject_arrows().at(room)) {
      if (std::ranges::any_of(included, [&](const auto& used) { return users.contains(used); }))
        users.insert(user);
    }
  }
  const bool in_contacts = std::ranges::any_of(std::array{"elastic_nip", "viscoelastic_nip", "half_space"},
                                               [&](auto user) { return users.contains(user); });
  std::erase_if(users, [](const std::string& user) { return !in_catalogue.contains(user); });
  if (in_contacts) users.insert("contacts");
  return users;
}

Subjects everything() { return users_of("ref", "number"); }

Subjects touched_by(const std::string& file) {
  const std::vector<std::string> parts = parts_of(file, "/");
  const auto part = [&](std::size_t i) { return i < parts.size() ? parts[i] : ""; };
  const std::string& room = parts.front();
  if (room == "verify") {
    if (part(1) != "catalogue") return part(1) == "solve" ? Subjects{"contacts"} : Subjects{};
    return in_catalogue.contains(part(2)) ? Subjects{part(2)} : everything();
  }
  if (room == "ref" || room == "fast") {
    const bool is_subject = subject_arrows().at(room).contains(part(1));  // else how the room is compiled
    return is_subject ? users_of(room, part(1)) : everything();
  }
  if (room == "data")
    return part(1) == "material" || part(1) == "problem" || part(1) == "scene" ? Subjects{"contacts"}
                                                                               : Subjects{};
  return file == "CMakeLists.txt" ? everything() : Subjects{};
}

/// The lines that a git command prints.
std::vector<std::string> lines_of_git(std::vector<std::string> words, const std::string& revision) {
  words.insert(words.begin(), "git");
  const ProgramOutput output = output_of(words);
  if (output.status != 0)
    throw data::BadInput("since", revision, "must be a revision that git knows in the current folder");
  return parts_of(output.text, "\n");
}

}  // namespace

const Arrows& room_arrows() {
  static const Arrows arrows = arrows_in(house().table("rooms"));
  return arrows;
}

const std::map<std::string, Arrows>& subject_arrows() {
  static const std::map<std::string, Arrows> arrows = [] {
    std::map<std::string, Arrows> of_rooms;
    for (const auto& [room, subjects] : house().table("subjects").tables)
      of_rooms[room] = arrows_in(subjects.front());
    return of_rooms;
  }();
  return arrows;
}

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
