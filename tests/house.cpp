#include <cctype>

#include <nipref/verify/cli/house.hpp>

#include "support/proven_pages.hpp"

// The order of the sources: which room, and inside a room which subject, may include which others; and that the same
// path means the same in ref, fast, the catalogue and the tests.

namespace fs = std::filesystem;

namespace {

using Names = std::set<std::string>;
using nipref::verify::room_arrows, nipref::verify::subject_arrows;

const fs::path top = source_directory();

Names named(const std::vector<std::string>& matches) { return {matches.begin(), matches.end()}; }

/// The place of a source: "fast/sheet/internal/tables.hpp" is in the room fast and has the subject sheet.
struct Place {
  std::string room, subject;
  bool internal;

  explicit Place(const std::string& path) {
    const std::vector<std::string> parts = parts_of(path);
    room = parts.front();
    subject = parts.size() > 2 && parts[1] != "internal" ? parts[1] : "";
    internal = std::ranges::find(parts, "internal") != parts.end();
  }

  static std::vector<std::string> parts_of(const fs::path& path) { return {path.begin(), path.end()}; }
};

/// Whether a file at `from` may include the header at `to`, both as paths from the top.
bool may_include(const std::string& from, const std::string& to) {
  const Place here(from), there(to);
  if (here.room != there.room) return room_arrows().at(here.room).contains(there.room) && !there.internal;
  if (here.subject == there.subject) return true;
  return subject_arrows().at(here.room).at(here.subject).contains(there.subject);
}

/// The sources in a folder, as paths from the top.
std::vector<std::string> sources_in(const fs::path& folder) {
  std::vector<std::string> sources;
  for (const auto& entry : fs::recursive_directory_iterator(top / folder)) {
    const fs::path extension = entry.path().extension();
    if (extension == ".hpp" || extension == ".cpp")
      sources.push_back(fs::relative(entry.path(), top).string());
  }
  std::ranges::sort(sources);
  return sources;
}

/// The project's headers that a source includes, as paths from the top.
Names headers_of(const std::string& source) {
  return named(
      matches_in(text_of_file(top / source),
                 R"re(#\s*include\s*["<](?:\.\./)*(?:nipref/)?((?:data|ref|fast|verify)/[^">]+)[">])re"));
}

/// The public sources of a room's subjects, such as "sheet/kernels".
Names subjects_of(const fs::path& room) {
  Names subjects;
  for (const std::string& source : sources_in(room)) {
    const fs::path path = fs::relative(fs::path(source), room);
    if (Place(source).internal || std::distance(path.begin(), path.end()) != 2) continue;
    subjects.insert(fs::path(path).replace_extension().string());
  }
  return subjects;
}

/// The types that a source defines for all sources, with their namespaces, such as "nipref::fast::Estimate".
/// Specializations of templates are left out.
Names types_of(const std::string& source) {
  static const std::regex line(
      R"(^(?:namespace ([\w:]*) ?\{|(\})  // namespace)"
      R"(|(?:struct|class|union|enum(?: class)?) (\w+)\b(?!::|<)[^;]*\{|using (\w+) =))");
  std::istringstream text(text_of_file(top / source));
  std::vector<std::string> spaces;
  Names types;
  for (std::string written; std::getline(text, written);) {
    std::smatch found;
    if (!std::regex_search(written, found, line)) continue;
    if (found[2].matched) {
      spaces.pop_back();
    } else if (found[1].matched) {
      spaces.push_back(found[1]);
    } else if (std::ranges::find(spaces, "") == spaces.end()) {
      std::string name;
      for (const std::string& space : spaces) name += space + "::";
      types.insert(name + found[3].str() + found[4].str());
    }
  }
  return types;
}

}  // namespace

TEST_CASE("every include follows the arrows of the rooms and of the subjects in them") {
  std::size_t files = 0, includes = 0;
  for (const auto& [room, arrows] : room_arrows()) {
    for (const std::string& source : sources_in(room)) {
      ++files;
      for (const std::string& header : headers_of(source)) {
        ++includes;
        CAPTURE(source, header);
        CHECK(fs::exists(top / header));
        CHECK(may_include(source, header));
      }
    }
  }
  CHECK(files > 300);
  CHECK(includes > 800);
}

TEST_CASE("an include against the arrows is seen") {
  CHECK_FALSE(may_include("ref/sheet/kernels.cpp", "fast/sheet/kernels.hpp"));
  CHECK_FALSE(may_include("fast/sheet/kernels.cpp", "ref/sheet/kernels.hpp"));
  CHECK_FALSE(may_include("data/scene/file.cpp", "fast/sheet/kernels.hpp"));
  CHECK_FALSE(may_include("fast/number/accuracy.hpp", "fast/sheet/kernels.hpp"));
  CHECK_FALSE(may_include("ref/sheet/kernels.cpp", "ref/memory/convolutions.hpp"));
  CHECK_FALSE(may_include("fast/memory/moving_load.cpp", "fast/nip/work.hpp"));
  CHECK_FALSE(may_include("fast/elastic_nip/converged.cpp", "fast/viscoelastic_nip/converged.hpp"));
  CHECK_FALSE(may_include("fast/half_space/sliding.cpp", "fast/nip/work.hpp"));
  CHECK_FALSE(may_include("fast/sheet/internal/tables.hpp", "fast/half_space/response.hpp"));
  CHECK_FALSE(may_include("verify/catalogue/deviation.cpp", "verify/audit/audit.hpp"));
  CHECK_FALSE(may_include("verify/cli/machine.cpp", "fast/sheet/internal/dispatch.hpp"));
  CHECK(may_include("fast/elastic_nip/converged.cpp", "fast/sheet/internal/tables.hpp"));
  CHECK(may_include("verify/cli/eval.cpp", "ref/sheet/kernels.hpp"));
}

TEST_CASE("the README's tables of rooms and subjects are the arrows of the house") {
  static const std::regex row(R"re(\n\| ((?:`\w+`(?:, )?)+) \|[^|\n]*\|([^|\n]*)\|)re");
  const std::string readme = text_of_file(top / "README.md");
  const std::size_t begin = readme.find("\n| room | what"), end = readme.find("How the numbers come about");
  REQUIRE(begin < end);
  const std::string tables = readme.substr(begin, end - begin);
  nipref::verify::Arrows written;
  for (std::sregex_iterator it(tables.begin(), tables.end(), row), last; it != last; ++it) {
    for (const std::string& key : names_in((*it)[1])) written[key] = named(names_in((*it)[2]));
  }
  nipref::verify::Arrows arrows = room_arrows();
  for (const char* const room : {"ref", "fast"}) {
    for (const auto& [subject, included] : subject_arrows().at(room))
      arrows[subject].insert(included.begin(), included.end());
  }
  written.erase("tests");  // no room that others include
  CHECK(written == arrows);
}

TEST_CASE("no two sources define types of one name in one namespace") {
  std::map<std::string, std::string> defined_in;
  for (const auto& [room, arrows] : room_arrows()) {
    for (const std::string& source : sources_in(room)) {
      for (const std::string& type : types_of(source)) {
        const auto [first, is_new] = defined_in.emplace(type, source);
        CAPTURE(type, source, first->second);
        CHECK(is_new);
      }
    }
  }
  CHECK(defined_in.at("nipref::data::BadInput") == "data/bad_input.hpp");
  CHECK(defined_in.size() > 300);
}

TEST_CASE("no source includes by a path that a user's own folders could answer") {
  static const std::regex bare(R"re(#\s*include\s*["<](?:\.\./)*(?:data|ref|fast|verify|tests)/)re");
  for (const char* const room : {"data", "ref", "fast", "verify", "tests"}) {
    for (const std::string& source : sources_in(room)) {
      if (source == "tests/house.cpp") continue;
      CAPTURE(source);
      CHECK_FALSE(std::regex_search(text_of_file(top / source), bare));
    }
  }
}

