#include <nipref/data/input_file.hpp>
#include <nipref/verify/audit/audit.hpp>
#include <nipref/verify/catalogue/deviation.hpp>
#include <nipref/verify/golden/check.hpp>
#include <nipref/verify/golden/contacts.hpp>
#include <nipref/verify/support/internal/parallel.hpp>

namespace nipref::verify {
namespace {

namespace fs = std::filesystem;

/// The least number of rows that are compared with the reference, however slow it is.
constexpr std::size_t fewest = 6;

/// The largest ratio of the reference's error to the stored bound that passes.
constexpr long double widening = 1.5;

std::vector<GoldenFailure> check_row(const Quantity& quantity, const GoldenRow& row, std::size_t number,
                                     int digits, bool by_ref) {
  std::vector<GoldenFailure> failures;
  const std::string at = point_text(quantity, row.arguments);
  const ref::Estimate golden = row.number();
  const auto fail = [&](GoldenFault fault, const std::string& what) {
    failures.push_back({fault, number, at + ": " + what});
  };
  if (!is_small(golden.error, row.scale)) {
    fail(GoldenFault::too_wide,
         fmt::format("the bound {} is too wide for the scale {:.3g}", row.numbers.front().bound, row.scale));
    return failures;
  }
  if (by_ref) {
    try {
      const ref::Estimate now = ref_value(quantity, row.arguments, digits);
      const Gap gap(golden, now);
      if (!is_small(gap.allowed, row.scale)) {
        fail(GoldenFault::too_wide, fmt::format("the reference's error {} is too wide for the scale {:.3g}",
                                                now.error_text(), row.scale));
      } else if (!gap.is_covered()) {
        fail(GoldenFault::wrong,
             fmt::format("the reference is {} +- {}, golden is {} +- {}", now.value_text(), now.error_text(),
                         row.numbers.front().value, row.numbers.front().bound));
      } else if (mpfr_get_ld(ref::raw(now.error), MPFR_RNDU) >
                 widening * mpfr_get_ld(ref::raw(golden.error), MPFR_RNDU)) {
        fail(GoldenFault::too_wide, fmt::format("the reference's error has grown from {} to {}",
                                                row.numbers.front().bound, now.error_text()));
      }
    } catch (const data::BadInput& refused) {
      fail(GoldenFault::wrong, fmt::format("the reference refuses it: {}", refused.what()));
    }
  }
  const double fast = fast_value(quantity, row.arguments, {});
  const double ulps = deviation(fast, golden, row.scale).ulps;
  if (!(ulps <= quantity.promise)) {
    fail(GoldenFault::wrong, fmt::format("fast is {:.17g}, {:.3g} ulp of the scale off {}, promised are {:g}",
                                         fast, ulps, row.numbers.front().value, quantity.promise));
  }
  return failures;
}

}  // namespace

std::string_view name(GoldenFault fault) {
  constexpr std::string_view names[] = {"wrong", "too-wide", "text-changed", "missing"};
  return names[static_cast<std::size_t>(fault)];
}

CheckedGolden checked_rows(const GoldenHeader& file, std::size_t rows, std::size_t by_ref,
                           const CheckOptions& options,
                           const std::function<std::vector<GoldenFailure>(std::size_t, bool)>& check) {
  CheckedGolden checked;
  checked.quantity = file.entry("quantity");
  checked.rows = (rows + options.every - 1) / options.every;
  checked.recomputed = options.all ? checked.rows : std::min(checked.rows, by_ref);
  // A single one is taken at the end, where rows take the reference longest, and is in the middle if turned by half.
  const auto is_recomputed = [&](std::size_t i) {
    const std::size_t turned = (i + checked.rows / 2) % checked.rows;
    return is_taken(turned, checked.rows, checked.recomputed);
  };
  auto failures = parallel_mapped(
      checked.rows, [&](std::size_t i) { return check(i * options.every, is_recomputed(i)); },
      options.progress);
  for (auto& found : failures) std::ranges::move(found, std::back_inserter(checked.failures));
  return checked;
}

CheckedGolden check_rows(const Quantity& quantity, const GoldenFile& file, const CheckOptions& options) {
  const int digits = file.digits();
  return checked_rows(file, file.rows.size(), std::max(fewest, quantity.audit_points / 4), options,
                      [&](std::size_t row, bool by_ref) {
                        return check_row(quantity, file.rows[row], row + 1, digits, by_ref);
                      });
}

CheckedGolden check_golden(const fs::path& path, const CheckOptions& options) {
  const auto sums = checksums_of(path.parent_path());
  const auto expected = sums.find(path.filename().string());
  std::optional<GoldenFailure> changed;
  if (expected != sums.end() && sha256(data::text_of_input_file(path, "file")) != expected->second)
    changed = {
        GoldenFault::text_changed, {}, fmt::format("{} is not what {} says", path.string(), checksums_name)};
  CheckedGolden checked;
  try {
    const GoldenFile file = read_golden(path);
    checked =
        file.results.empty() ? check_rows(file.quantity(), file, options) : check_contacts(file, options);
  } catch (const data::BadInput& unreadable) {
    if (!changed) throw;
    changed->what += fmt::format(", and cannot be read: {}", unreadable.what());
  }
  checked.path = path;
  checked.hashed = expected != sums.end();
  if (changed) checked.failures.insert(checked.failures.begin(), *changed);
  return checked;
}

std::vector<GoldenFailure> check_folder(const fs::path& folder) {
  const auto sums = checksums_of(folder);
  std::vector<GoldenFailure> failures;
  const auto fail = [&](const std::string& what) {
    failures.push_back({GoldenFault::text_changed, {}, what});
  };
  for (const auto& [name, digest] : sums) {
    if (!fs::exists(folder / name))
      fail(fmt::format("{} lists {}, which is not there", checksums_name, name));
  }
  for (const auto& entry : fs::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    if (name.ends_with(".csv") && !sums.contains(name))
      fail(fmt::format("{} does not list {}", checksums_name, name));
  }
  return failures;
}

Json failure_json(const GoldenFailure& failure) {
  return {{"fault", name(failure.fault)}, {"row", failure.row}, {"what", failure.what}};
}

Json checked_file_json(const CheckedGolden& file) {
  return {{"file", file.path.string()},
          {"quantity", Json::unless_empty(file.quantity)},
          {"rows", file.rows},
          {"recomputed", file.recomputed},
          {"hashed", file.hashed},
          {"passed", file.kept()},
          {"failures", json_list(file.failures, failure_json)},
          {"_name", file.path.filename().string()}};
}

Checksums checksums_of(const std::filesystem::path& folder) {
  Checksums sums;
  const std::filesystem::path path = folder / checksums_name;
  if (!std::filesystem::exists(path)) return sums;
  std::istringstream lines(data::text_of_input_file(path, "checksums"));
  constexpr std::size_t digits = 64;
  for (std::string line; std::getline(lines, line);) {
    // The digest is followed by two blanks, or by a blank and a star for a file that was read as binary.
    const bool is_one = line.size() > digits + 2 && line[digits] == ' ' &&
                        line.find_first_not_of("0123456789abcdef") == digits;
    if (!is_one) throw data::BadInput("checksums", path.string(), "must have lines as sha256sum writes them");
    sums[line.substr(digits + 2)] = line.substr(0, digits);
  }
  return sums;
}

std::string checksums_text(const Checksums& sums) {
  std::string text;
  for (const auto& [name, digest] : sums) text += fmt::format("{}  {}\n", digest, name);
  return text;
}

}  // namespace nipref::verify
