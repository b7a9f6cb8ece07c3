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
Json made_json(const std::vector<MadeFile>& files);

Json checked_file_json(const CheckedGolden& file);
/// `folder`: failures that belong to no single file.
Json checked_json(const std::vector<GoldenFailure>& folder, const std::vector<CheckedGolden>& files);

struct UpdatedFile {
  std::string quantity, path;
  UpdatedGolden updated;
};
Json updated_json(const std::vector<UpdatedFile>& files);

struct ListedFile {
  std::string quantity, path;
  GoldenFile file;
};
/// `missing`: the quantities without golden values.
Json listed_json(const std::vector<ListedFile>& files, const std::vector<std::string>& missing);

}  // namespace nipref::verify
