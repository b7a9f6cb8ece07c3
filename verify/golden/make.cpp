#include <nipref/verify/audit/internal/sampling.hpp>
#include <nipref/verify/audit/internal/work.hpp>
#include <nipref/verify/golden/confirm/confirm.hpp>
#include <nipref/verify/golden/make.hpp>
#include <nipref/verify/support/internal/parallel.hpp>

namespace nipref::verify {
namespace {

// Shares of the requested points; the remaining points are spread over the domain.
constexpr double share_of_hard = 0.4, share_of_zeros = 0.1, share_of_worst = 0.1;
/// The largest number of rounds in which points of the domain replace points that occur twice or have no value.
constexpr int most_rounds = 8;
/// The largest number of audit points for each golden value.
constexpr std::size_t most_audited = 16;
constexpr double part_of_audit = 0.2;  ///< the audit's share of the progress

struct Candidate {
  Point point;
  std::string origin;
};

/// The worst point of an audit with its search, followed by the points before the search in order, the worst first.
std::vector<Point> worst_points(const Quantity& quantity, const GoldenOptions& golden, std::size_t count) {
  AuditOptions options;
  options.points = std::min(quantity.audit_points, most_audited * golden.points);
  options.seed = golden.seed;
  QuantityWork work(quantity, options, true);
  for (std::size_t block = 0; block < work.blocks(); ++block) work.do_block(block, {});
  std::vector<Finding> findings = work.findings();
  std::ranges::stable_sort(findings, std::greater<>(), &Finding::ulps);
  std::vector<Point> worst{work.result().worst};
  for (std::size_t i = 0; i < findings.size() && worst.size() < count; ++i)
    worst.push_back(findings[i].point);
  return worst;
}

/// Points for golden values, each once.
class Candidates {
 public:
  Candidates(const Quantity& quantity, const GoldenOptions& options)
      : quantity_(quantity), random_("golden " + quantity.drawn_for() + " " + options.seed) {}

  void add(const std::vector<Point>& points, const std::string& origin) {
    for (const Point& point : points)
      if (seen_.insert(point).second) fresh_.push_back({point, origin});
  }
  void add_dense(std::size_t count) { add(dense_points(quantity_, {}, count, random_), "dense"); }

  /// Adds hard cases, zeros, and the points where an audit finds the largest errors.
  void add_first(const GoldenOptions& options, const Provenance& provenance) {
    const auto share = [&](double part) {
      return static_cast<std::size_t>(std::ceil(part * static_cast<double>(options.points)));
    };
    // The worst points come first, so that a hard case among them gets their origin.
    add(worst_points(quantity_, options, share(share_of_worst)),
        "worst:fast@" + provenance.commit.substr(0, 12));
    add(thinned(hard_points(quantity_, {}, random_), share(share_of_hard)), "hard");
    add(zero_points(quantity_, {}, share(share_of_zeros), random_), "hard");
  }

  [[nodiscard]] std::size_t size() const { return fresh_.size(); }
  /// Returns the points that were added since the last call.
  std::vector<Candidate> taken() { return std::exchange(fresh_, {}); }

