#include <fmt/format.h>

#include <nipref/data/scene/file.hpp>
#include <nipref/verify/cli/command_line.hpp>
#include <nipref/verify/cli/output.hpp>
#include <nipref/verify/cli/verbs.hpp>
#include <nipref/verify/solve/energy_balance.hpp>
#include <nipref/verify/solve/render.hpp>
#include <nipref/verify/support/internal/number_text.hpp>
#include <nipref/verify/support/text.hpp>

namespace nipref::verify {
namespace {

std::string balance_text(const EnergyBalance& balance) {
  return folded(fmt::format(
      "{}\n{}\n{}  work W mu_R  {:.16g}\n  loss         {:.16g}\n  difference {:.1e}, errors {}; force per unit "
      "width\n{:.2g} s\n",
      balance.title,
      verdict(balance.meets(), balance.meets() ? "they meet" : "they differ by more than their errors"),
      warnings_text(balance.warnings), balance.work.value, balance.loss.value, balance.difference(),
      upward_text(balance.allowed()), balance.seconds));
}

Json estimate_json(const fast::Estimate& number) {
  return {{"value", number.value}, {"error", number.error}, {"proven", false}};
}

Json balance_json(const EnergyBalance& balance, const std::string& path) {
  return {{"title", balance.title},
          {"path", path},
          {"work", estimate_json(balance.work)},
          {"loss", estimate_json(balance.loss)},
          {"warnings", warnings_json(balance.warnings)},
          {"difference", balance.difference()},
          {"allowed", balance.allowed()},
          {"met", balance.meets()},
          {"times", {{"seconds", balance.seconds}}}};
}

}  // namespace

int balance_verb(const CommandLine& line, std::ostream& out) {
  const SceneRequest request = scene_request(line);
  const EnergyBalance balance =
      energy_balance(data::load_scene(request.scene, line.assignments), request.digits);
  out << (line.json
              ? answer_text("balance", balance_json(balance, request.digits ? "ref" : "fast"), line.no_times)
              : balance_text(balance));
  return balance.meets() ? 0 : 1;
}

}  // namespace nipref::verify
