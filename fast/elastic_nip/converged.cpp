#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <utility>

#include <nipref/data/bad_input.hpp>
#include <nipref/fast/elastic_nip/converged.hpp>
#include <nipref/fast/elastic_nip/internal/elastic_equations.hpp>
#include <nipref/fast/nip/internal/contact_field.hpp>
#include <nipref/fast/nip/internal/domain.hpp>
#include <nipref/fast/nip/internal/kept.hpp>
#include <nipref/fast/nip/internal/places.hpp>
#include <nipref/fast/number/internal/sampled_maximum.hpp>

namespace nipref::fast {
namespace {

NipShape shape(const data::ElasticNip& nip) { return {nip.roller_radius, nip.sheet_thickness}; }

ContactUnits units_of(const data::ElasticNip& nip) { return {shape(nip), nip.material.normal_compliance()}; }

enum Component { pressure_row = 0, shear_row = 1 };

/// Of a traction at e, 0 outside the contact. Beyond the middle the shear changes its sign.
Functional traction_at(const Solution& solution, Component component, double e) {
  const double half_length = solution.half_length();
  if (!(e > 0)) return solution.of_tractions(Eigen::RowVectorXd::Zero(solution.tractions().columns()));
  const bool beyond = e > half_length;
  Eigen::RowVectorXd row =
      solution.tractions().values(beyond ? std::max(0.0, 2 * half_length - e) : e).row(component);
  if (beyond && component == shear_row) row = -row;
  return solution.of_tractions(std::move(row));
}

double shear_at(const SolvedNip& nip, double e) { return e > 0 ? nip.traction(e).imag() : 0; }

}  // namespace

struct ConvergedElasticNip::Implementation {
  Implementation(const data::ElasticNip& nip, std::shared_ptr<const ElasticEquations> kind,
                 SolvedNip solution, std::optional<double> length)
      : units(units_of(nip)), equations(std::move(kind)), solved(std::move(solution)), given_length(length) {}

  ContactUnits units;
  std::shared_ptr<const ElasticEquations> equations;
  SolvedNip solved;
  std::optional<double> given_length;  ///< unit of length
  mutable std::optional<ContactField> inner_field;
  mutable Kept<const Solution*, Functional> mean_strain;
  mutable Kept<double, SolvedNip::OfPlace> strains;  ///< without friction, by the distance from the end