 private:
  const Quantity& quantity_;
  Random random_;
  std::set<Point> seen_;
  std::vector<Candidate> fresh_;
};

/// A confirmed golden value, or the reason why there is none. A row that stays as it is has neither.
struct MadeRow {
  std::optional<GoldenRow> row = {};
  std::optional<RefusedRow> refused = {};
  bool has_reference = true;
  std::string why = {};  ///< the reason to store the row
};

/// Computes and confirms a row. `why_of` returns the reason to store it; with an empty reason it is not confirmed.
template <class Why>
MadeRow made_row(const Quantity& quantity, const Point& point, const std::string& origin, int digits,
                 const Why& why_of) {
  const auto refused = [&](std::string reason, bool has_reference) -> MadeRow {
    const auto exact = [](double x) { return fmt::format("{:a}", x); };
    return {{}, RefusedRow{written_point(quantity, point, exact), std::move(reason)}, has_reference};
  };
  std::optional<ref::Estimate> reference;
  try {
    reference = ref_value(quantity, point, digits);
  } catch (const data::BadInput& error) {
    return refused(fmt::format("the reference refuses it: {}", error.what()), false);
  }
  GoldenRow row = golden_row(quantity, point, *reference);
  row.origin = origin;
  const std::string why = why_of(row);
  if (why.empty()) return {};
  if (std::string reason = confirm_row(quantity, row); !reason.empty())
    return refused(std::move(reason), true);
  return {std::move(row), {}, true, why};
}

/// Whether the scales differ by more than rounding errors.
bool is_other_scale(double before, double after) {
  return std::fabs(before - after) > 1e-12 * std::max(std::fabs(before), std::fabs(after));
}

/// Why the row has to change; empty if it stays.
std::string reason_to_change(const GoldenRow& before, const GoldenRow& after, bool all) {
  if (!Gap(before.number(), after.number()).is_covered()) return "another value";
  if (before.proven != after.proven) return "another status";
  if (is_other_scale(before.scale, after.scale)) return "another scale";
  return all ? "asked for" : "";
}

std::string decimal_example(const Quantity& quantity, const Point& point) {
  std::string text = "in the first row";
  const auto decimal = [](double x) { return fmt::format("{}", x); };
  for (const auto& [name, value] : written_point(quantity, point, decimal))
    text += fmt::format(" {}={}", name, value);
  return text;
}

}  // namespace

std::string confirm_row(const Quantity& quantity, GoldenRow& row) {
  const Confirm confirm = confirmer_of(quantity.name);
  if (!confirm)
    throw data::BadInput("quantity", quantity.name, "must have a second method that confirms its values");
  const Confirmation confirmed = confirm(NamedPoint(quantity.arguments, row.arguments));
  Gap gap(row.number(), {confirmed.value, confirmed.error, digits_beyond_double});
  if (!gap.is_covered())
    return fmt::format("{} differs by {}, more than {}", confirmed.method, upward_text(gap.distance),
                       upward_text(gap.allowed));
  mpfr_add(ref::raw(gap.distance), ref::raw(gap.distance), ref::raw(confirmed.error), MPFR_RNDU);
  if (!is_small(gap.distance, row.scale))
    return fmt::format("{} is good to {} only", confirmed.method, upward_text(gap.distance));
  row.confirmed_by = fmt::format("{} to {}", confirmed.method, upward_text(gap.distance));
  return "";
}

void add_provenance(GoldenHeader& header, const Provenance& provenance) {
  header.set("nipref", provenance.nipref);
  header.set("compiler", provenance.compiler);
  header.set("mpfr", provenance.mpfr);
  header.set("commit", provenance.commit);
  header.set("tree", provenance.clean ? "clean" : "dirty");
}

bool is_slow(const Quantity& quantity) { return quantity.audit_points < 10 || !quantity.family.empty(); }

MadeGolden make_golden(const Quantity& quantity, const GoldenOptions& options, const Provenance& provenance) {
  MadeGolden made;
  std::vector<GoldenRow>& rows = made.file.rows;
  std::size_t zeros = 0;
  const auto tell = [&](double part) {
    if (options.progress) options.progress(part);
  };
  Candidates candidates(quantity, options);
  candidates.add_first(options, provenance);
  tell(part_of_audit);
  for (int round = 0; round < most_rounds && rows.size() < options.points; ++round) {
    const std::size_t begin = rows.size(), lacking = options.points - begin;
    if (candidates.size() < lacking) candidates.add_dense(lacking - candidates.size());
    const std::vector<Candidate> all = candidates.taken();
    auto outcomes = parallel_mapped(
        all.size(),
        [&](std::size_t i) {
          return made_row(quantity, all[i].point, all[i].origin, options.digits,
                          [](const GoldenRow&) { return "new"; });
        },
        [&](double part) {
          const double rows_done = static_cast<double>(begin) + static_cast<double>(lacking) * part;
          tell(part_of_audit + (1 - part_of_audit) * rows_done / static_cast<double>(options.points));
        });
    for (MadeRow& outcome : outcomes) {
      if (outcome.refused && outcome.has_reference) made.refused.push_back(*std::move(outcome.refused));
      if (!outcome.row || rows.size() == options.points) continue;
      const auto& [value, bound] = outcome.row->numbers.front();
      const bool is_nothing = value == "0" && bound == "0";
      if (is_nothing && ++zeros > options.points / 20) continue;
      rows.push_back(*std::move(outcome.row));
    }
  }
  made.file.header = {{"quantity", quantity.name},
                      {"definition", quantity.definition},
                      {"unit", quantity.unit},
                      {"scale", quantity.scale},
                      {"command", fmt::format("nipref golden make {} --points {} --digits {} --seed {}",
                                              quantity.name, options.points, options.digits, options.seed)},
                      {"digits", std::to_string(options.digits)}};
  add_provenance(made.file, provenance);
  if (!made.file.rows.empty())
    made.file.header.emplace_back("example", decimal_example(quantity, made.file.rows.front().arguments));
  return made;
}

UpdatedGolden update_golden(const Quantity& quantity, const GoldenFile& file, bool all,
                            const Provenance& provenance, const OnProgress& progress) {
  const int digits = file.digits();
  auto outcomes = parallel_mapped(
      file.rows.size(),
      [&](std::size_t i) {
        const GoldenRow& before = file.rows[i];
        return made_row(quantity, before.arguments, before.origin, digits,
                        [&](const GoldenRow& after) { return reason_to_change(before, after, all); });
      },
      progress);
  UpdatedGolden updated{{file}};
  for (std::size_t i = 0; i < outcomes.size(); ++i) {
    auto& [row, refused, has_reference, why] = outcomes[i];
    if (refused) updated.refused.push_back(*std::move(refused));
    if (!row) continue;
    updated.changed.push_back({i + 1, file.rows[i], *row, std::move(why)});
    updated.file.rows[i] = *std::move(row);
  }
  if (!updated.changed.empty()) {
    updated.file.set("definition", quantity.definition);
    updated.file.set("unit", quantity.unit);
    updated.file.set("scale", quantity.scale);
    updated.file.set("updated", fmt::format("{} rows by {}, tree {}", updated.changed.size(),
                                            provenance.commit, provenance.clean ? "clean" : "dirty"));
  }
  return updated;
}

}  // namespace nipref::verify
