#pragma once
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include <nipref/data/problem/half_space.hpp>
#include <nipref/data/problem/nip.hpp>
#include <nipref/data/problem/places.hpp>
#include <nipref/data/scene/origin.hpp>
#include <nipref/data/scene/results.hpp>

namespace nipref::data {

// A scene is a problem together with the wanted results: all that `nipref solve` needs. Its units are any consistent
// ones. The keys in the comments are those of the TOML file, see file.hpp.

/// The load is given and the contact length follows.
struct GivenLoad {
  double per_length;  ///< W, > 0, force per unit width; load.per_length
};

/// The contact length is given and the load follows.
struct GivenLength {
  double contact_length;  ///< L, > 0 and at most the roller's radius, unit of length; contact.length
};

using Given = std::variant<GivenLoad, GivenLength>;

/// The continuous contact, computed with as much work as the accuracy needs.
struct ConvergedMethod {};

/// The thesis's line loads at the centres of equal elements. (thesis 5.1-5.16)
struct LineLoads {
  int leading_elements;   ///< on the entry side, 1 to 2000; with full friction 1 to 1000; twice as many for a
                          ///< given length; with Coulomb's friction 1 to 250; method.leading_elements
  int trailing_elements;  ///< on the exit side; equal to leading_elements, as an elastic nip is symmetric
  /// 0: kernels at the scene's accuracy; 1 to 500: so many terms of their series, summed as in the thesis. It must be 0
  /// with Coulomb's friction. method.residue_terms
  int residue_terms = 0;
};

/// An elastic sheet between two cylinders.
struct ElasticNipProblem {
  ElasticNip nip;
  Given given;
  Friction friction = Friction::none;
  /// For line loads with full friction only: the creep in place of the one that the thesis chooses (section 5.5);
  /// finite, dimensionless.
  std::optional<double> creep_ratio = {};
  std::variant<ConvergedMethod, LineLoads> method = {};
  /// Needed if a profile is wanted.
  std::optional<Profile> profile = {};
  /// Needed if stresses or displacements inside the sheet are wanted.
  std::optional<FieldPlaces> field = {};
};

/// A viscoelastic sheet rolled between two cylinders, without friction. The converged method is its steady
/// motion, line loads its started motion.
struct ViscoelasticNipProblem {
  ViscoelasticNip nip;
  Given given;
  std::variant<ConvergedMethod, ViscoelasticLineLoads> method = {};
  /// Needed if a profile is wanted.
  std::optional<Profile> profile = {};
  /// Needed if stresses inside the sheet are wanted.
  std::optional<FieldPlaces> field = {};
};

/// An elastic sheet that rolls between two cylinders with Coulomb's friction.
struct PartialSlipProblem {
  PartialSlipNip nip;
  Given given;
  std::variant<ConvergedMethod, LineLoads> method = {};
  /// Needed if a profile is wanted.
  std::optional<Profile> profile = {};
};

struct Scene {
  std::string title;
  std::vector<ResultId> wanted;  ///< at least one, none twice
  /// Relative, 1e-13 to 0.1: that of the results if the method converges, otherwise that of the kernels.
  double accuracy = 1e-10;
  std::variant<ElasticNipProblem, ViscoelasticNipProblem, PartialSlipProblem, HalfSpaceProblem> system;
  SceneOrigin origin;

  [[nodiscard]] SceneKind kind() const;
  /// Throws BadInput, naming the key and its place, unless every value is in its domain and the scene has what each
  /// wanted result needs.
  void check() const;
};

}  // namespace nipref::data
