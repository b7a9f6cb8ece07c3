#pragma once
#include <cstdint>

#include <nipref/data/scene/scene.hpp>
#include <nipref/verify/support/internal/common.hpp>
#include <nipref/verify/support/random.hpp>

namespace nipref::verify {

/// A scene as the keys of its TOML file, so that single keys can be changed and the scene is read exactly as by
/// `solve`.
class DrawnScene {
 public:
  using Value = std::variant<double, std::string, std::vector<double>, std::vector<data::ResultId>>;

  /// "TABLE.KEY", or "KEY".
  void set(const std::string& key, Value value) { keys_.insert_or_assign(key, std::move(value)); }
  void remove(const std::string& key) { keys_.erase(key); }
  [[nodiscard]] bool has(const std::string& key) const { return keys_.contains(key); }
  /// The value of a key, which must have this type.
  [[nodiscard]] double number(const std::string& key) const { return std::get<double>(keys_.at(key)); }
  [[nodiscard]] std::string text(const std::string& key) const {
    return std::get<std::string>(keys_.at(key));
  }
  [[nodiscard]] std::vector<double> numbers(const std::string& key) const {
    return std::get<std::vector<double>>(keys_.at(key));
  }
  [[nodiscard]] const std::vector<data::ResultId>& wanted() const {
    return std::get<std::vector<data::ResultId>>(keys_.at("wanted"));
  }
  void set_wanted(std::vector<data::ResultId> results) { set("wanted", std::move(results)); }
  [[nodiscard]] std::map<std::string, Value>& keys() { return keys_; }

  [[nodiscard]] std::string toml() const;
  /// BadInput as from load_scene.
  [[nodiscard]] data::Scene scene() const;

 private:
  std::map<std::string, Value> keys_;
};

/// The kinds of scenes that data/statements/drawn_scenes.toml states, by name; scene `index` of any seed is of kind index modulo their number.
const std::vector<std::string_view>& drawn_kinds();

/// Scene number `index` of `seed`, which is the same at each call. The domain: L/B 1e-4 to 1e3, R/B 1 to 1e4,
/// Poisson's ratio -0.9 to 0.4999, relaxation lengths 1e-8 to 1e8 contact lengths, speeds up to 1 - 1e-9 of the
/// critical one, ratios of curvatures 1e-4 to 1e4, accuracies 1e-2 to 1e-13. The scene wants all results of its kind.
/// Every other scene has numbers of 34 bits, see variants_of. Some scenes are refused when they are read or solved.
DrawnScene draw_scene(const std::string& seed, std::uint64_t index);

}  // namespace nipref::verify
