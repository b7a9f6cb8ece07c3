#include <nipref/data/directory.hpp>
#include <nipref/data/scene/file.hpp>
#include <nipref/verify/golden/confirm/confirm.hpp>
#include <nipref/verify/golden/contacts.hpp>
#include <nipref/verify/solve/solve.hpp>
#include <nipref/verify/support/internal/parallel.hpp>

namespace nipref::verify {
namespace {

namespace fs = std::filesystem;
using data::BadInput;
using ByRef = SceneSolution<ref::Estimate>;

constexpr std::string_view prefix = "contacts-";
constexpr std::size_t nips_for_each_confirmed = 10;
constexpr std::size_t axis_points = 100;  ///< for each range in a kind's sweep

/// The size of a result against which its error is measured.
template <class Number>
long double size_of(const SceneSolution<Number>& solution, std::size_t result) {
  return solution.results[result].allowed.front() / solution.accuracy;
}

long double as_real(const ref::Float& x) { return mpfr_get_ld(ref::raw(x), MPFR_RNDU); }

SecondSolution by_fast(const data::Scene& scene) {
  SecondSolution solution{"fast", {}};
  for (const auto& result : solve(scene).results) {
    const auto& [value, error] = result.numbers.front();
    solution.numbers.emplace_back(result.what->id,
                                  ref::Estimate(ref::Float(value), ref::Float(error), contact_digits));
  }
  return solution;
}

/// A contact of the sweep, from its keys to its confirmed results.
struct UnmadeContact {
  Assignments keys;
  std::optional<data::Scene> scene;
  ByRef reference;
  std::string confirmed_by, refused;

  /// Compares the results with those of another method: notes how closely it confirms them, or which it contradicts.
  void take(const SecondSolution& other, bool names_results) {
    std::string of, contradicted;
    long double open = 0;
    for (std::size_t i = 0; i < reference.results.size(); ++i) {
      for (const auto& [id, number] : other.numbers) {
        if (id != reference.results[i].what->id) continue;
        const std::string_view name = reference.results[i].what->name;
        const Gap gap(reference.results[i].numbers.front(), number);
        const long double distance = as_real(gap.distance) + as_real(number.error);
        if (!gap.is_covered()) contradicted += fmt::format(" {} by {:.1e}", name, as_real(gap.distance));
        if (distance > 0) open = std::max(open, distance / size_of(reference, i));
        of += fmt::format(" {}", name);
      }
    }
    const std::string method = names_results ? fmt::format("{} for{}", other.method, of) : other.method;
    if (!contradicted.empty()) {
      refused = fmt::format("{} differs:{}", method, contradicted);
    } else {
      confirmed_by += fmt::format("{}{} to {:.1e}", confirmed_by.empty() ? "" : "; ", method, open);
    }
  }

  void solve(const data::SceneText& text, int digits) {
    try {
      scene = data::load_scene(text, keys);
      reference = solve_by_ref(*scene, digits);
      if (reference.met() == true) {
        take(by_fast(*scene), false);
      } else {
        refused = "the reference is less accurate than that: " + std::string(reference.missed().front());
      }
    } catch (const BadInput& error) {
      refused = error.what();
    }
  }
  [[nodiscard]] GoldenRow row() const {
    GoldenRow row{{}, keys, {}, true, confirmed_by};
    for (const auto& result : reference.results) {
      const ref::Estimate& number = result.numbers.front();
      row.numbers.push_back({number.value_text(), bound_text(number)});
      row.proven = row.proven && number.proven;
    }
    return row;
  }
};

/// Chooses contacts to confirm by a second method: all that it covers on half-spaces, a tenth of the sweep for nips.
std::vector<UnmadeContact*> to_be_confirmed(std::vector<UnmadeContact>& contacts) {
  std::vector<UnmadeContact*> reached, taken;
  for (UnmadeContact& contact : contacts)
    if (contact.refused.empty() && second_solver(*contact.scene)) reached.push_back(&contact);
  if (reached.empty() || reached.front()->scene->kind() == data::SceneKind::half_space) return reached;
  const std::size_t wanted =
      std::min(reached.size(), (contacts.size() + nips_for_each_confirmed - 1) / nips_for_each_confirmed);
  for (std::size_t i = 0; i < reached.size(); ++i)
    if (is_taken(i, reached.size(), wanted)) taken.push_back(reached[i]);
  return taken;
}

std::vector<GoldenFailure> check_contact(const data::SceneText& text, const GoldenFile& file,
                                         std::size_t number, bool by_ref) {
  const GoldenRow& row = file.rows[number - 1];
  std::vector<GoldenFailure> failures;
  const auto fail = [&](GoldenFault fault, std::string_view name, const std::string& what) {
    std::string at;
    for (const auto& [key, value] : row.keys) at += fmt::format("{} = {}, ", key, value);
    failures.push_back({fault, number, fmt::format("{}{}: {}", at, name, what)});
  };
  try {
    const data::Scene scene = data::load_scene(text, row.keys);
    const auto fast = solve(scene);
    const auto reference = by_ref ? std::optional(solve_by_ref(scene, file.digits())) : std::nullopt;
    for (std::size_t i = 0; i < file.results.size(); ++i) {
      const ref::Estimate golden = row.numbers[i].number();
      const fast::Estimate quick = fast.results[i].numbers.front();
      const long double width = as_real(golden.error),
                        widest = std::pow(10.0L, -file.digits()) *
                                 std::max<long double>(size_of(fast, i), std::fabs(golden.to_double()));
      if (!(width <= widest))
        fail(GoldenFault::too_wide, file.results[i],
             fmt::format("the bound {} is too wide", row.numbers[i].bound));
      if (!(std::fabs(golden.error_of(quick.value)) <= quick.error + width))
        fail(GoldenFault::wrong, file.results[i],
             fmt::format("fast is {:.17g} +- {:.1e}, golden is {}", quick.value, quick.error,
                         row.numbers[i].value));
      if (!reference) continue;
      const ref::Estimate& now = reference->results[i].numbers.front();
      if (!Gap(golden, now).is_covered())
        fail(GoldenFault::wrong, file.results[i],
             fmt::format("the reference is {} +- {}, golden is {} +- {}", now.value_text(), now.error_text(),
                         row.numbers[i].value, row.numbers[i].bound));
    }
  } catch (const BadInput& refused) {
    fail(GoldenFault::wrong, "all", fmt::format("it is refused: {}", refused.what()));
  }
  return failures;
}

}  // namespace

std::vector<std::string> contact_kinds() {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(data::golden_directory())) {
    const std::string stem = entry.path().stem().string();
    if (entry.path().extension() == ".toml" && stem.starts_with(prefix)) names.push_back(stem);
  }
  std::ranges::sort(names);
  return names;
}

