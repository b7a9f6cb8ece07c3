#include <algorithm>
#include <filesystem>

#include <nipref/data/bad_input.hpp>
#include <nipref/verify/cli/graded.hpp>
#include <nipref/verify/cli/output.hpp>
#include <nipref/verify/golden/golden.hpp>
#include <nipref/verify/golden/make.hpp>

namespace nipref::verify {
namespace {

constexpr int digits = 50;

GoldenFile file_at(const std::string& path, const Quantity& quantity) {
  std::error_code none;
  if (!std::filesystem::exists(path, none))
    return {{{"quantity", quantity.name}, {"unit", quantity.unit}, {"digits", std::to_string(digits)}}, {}};
  GoldenFile file = read_golden(path);
  if (file.entry("quantity") != quantity.name)
    throw data::BadInput("keep-worst", path, "must be a file of " + quantity.name + ", or none yet");
  return file;
}

}  // namespace

void keep_worst(const std::string& path, const Graded& graded) {
  const AuditResult& found = graded.grade.found;
  const Quantity& quantity = *found.quantity;
  GoldenFile file = file_at(path, quantity);
  if (std::ranges::find(file.rows, found.worst, &GoldenRow::arguments) != file.rows.end()) return;
  GoldenRow row = golden_row(quantity, found.worst, ref_value(quantity, found.worst, digits));
  row.origin = "worst:" + graded.grade.what;
  // What no second method confirms is kept too, without one: the point is what matters here.
  static_cast<void>(confirm_row(quantity, row));
  file.rows.push_back(std::move(row));
  replace_output_file(path, golden_text(quantity, file));
}

}  // namespace nipref::verify
