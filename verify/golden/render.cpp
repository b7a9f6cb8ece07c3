#include <fmt/format.h>

#include <algorithm>

#include <nipref/verify/audit/render.hpp>
#include <nipref/verify/catalogue/catalogue.hpp>
#include <nipref/verify/golden/render.hpp>

namespace nipref::verify {
namespace {

std::string refused_text(const std::string& quantity, const std::vector<RefusedRow>& refused) {
  std::string text;
  for (const RefusedRow& row : refused)
    text += fmt::format("  refused{}: {}\n", point_text(find_quantity(quantity), row.arguments), row.reason);
  return text;
}

Json refused_json(const std::string& quantity, const std::vector<RefusedRow>& refused) {
  return json_list(refused, [&](const RefusedRow& row) -> Json {
    return {{"arguments", point_json(find_quantity(quantity), row.arguments)}, {"reason", row.reason}};
  });
}

Json failure_json(const GoldenFailure& failure) {
  return {{"fault", name(failure.fault)}, {"row", failure.row}, {"what", failure.what}};
}

std::string failure_text(const GoldenFailure& failure) {
  return failure.row ? fmt::format("  {}: row {}:{}\n", name(failure.fault), *failure.row, failure.what)
                     : fmt::format("  {}: {}\n", name(failure.fault), failure.what);
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

Json value_json(const GoldenRow& row) {
  return {{"value", row.value}, {"error", row.bound}, {"proven", row.proven}};
}

}  // namespace

std::string made_text(const std::vector<MadeFile>& files) {
  std::string text;
  std::size_t rows = 0;
  for (const auto& [quantity, path, made] : files) {
    rows += made.file.rows.size();
    text += fmt::format("{:20} {:5} values, all confirmed, in {}\n", quantity, made.file.rows.size(), path);
    text += refused_text(quantity, made.refused);
  }
  return text + fmt::format("{} golden values\n", rows);
}

Json made_json(const std::vector<MadeFile>& files) {
  return {{"action", "make"}, {"files", json_list(files, [](const MadeFile& file) -> Json {
                                 return {{"quantity", file.quantity},
                                         {"file", file.path},
                                         {"rows", file.made.file.rows.size()},
                                         {"refused", refused_json(file.quantity, file.made.refused)}};
                               })}};
}

std::string checked_text(const std::vector<GoldenFailure>& folder, const std::vector<CheckedGolden>& files) {
  std::string text;
  std::size_t rows = 0;
  for (const GoldenFailure& failure : folder) text += failure_text(failure);
  for (const CheckedGolden& file : files) {
    rows += file.rows;
    text += fmt::format("{:20} {:5} values, {} of them recomputed by the reference{}: {}\n",
                        file.quantity.empty() ? file.path.filename().string() : file.quantity, file.rows,
                        file.recomputed, file.hashed ? "" : ", no checksum", file.kept() ? "kept" : "BROKEN");
    for (const GoldenFailure& failure : file.failures) text += failure_text(failure);
  }
  return text + fmt::format("{} golden values: {} wrong, {} useless, {} text-changed, {} missing\n", rows,
                            failures_of(GoldenFault::wrong, folder, files),
                            failures_of(GoldenFault::useless, folder, files),
                            failures_of(GoldenFault::text_changed, folder, files),
                            failures_of(GoldenFault::missing, folder, files));
}

Json checked_file_json(const CheckedGolden& file) {
  return {{"file", file.path.string()},
          {"quantity", Json::unless_empty(file.quantity)},
          {"rows", file.rows},
          {"recomputed", file.recomputed},
          {"hashed", file.hashed},
          {"kept", file.kept()},
          {"failures", json_list(file.failures, failure_json)}};
}

Json checked_json(const std::vector<GoldenFailure>& folder, const std::vector<CheckedGolden>& files) {
  return {{"action", "check"},
          {"failures", json_list(folder, failure_json)},
          {"files", json_list(files, checked_file_json)}};
}

std::string updated_text(const std::vector<UpdatedFile>& files) {
  std::string text;
  for (const auto& [quantity, path, updated] : files) {
    for (const ChangedRow& row : updated.changed) {
      text += fmt::format("{} row {}, {}:{}\n- {} +- {} {}\n+ {} +- {} {}\n", quantity, row.row, row.why,
                          point_text(find_quantity(quantity), row.before.arguments), row.before.value,
                          row.before.bound, row.before.proven ? "proven" : "estimated", row.after.value,
                          row.after.bound, row.after.proven ? "proven" : "estimated");
    }
    text += refused_text(quantity, updated.refused);
    text += fmt::format("{:20} {} of {} rows changed\n", quantity, updated.changed.size(),
                        updated.file.rows.size());
  }
  return text;
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
                     {"refused", refused_json(file.quantity, file.updated.refused)}};
           })}};
}

std::string listed_text(const std::vector<ListedFile>& files, const std::vector<std::string>& missing) {
  std::string text;
  std::size_t rows = 0;
  for (const auto& [quantity, path, file] : files) {
    rows += file.rows.size();
    text += fmt::format("{:20} {:5} values, {} digits, commit {:.12}, {}\n", quantity, file.rows.size(),
                        file.entry("digits"), file.entry("commit"), file.entry("tree"));
  }
  for (const std::string& quantity : missing) text += fmt::format("{:20}     no golden values\n", quantity);
  return text + fmt::format("{} golden values\n", rows);
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
          {"missing", json_list(missing, [](const std::string& quantity) -> Json { return quantity; })}};
}

}  // namespace nipref::verify