  [[nodiscard]] bool grips() const { return equations->grips(); }
  [[nodiscard]] double half_length() const { return solved.half_length(); }
  [[nodiscard]] double unsure_end() const { return solved.half_length_estimate().error; }
  /// Distance of y >= 0 from the contact's end; without loss where that is given.
  [[nodiscard]] double from_end(double y) const {
    if (given_length) return (*given_length / 2 - y) / units.length;
    return half_length() - y / units.length;
  }
  /// At the distance e from the end, which is known to unsure_end(). Dimensionless.
  [[nodiscard]] Estimate traction(Component component, double e) const {
    return solved.estimate(
        solved.at_place(e, unsure_end(), [component](const Solution& solution, double place) {
          return traction_at(solution, component, place);
        }));
  }
  /// The largest magnitude of a component.
  [[nodiscard]] Estimate peak(Component component) const {
    constexpr int samples = 100;
    const auto place = [&](double i) {
      return half_length() * std::pow(std::sin(std::numbers::pi / 2 * std::min(i / samples, 1.0)), 2);
    };
    const auto size = [&](double i) {
      const std::complex<double> g = solved.traction(place(i));
      return std::fabs(component == pressure_row ? g.real() : g.imag());
    };
    const double best = internal::place_of_sampled_maximum(size, samples);
    const Estimate there = solved.estimate(
        [&](const Solution& solution) { return traction_at(solution, component, place(best)); });
    return times(units.pressure, {std::fabs(there.value), there.error});
  }
  /// The row of a displacement or strain at e. Beyond the middle an odd one changes its sign.
  [[nodiscard]] Functional at_surface(const Solution& solution, const Tractions::Kernel& kernel, double e,
                                      bool is_odd) const {
    const bool beyond = e > solution.half_length();
    const double place[] = {beyond ? 2 * solution.half_length() - e : e};
    const Eigen::RowVectorXd row =
        solution.tractions().rows(place, false, kernel, SolvedNip::tolerance()).row(0);
    return solution.of_tractions(beyond && is_odd ? -row : row);
  }
  /// The kernel that couples the pressure to v and the shear to u is at most 1/4 + beta/2; what is on both sides of a place
  /// cancels.
  [[nodiscard]] double cancelling_sides(const Solution& solution) const {
    return (0.25 + std::fabs(equations->beta()) / 2) * solution.value(solution.load());
  }
  [[nodiscard]] Functional tangential(const Solution& solution, double e) const {
    CountedKernels kernels = solved.kernels();
    Functional result = at_surface(solution, equations->tangential(kernels), e, true);
    result.cancelled = cancelling_sides(solution);
    return result;
  }
  /// Mean strain of the surface in a contact without friction.
  [[nodiscard]] Functional sliding_creep(const Solution& solution) const {
    return mean_strain.of(&solution, [&] {
      Functional creep = tangential(solution, 0);
      creep.on_tractions /= solution.half_length();
      creep.cancelled /= solution.half_length();
      return creep;
    });
  }
  [[nodiscard]] Functional creep(const Solution& solution) const {
    return grips() ? solution.of_unknown(ElasticEquations::creep) : sliding_creep(solution);
  }
  /// Without friction, the surface's strain, less the creep if that is asked for.
  [[nodiscard]] Estimate sliding_strain(double y, bool beyond_creep) const {
    const auto strain = [&](const Solution& solution, double e) {
      Functional result = at_surface(solution, equations->strain(), e, false);
      result.cancelled = solution.traction(solution.half_length()).real();
      result.on_tractions -= equations->beta() * traction_at(solution, pressure_row, e).on_tractions;
      return result;
    };
    const double e = from_end(y);
    const auto& at_place = strains.of(e, [&] { return solved.at_place(e, unsure_end(), strain); });
    std::optional<SolvedNip::Number> creep;
    if (beyond_creep) creep = [&](const Solution& solution) { return sliding_creep(solution); };
    return times(units.creep, solved.estimate(at_place, creep));
  }
  /// Made when it is asked for first.
  [[nodiscard]] const ContactField& field() const {
    if (!inner_field) inner_field.emplace(solved, true, 0, unsure_end());
    return *inner_field;
  }
  void check_shears() const {
    if (!grips())
      throw data::BadInput("friction", "none", "must be full for places of the shear: there is none");
  }
  /// Distances from the end where the shear is looked at, rising to the middle, half-thicknesses.
  [[nodiscard]] std::vector<double> shear_places() const {
    constexpr int steps = 400;
    constexpr double nearest = 1e-6;
    std::vector<double> places;
    for (int i = steps; i >= 0; --i)
      places.push_back(half_length() * std::pow(nearest, static_cast<double>(i) / steps));
    return places;
  }
  /// Y of a distance from the end, which is no surer than that end.
  [[nodiscard]] Estimate from_middle(const Estimate& from_end) const {
    return times(units.length, {half_length() - from_end.value, from_end.error + unsure_end()});
  }
};

ConvergedElasticNip::ConvergedElasticNip(std::unique_ptr<Implementation> implementation)
    : implementation_(std::move(implementation)) {}
ConvergedElasticNip::ConvergedElasticNip(ConvergedElasticNip&&) noexcept = default;
ConvergedElasticNip::~ConvergedElasticNip() = default;

Estimate ConvergedElasticNip::contact_length() const {
  const Implementation& nip = *implementation_;
  if (nip.given_length) return {*nip.given_length, 0};
  return times(2 * nip.units.length, nip.solved.half_length_estimate());
}

Estimate ConvergedElasticNip::load() const {
  return times(implementation_->units.load, implementation_->solved.estimate(&Solution::load));
}

Estimate ConvergedElasticNip::indentation() const {
  return times(implementation_->units.displacement,
               implementation_->solved.estimate([](const Solution& solution) {
                 Functional indentation = solution.of_unknown(ElasticEquations::edge_displacement);
                 indentation.constant = solution.half_length() * solution.half_length();
                 return indentation;
               }));
}

Estimate ConvergedElasticNip::edge_displacement() const {
  return times(implementation_->units.displacement,
               implementation_->solved.estimate([](const Solution& solution) {
                 return solution.of_unknown(ElasticEquations::edge_displacement);
               }));
}

Estimate ConvergedElasticNip::creep_ratio() const {
  const Implementation& nip = *implementation_;
  return times(nip.units.creep,
               nip.solved.estimate([&](const Solution& solution) { return nip.creep(solution); }));
}

Estimate ConvergedElasticNip::pressure(double y) const {
  check_position(y);
  const Implementation& nip = *implementation_;
  return times(nip.units.pressure, nip.traction(pressure_row, nip.from_end(std::fabs(y))));
}

Estimate ConvergedElasticNip::shear(double y) const {
  check_position(y);
  const Implementation& nip = *implementation_;
  // In the middle it changes its sign.
  if (!nip.grips() || y == 0) return {0, 0};
  return times(std::copysign(nip.units.pressure, y), nip.traction(shear_row, nip.from_end(std::fabs(y))));
}

Estimate ConvergedElasticNip::peak_pressure() const { return implementation_->peak(pressure_row); }

Estimate ConvergedElasticNip::peak_shear() const {
  if (!implementation_->grips()) return {0, 0};
  return implementation_->peak(shear_row);
}

Estimate ConvergedElasticNip::peak_shear_position() const {
  const Implementation& nip = *implementation_;
  nip.check_shears();
  const SolvedNip& solved = nip.solved;
  const auto size = [&](double e) { return std::fabs(shear_at(solved, e)); };
  const auto reach = [](double e) { return std::min(e / 4, 0.5); };
  const LocalSlope local_slope;
  const PlaceFunction slope{[&](double e) {
                              return std::copysign(1, shear_at(solved, e)) *
                                     local_slope([&](double at) { return shear_at(solved, at); }, e,
                                                 reach(e));
                            },
                            [&](double e) {
                              return solved.estimate([&](const Solution& solution) {
                                const auto shear = [&](double at) -> Eigen::RowVectorXd {
                                  return traction_at(solution, shear_row, at).on_tractions;
                                };
                                Functional rise = solution.of_tractions(local_slope(shear, e, reach(e)));
                                rise.cancelled = local_slope.condition() * size(e) / reach(e);
                                return rise;
                              });
                            }};
  const auto difference = [&](double e, double other) {
    const Estimate here = nip.traction(shear_row, e), there = nip.traction(shear_row, other);
    return Estimate{std::fabs(here.value) - std::fabs(there.value), here.error + there.error};
  };
  return nip.from_middle(place_of_maximum(size, slope, difference, nip.shear_places()));
}

std::vector<Estimate> ConvergedElasticNip::shear_zeros() const {
  const Implementation& nip = *implementation_;
  nip.check_shears();
  const PlaceFunction shear{[&](double e) { return shear_at(nip.solved, e); },
                            [&](double e) { return nip.traction(shear_row, e); }};
  std::vector<Estimate> zeros;
  for (const Estimate& zero : places_of_sure_zeros(shear, nip.shear_places()))
    zeros.push_back(nip.from_middle(zero));
  zeros.push_back({0, 0});
  std::ranges::reverse(zeros);
  return zeros;
}

Estimate ConvergedElasticNip::normal_displacement(double y) const {
  check_position(y);
  const Implementation& nip = *implementation_;
  const double position = std::fabs(y) / nip.units.length, from_end = nip.from_end(std::fabs(y));
  CountedKernels kernels = nip.solved.kernels();
  const auto outside = [&](const Solution& solution, double e) {
    Functional displacement = nip.at_surface(solution, nip.equations->normal(kernels), e, false);
    displacement.cancelled =
        std::pow(solution.half_length(), 2) + (nip.grips() ? nip.cancelling_sides(solution) : 0);
    return displacement;
  };
  const auto inside = [&](const Solution& solution) {
    Functional displacement = solution.of_unknown(ElasticEquations::edge_displacement);
    displacement.constant = (solution.half_length() - position) * (solution.half_length() + position);
    return displacement;
  };
  return times(nip.units.displacement,
               from_end < 0 ? nip.solved.estimate(nip.solved.at_place(from_end, nip.unsure_end(), outside))
                            : nip.solved.estimate(inside));
}

Estimate ConvergedElasticNip::tangential_displacement(double y) const {
  check_position(y);
  const Implementation& nip = *implementation_;
  const double position = std::fabs(y) / nip.units.length, from_end = nip.from_end(std::fabs(y));
  if (position == 0) return {0, 0};
  const auto at_place = [&](const Solution& solution, double e) { return nip.tangential(solution, e); };
  const auto gripped = [&](const Solution& solution) {
    Functional displacement = solution.of_unknown(ElasticEquations::creep);
    displacement.on_unknowns *= position;
    return displacement;
  };
  const bool is_gripped = nip.grips() && from_end >= 0;
  return times(std::copysign(nip.units.creep * nip.units.length, y),
               is_gripped ? nip.solved.estimate(gripped)
                          : nip.solved.estimate(nip.solved.at_place(from_end, nip.unsure_end(), at_place)));
}

Estimate ConvergedElasticNip::surface_strain(double y) const {
  check_position(y);
  const Implementation& nip = *implementation_;
  const double position = std::fabs(y), from_end = nip.from_end(position);
  if (!nip.grips()) return nip.sliding_strain(position, false);
  if (from_end < 0)
    return times(nip.units.creep / 2, nip.field().at({{position / nip.units.length, 1}}).front().along);
  Estimate creep = creep_ratio();
  // Where the end may be farther inwards, the strain is that outside.
  if (from_end < nip.unsure_end())
    creep.error += nip.units.creep *
                   (nip.traction(pressure_row, from_end).error + 2 * nip.traction(shear_row, from_end).error);
  return creep;
}

Estimate ConvergedElasticNip::slip(double y) const {
  check_position(y);
  const Implementation& nip = *implementation_;
  const double position = std::fabs(y);
  if (!nip.grips()) return nip.sliding_strain(position, true);
  if (nip.from_end(position) >= nip.unsure_end()) return {0, 0};
  const Estimate strain = surface_strain(y), creep = creep_ratio();
  return {strain.value - creep.value, strain.error + creep.error};
}

std::vector<InnerStresses> ConvergedElasticNip::inner_stresses(std::span<const InnerPoint> points) const {
  const Implementation& nip = *implementation_;
  std::vector<SheetPoint> places;
  for (const InnerPoint& point : points) places.push_back(checked_point(point, nip.units.length));
  auto stresses = nip.field().at(places);
  for (InnerStresses& here : stresses) here = in_unit(nip.units.pressure, here);
  return stresses;
}

std::vector<InnerDisplacements> ConvergedElasticNip::inner_displacements(
    std::span<const InnerPoint> points) const {
  const Implementation& nip = *implementation_;
  std::vector<SheetPoint> places;
  for (const InnerPoint& point : points) places.push_back(checked_point(point, nip.units.length));
  const double beta = nip.equations->beta();
  auto displacements = nip.field().from_face(places, {1 - beta, beta});
  std::map<double, InnerDisplacements> of_face;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto [y, depth] = points[i];
    auto face = of_face.find(y);
    if (face == of_face.end())
      face = of_face.emplace(y, InnerDisplacements{normal_displacement(y), tangential_displacement(y)}).first;
    displacements[i] = beyond_face(face->second, depth, nip.units.displacement, displacements[i]);
  }
  return displacements;
}