TEST_CASE("file names in comments are those of files") {
  std::vector<std::string> files;
  for (const char* const room : {"data", "ref", "fast", "verify", "tests"}) {
    for (const std::string& source : sources_in(room)) files.push_back("/" + source);
  }
  for (const std::string& source : files) {
    for (const std::string& written :
         matches_in(text_of_file(top / source.substr(1)), R"(//[^\n]*?([\w/]+\.[ch]pp)\b)")) {
      const std::string prefix = "nipref/";
      const std::string name = "/" + (written.starts_with(prefix) ? written.substr(prefix.size()) : written);
      CAPTURE(source, name);
      CHECK(std::ranges::any_of(files, [&](const std::string& file) { return file.ends_with(name); }));
    }
  }
}

TEST_CASE("what the pages of ref point to exists: files, sections, lemmas, and tests by their names") {
  static const std::regex link(R"(\[([^\]]+)\]\(([^)#]*)(?:#([^)]*))?\))");
  const auto anchors_of = [](const std::string& page) {
    Names anchors;
    for (const std::string& heading : matches_in(page, R"(\n##+ ([^\n]+))")) {
      std::string anchor;
      for (const char c : heading) {
        if (std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '-')
          anchor += static_cast<char>(std::tolower(c));
        if (c == ' ') anchor += '-';
      }
      anchors.insert(anchor);
    }
    return anchors;
  };
  const std::string general = text_of_file(top / "ref/README.md");
  int tests = 0;
  for (const auto& entry : fs::recursive_directory_iterator(top / "ref")) {
    const fs::path file = entry.path();
    if (file.filename() != "README.md") continue;
    CAPTURE(file);
    const std::string page = text_of_file(file);
    for (std::sregex_iterator it(page.begin(), page.end(), link), end; it != end; ++it) {
      const std::string text = (*it)[1], path = (*it)[2], section = (*it)[3];
      CAPTURE(text);
      const fs::path target = path.empty() ? file : (file.parent_path() / path).lexically_normal();
      REQUIRE(fs::exists(target));
      if (!section.empty()) CHECK(anchors_of(text_of_file(target)).contains(section));
      if (!contains(path, "../tests/")) continue;
      CHECK(text_of_file(target).find('"' + text + "\")") != std::string::npos);
      ++tests;
    }
    for (const std::string& lemma : matches_in(page, R"(Lemmas? (\d+))"))
      CHECK(contains(general, "### Lemma " + lemma + "."));
    // Every section of a subject's page says which test recomputes its statements.
    for (std::size_t at = page.find("\n## "); file.parent_path() != top / "ref" && at != std::string::npos;) {
      const std::size_t next = page.find("\n## ", at + 1);
      const std::string section = page.substr(at, next - at);
      CAPTURE(section.substr(0, section.find('\n', 1)));
      CHECK(contains(section, "../../tests/"));
      at = next;
    }
  }
  CHECK(tests > 60);
}

