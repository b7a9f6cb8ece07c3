#include <algorithm>

#include <nipref/verify/audit/render.hpp>
#include <nipref/verify/catalogue/catalogue.hpp>
#include <nipref/verify/golden/render.hpp>

namespace nipref::verify {
namespace {

Json refused_json(const std::string& quantity, const std::vector<RefusedRow>& refused) {
  return json_list(refused, [&](const RefusedRow& row) -> Json {
    return {{"arguments", point_json(find_quantity(quantity), row.arguments)}, {"reason", row.reason}};
  });
}

Json failure_json(const GoldenFailure& failure) {
  return {{"fault", name(failure.fault)}, {"row", failure.row}, {"what", failure.what}};
}

std::size_t failures_of(GoldenFault fault, const std::vector<GoldenFailure>& folder,
                        const std::vector<CheckedGolden>& files) {
  const auto count = [&](const std::vector<GoldenFailure>& failures) {
    return static_cast<std::size_t>(std::ranges::count(failures, fault, &GoldenFailure::fault));
  };
  std::size_t sum = count(folder);
  for (const CheckedGolden& file : files) sum += count(file.failures);
  return sum;
}

/// The number of rows of all files.
template <class Files, class Rows>
std::size_t sum(const Files& files, Rows rows) {
  std::size_t total = 0;
  for (const auto& file : files) total += rows(file);
  return total;
}

Json value_json(const GoldenRow& row) {
  return {{"value", row.value}, {"error", row.bound}, {"proven", row.proven}};
}

}  // namespace

Json made_json(const std::vector<MadeFile>& files) {
  const auto rows = [](const MadeFile& file) { return file.made.file.rows.size(); };
  return {{"action", "make"},
          {"files", json_list(files,
                              [&](const MadeFile& file) -> Json {
                                return {{"quantity", file.quantity},
                                        {"file", file.path},
                                        {"rows", rows(file)},
                                        {"refused", refused_json(file.quantity, file.made.refused)}};
                              })},
          {"_rows", sum(files, rows)}};
}

Json checked_file_json(const CheckedGolden& file) {
  return {{"file", file.path.string()},
          {"quantity", Json::unless_empty(file.quantity)},
          {"rows", file.rows},
          {"recomputed", file.recomputed},
          {"hashed", file.hashed},
          {"kept", file.kept()},
          {"failures", json_list(file.failures, failure_json)},
          {"_name", file.path.filename().string()}};
}

Json checked_json(const std::vector<GoldenFailure>& folder, const std::vector<CheckedGolden>& files) {
  return {{"action", "check"},
          {"failures", json_list(folder, failure_json)},
          {"files", json_list(files, checked_file_json)},
          {"_rows", sum(files, [](const CheckedGolden& file) { return file.rows; })},
          {"_wrong", failures_of(GoldenFault::wrong, folder, files)},
          {"_useless", failures_of(GoldenFault::useless, folder, files)},
          {"_text_changed", failures_of(GoldenFault::text_changed, folder, files)},
          {"_missing", failures_of(GoldenFault::missing, folder, files)}};
}

Json updated_json(const std::vector<UpdatedFile>& files) {
  return {{"action", "update"},
          {"files", json_list(files, [](const UpdatedFile& file) -> Json {
             const auto changed = [&](const ChangedRow& row) -> Json {
               return {{"row", row.row},
                       {"arguments", point_json(find_quantity(file.quantity), row.before.arguments)},
                       {"why", row.why},
                       {"before", value_json(row.before)},
                       {"after", value_json(row.after)}};
             };
             return {{"quantity", file.quantity},
                     {"file", file.path},
                     {"rows", file.updated.file.rows.size()},
                     {"changed", json_list(file.updated.changed, changed)},
                     {"refused", refused_json(file.quantity, file.updated.refused)},
                     {"_changed", file.updated.changed.size()}};
           })}};
}

Json listed_json(const std::vector<ListedFile>& files, const std::vector<std::string>& missing) {
  return {{"action", "list"},
          {"files", json_list(files,
                              [](const ListedFile& listed) -> Json {
                                Json header = Json::object();
                                for (const auto& [key, text] : listed.file.header) header.set(key, text);
                                return {{"quantity", listed.quantity},
                                        {"file", listed.path},
                                        {"rows", listed.file.rows.size()},
                                        {"header", header}};
                              })},
          {"missing", json_list(missing, [](const std::string& quantity) -> Json { return quantity; })},
          {"_rows", sum(files, [](const ListedFile& listed) { return listed.file.rows.size(); })}};
}

}  // namespace nipref::verify