GreatestShear ConvergedElasticNip::greatest_shear() const {
  const Implementation& nip = *implementation_;
  const auto [value, y, depth] = nip.field().greatest();
  return {times(nip.units.pressure, value), times(nip.units.length, y), depth};
}

bool ConvergedElasticNip::refine() {
  implementation_->inner_field.reset();
  implementation_->mean_strain = {};
  implementation_->strains = {};
  return implementation_->solved.refine();
}

Work ConvergedElasticNip::work() const { return implementation_->solved.work(); }

ConvergedElasticNip converged_for_length(const data::ElasticNip& nip, data::Friction friction,
                                         double contact_length, double accuracy) {
  nip.check();
  check_contact_accuracy(accuracy);
  check_contact_length(shape(nip), contact_length);
  const auto equations = std::make_shared<const ElasticEquations>(friction, nip.material.poisson);
  return ConvergedElasticNip(std::make_unique<ConvergedElasticNip::Implementation>(
      nip, equations, SolvedNip(equations, contact_length / nip.sheet_thickness, {}, accuracy),
      contact_length));
}

ConvergedElasticNip converged_for_load(const data::ElasticNip& nip, data::Friction friction, double load,
                                       double accuracy) {
  nip.check();
  check_contact_accuracy(accuracy);
  check_contact_load(load);
  const auto equations = std::make_shared<const ElasticEquations>(friction, nip.material.poisson);
  const double unit_load = load / units_of(nip).load;
  SolvedNip solved(equations, equations->half_length_guess(unit_load), unit_load, accuracy);
  check_length_of_load(shape(nip), load, solved.half_length() * nip.sheet_thickness);
  return ConvergedElasticNip(
      std::make_unique<ConvergedElasticNip::Implementation>(nip, equations, std::move(solved), std::nullopt));
}

}  // namespace nipref::fast
