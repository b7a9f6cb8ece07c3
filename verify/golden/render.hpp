#pragma once
#include <string>
#include <vector>

#include <nipref/verify/golden/check.hpp>
#include <nipref/verify/golden/update.hpp>
#include <nipref/verify/support/json.hpp>

namespace nipref::verify {

/// The new golden values of a quantity and their file.
struct MadeFile {
  std::string quantity, path;
  MadeGolden made;
};
std::string made_text(const std::vector<MadeFile>& files);
Json made_json(const std::vector<MadeFile>& files);

/// `folder`: failures that belong to no single file.
std::string checked_text(const std::vector<GoldenFailure>& folder, const std::vector<CheckedGolden>& files);
Json checked_file_json(const CheckedGolden& file);
Json checked_json(const std::vector<GoldenFailure>& folder, const std::vector<CheckedGolden>& files);

struct UpdatedFile {
  std::string quantity, path;
  UpdatedGolden updated;
};
std::string updated_text(const std::vector<UpdatedFile>& files);
Json updated_json(const std::vector<UpdatedFile>& files);

struct ListedFile {
  std::string quantity, path;
  GoldenFile file;
};
/// `missing`: the quantities without golden values.
std::string listed_text(const std::vector<ListedFile>& files, const std::vector<std::string>& missing);
Json listed_json(const std::vector<ListedFile>& files, const std::vector<std::string>& missing);

}  // namespace nipref::verify