TEST_CASE("ref and fast mirror each other: the same path is the same thing, computed by either") {
  const Names ref = subjects_of("ref"), fast = subjects_of("fast");
  Names both;
  std::ranges::set_intersection(ref, fast, std::inserter(both, both.end()));
  // The kernels and the quantities made of them have the same name in the catalogue.
  for (const std::string& subject : subjects_of("verify/catalogue")) {
    CAPTURE(subject);
    if (subject.starts_with("sheet/") || subject.starts_with("memory/")) CHECK(both.contains(subject));
  }
  for (const std::string subject :
       {"sheet/kernels", "sheet/roots", "sheet/displacements", "memory/convolutions", "memory/moving_load",
        "material/rational_solid", "elastic_nip/converged", "elastic_nip/line_loads", "nip/line_loads",
        "half_space/response", "half_space/sliding", "half_space/rolling_sphere", "half_space/elliptic"}) {
    CAPTURE(subject);
    CHECK(both.contains(subject));
  }
}

TEST_CASE("a test stands where the code that it tests stands") {
  for (const char* const room : {"data", "ref", "fast", "verify"}) {
    const std::vector<std::string> code = sources_in(room);
    for (const std::string& source : sources_in(fs::path("tests") / room)) {
      const fs::path tested = fs::relative(source, "tests");
      const auto is_tested = [&](const fs::path& candidate) {
        std::string folder = candidate.parent_path().string();
        if (folder.ends_with("/internal")) folder.resize(folder.size() - std::string("/internal").size());
        const std::string name = candidate.stem().string(), test = tested.stem().string();
        return folder == tested.parent_path().string() && (test == name || test.starts_with(name + "_"));
      };
      CAPTURE(source);
      CHECK(std::ranges::any_of(code, is_tested));
    }
  }
}

TEST_CASE("the top level holds what the design names and nothing else, and rooms hold folders") {
  const Names named{"CMakeLists.txt", "README.md", "data", "ref", "fast", "verify", "tests", "build"};
  for (const auto& entry : fs::directory_iterator(top)) {
    const std::string name = entry.path().filename().string();
    CAPTURE(name);
    CHECK((name.front() == '.' || named.contains(name)));
  }
  for (const char* const room : {"ref", "fast", "verify"}) {
    for (const auto& entry : fs::directory_iterator(top / room)) {
      const std::string name = entry.path().filename().string();
      CAPTURE(room, name);
      CHECK((entry.is_directory() || name == "CMakeLists.txt" || name == "README.md" || name == "run"));
    }
  }
}

TEST_CASE("the example of the README is the one that is built as a test") {
  const std::string example = text_of_file(top / "tests/consumer/main.cpp");
  CHECK(contains(text_of_file(top / "README.md"), "```cpp\n" + example + "```"));
}

TEST_CASE("the README says what may be done with this: nothing is said by a licence yet") {
  CHECK(contains(text_of_file(top / "README.md"), "No licence has been chosen by the owner yet."));
}