bool is_contact_kind(std::string_view name) {
  return name.starts_with(prefix) && std::ranges::count(contact_kinds(), name) > 0;
}

data::SceneText contact_scene(std::string_view kind) {
  if (!is_contact_kind(kind)) refuse("contacts", kind, "must be one of {}", fmt::join(contact_kinds(), ", "));
  return data::read_scene(data::golden_directory() / (std::string(kind) + ".toml"));
}

AxesProduct swept_by(const data::SceneText& scene) {
  const data::SceneSweep sweep = data::scene_sweep(scene);
  return AxesProduct(
      mapped(sweep.keys, [](const auto& key) { return axis_of(key.first, key.second, axis_points); }));
}

std::vector<std::string> contact_keys(std::string_view kind) {
  return mapped(swept_by(contact_scene(kind)).axes(), &Axis::name);
}

std::vector<std::string> contact_results(std::string_view kind) {
  const data::SceneText text = contact_scene(kind);
  const data::Scene scene = data::load_scene(text, swept_by(text).assignments(0, &AxisValue::shown));
  return mapped(scene.wanted, [](data::ResultId id) { return std::string(data::scene_result(id).name); });
}

MadeGolden make_contacts(const std::string& kind, int digits, const Provenance& provenance,
                         const OnProgress& progress) {
  const data::SceneText text = contact_scene(kind);
  const AxesProduct product = swept_by(text);
  std::vector<UnmadeContact> contacts(product.size());
  for (std::size_t i = 0; i < contacts.size(); ++i)
    contacts[i].keys = product.assignments(i, &AxisValue::shown);
  const auto part = [&](double from) {
    return [=](double done) {
      if (progress) progress(from + done / 2);
    };
  };
  parallel_for(
      contacts.size(), [&](std::size_t i) { contacts[i].solve(text, digits); }, part(0));
  const std::vector<UnmadeContact*> confirmed = to_be_confirmed(contacts);
  parallel_for(
      confirmed.size(),
      [&](std::size_t i) { confirmed[i]->take(second_solver(*confirmed[i]->scene)(), true); }, part(0.5));
  MadeGolden made;
  made.file.results = contact_results(kind);
  const data::Scene example = data::load_scene(text, contacts.front().keys);
  made.file.header = {{"quantity", kind},
                      {"definition", example.title.substr(0, example.title.find(", with "))},
                      {"command", fmt::format("nipref golden make {} --digits {}", kind, digits)},
                      {"digits", std::to_string(digits)}};
  add_provenance(made.file, provenance);
  for (const UnmadeContact& contact : contacts) {
    if (contact.refused.empty()) {
      made.file.rows.push_back(contact.row());
    } else {
      made.refused.push_back({contact.keys, contact.refused});
    }
  }
  return made;
}

CheckedGolden check_contacts(const GoldenFile& file, const CheckOptions& options) {
  const data::SceneText text = contact_scene(file.entry("quantity"));
  const std::size_t rows = (file.rows.size() + options.every - 1) / options.every,
                    by_ref = (rows + nips_for_each_confirmed - 1) / nips_for_each_confirmed;
  return checked_rows(file, file.rows.size(), by_ref, options, [&](std::size_t row, bool with_ref) {
    return check_contact(text, file, row + 1, with_ref);
  });
}

}  // namespace nipref::verify
