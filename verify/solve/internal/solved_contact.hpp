#pragma once
#include <optional>
#include <vector>

#include <nipref/data/problem/field_places.hpp>
#include <nipref/data/scene/results.hpp>
#include <nipref/fast/nip/work.hpp>

namespace nipref::verify {

using data::ResultId;

/// Where evenly spaced profiles begin and end: Y, unit of length.
struct ProfileExtent {
  double first, last;
};

/// A solved contact, whose results are those of data::scene_results(). A result is computed when it is first asked for.
template <class Number>
class SolvedContact {
 public:
  SolvedContact() = default;
  SolvedContact(const SolvedContact&) = delete;
  SolvedContact& operator=(const SolvedContact&) = delete;
  virtual ~SolvedContact() = default;

  [[nodiscard]] virtual Number number(ResultId id) const = 0;
  /// A profile's value at Y, unit of length.
  [[nodiscard]] virtual Number at(ResultId id, double y) const = 0;
  /// Stresses inside the sheet at all places, depth after depth; Scene::check allows them for a converged nip only.
  [[nodiscard]] virtual std::vector<Number> inside(ResultId, const data::FieldPlaces&) const { return {}; }
  /// The numbers of a result whose shape is a list.
  [[nodiscard]] virtual std::vector<Number> list(ResultId) const { return {}; }
  [[nodiscard]] virtual ProfileExtent profile_extent() const = 0;
  /// The least size of data::Scale for the error of a result, of a profile at Y. Nothing if the error does not
  /// depend on the accuracy that the scene asks for.
  [[nodiscard]] virtual std::optional<double> least_size(ResultId, double) const { return {}; }
  /// Solves again with more terms for smaller errors; false if this is not possible.
  virtual bool refine() { return false; }
  /// The work so far on the results, and in error_work() the work on their error estimates alone.
  [[nodiscard]] virtual fast::Work work() const = 0;
  [[nodiscard]] virtual fast::Work error_work() const { return {}; }
};

}  // namespace nipref::verify
