#include <fstream>
#include <nipref_build_info.hpp>
#include <thread>

#include <nipref/data/input_file.hpp>
#include <nipref/fast/sheet/instruction_set.hpp>
#include <nipref/verify/cli/output.hpp>
#include <nipref/verify/golden/make.hpp>
#include <nipref/verify/support/sha256.hpp>

namespace nipref::verify {
namespace {

/// The processor's name under Linux; elsewhere nothing.
std::optional<std::string> processor_name() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);) {
    if (!line.starts_with("model name")) continue;
    const std::size_t colon = line.find(": ");
    if (colon != std::string::npos) return line.substr(colon + 2);
  }
  return std::nullopt;
}

/// The number of cores; nothing if the system does not say.
std::optional<unsigned> cores() {
  const unsigned count = std::thread::hardware_concurrency();
  return count == 0 ? std::nullopt : std::optional(count);
}

Json known(std::string_view text) { return text == "unknown" ? Json() : Json::unless_empty(text); }

Json libraries_json() {
  Json libraries = Json::object();
  for (const auto& [name, version] : build_info::libraries) libraries.set(name, known(version));
  return libraries;
}

}  // namespace

std::string compiler() { return std::string(build_info::compiler); }

Provenance provenance() {
  constexpr std::string_view mark = "-dirty";
  std::string commit(build_info::commit);
  const bool dirty = commit.ends_with(mark);
  if (dirty) commit.resize(commit.size() - mark.size());
  const auto mpfr =
      std::ranges::find(build_info::libraries, "MPFR", [](const auto& library) { return library.first; });
  return {std::string(build_info::version), compiler(), std::string(mpfr->second), commit,
          !dirty && commit != "unknown"};
}

Json version_json() {
  return {{"version", build_info::version},
          {"commit", known(build_info::commit)},
          {"commit_date", known(build_info::commit_date)},
          {"compiler", build_info::compiler},
          {"build_type", known(build_info::build_type)},
          {"libraries", libraries_json()},
          {"instruction_set", fast::instruction_set()},
          {"processor", processor_name()},
          {"cores", cores()}};
}

Json program_json() {
  Json program = version_json().without("processor").without("cores");
  program.set("sha256", sha256(data::text_of_input_file("/proc/self/exe", "program")));
  return program;
}

}  // namespace nipref::verify
