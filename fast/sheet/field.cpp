#include <cmath>
#include <numbers>

#include <nipref/data/bad_input.hpp>
#include <nipref/data/material/elastic.hpp>
#include <nipref/fast/sheet/displacements.hpp>
#include <nipref/fast/sheet/field.hpp>
#include <nipref/fast/sheet/internal/argument_checks.hpp>
#include <nipref/fast/sheet/internal/field_functions.hpp>
#include <nipref/fast/sheet/internal/half_planes.hpp>
#include <nipref/fast/sheet/kernels.hpp>

// The field, with s the depth, N = theta1 + theta2 and the functions of w = alpha + i s of field_functions.hpp:
//
//     normal load                                  shear load
//     pi sigma_x  -(Re I7 + Re I5' + s Im I7')     Re I7' - s Im I5'
//     pi sigma_y  Re I5' - Re I7 + s Im I7'        -Re I7' - 2 Re I5 + s Im I5'
//     pi tau      s Re I7' - Im I5'                Im I7' + Im I5 + s Re I5'
//     N pi u      -N Im I4 - theta1 (Im I5 - s Re I7)            -theta2 Im K5 + theta1 (Im I7 + s Re I5)
//     N pi v      -theta2 Re I4 + theta1 (Re I5 + s Im I7) + ..  -N Re K5 - theta1 (Re I7 - s Im I5) + ..

namespace nipref::fast {
namespace {

using data::Derivative;
using data::SheetLoad;
using enum internal::FieldFunction;
using internal::FieldFunction;
using internal::FieldFunctions;
using internal::HalfPlaneParts;
using internal::SeenFromLoads;
using internal::Shares;
using internal::shares_of;
using std::numbers::inv_pi;

constexpr double quarter_pi = std::numbers::pi / 4;
constexpr double nearest_on_the_face = 1e-300;
/// The smallest |alpha| for second derivatives, which grow like 1/alpha^2.
constexpr double nearest_of_second = 1e-150;

void check(double alpha, double depth) {
  internal::check_argument("alpha", alpha, internal::Domain::finite);
  if (!(std::fabs(depth) <= 1)) throw data::BadInput("depth", depth, "must satisfy -1 <= depth <= 1");
  if (std::fabs(depth) == 1 && std::fabs(alpha) < nearest_on_the_face) {
    throw data::BadInput("alpha", alpha,
                         "must be at least 1e-300 in magnitude on the faces: the load is at 0");
  }
}

bool is_near(double alpha) { return alpha < internal::near_load_end; }

/// The functions from `first` on at alpha >= 0, near the load without the half-planes' parts, elsewhere without the
/// parts that do not decay.
FieldFunctions varying(double alpha, double s, FieldFunction first) {
  return is_near(alpha) ? internal::near_rest(alpha, s, first) : internal::decaying(alpha, s, first);
}

SheetStresses stresses_of(const FieldFunctions& f, double s, SheetLoad load) {
  if (load == SheetLoad::normal) {
    return {-(f[I7].re + f[I5_slope].re + s * f[I7_slope].im) * inv_pi,
            (f[I5_slope].re - f[I7].re + s * f[I7_slope].im) * inv_pi,
            (s * f[I7_slope].re - f[I5_slope].im) * inv_pi};
  }
  return {(f[I7_slope].re - s * f[I5_slope].im) * inv_pi,
          (s * f[I5_slope].im - f[I7_slope].re - 2 * f[I5].re) * inv_pi,
          (f[I7_slope].im + f[I5].im + s * f[I5_slope].re) * inv_pi};
}

/// The stresses at alpha >= 0, 0 <= s <= 1, where f are the functions without the parts that varying() leaves out.
SheetStresses whole_stresses(const FieldFunctions& f, double alpha, double s, SheetLoad load) {
  SheetStresses result = stresses_of(f, s, load);
  if (is_near(alpha)) return internal::half_plane_stresses({alpha, s}, load) + result;
  if (load == SheetLoad::shear) result.along -= 0.5;
  return result;
}

/// The sign of x, which is 0 for x = 0.
double sign(double x) { return x == 0 ? 0 : std::copysign(1.0, x); }

/// Functions whose imaginary parts are the factors of theta2/N (or 1) and of theta1/N in pi u, and whose real parts are
/// those in pi v, all relative to infinity and without constants.
struct ComplexParts {
  internal::ComplexValue first, second;

  ComplexParts(const FieldFunctions& f, double s, SheetLoad load) {
    const bool normal = load == SheetLoad::normal;
    const internal::ComplexValue a = f[normal ? I5 : I7], b = f[normal ? I7 : I5];
    const double t = normal ? -s : s;
    first = f[normal ? I4 : K5];
    second = {a.re - t * b.im, a.im + t * b.re};  // a + i t b
  }
  [[nodiscard]] HalfPlaneParts of_u() const { return {first.im, second.im}; }
  [[nodiscard]] HalfPlaneParts of_v() const { return {first.re, second.re}; }
};

double u_from(const HalfPlaneParts& parts, SheetLoad load, const Shares& share) {
  const double second = share.theta1 * parts.second;
  return (load == SheetLoad::normal ? -parts.first - second : second - share.theta2 * parts.first) * inv_pi;
}

/// v under one load has the formula of u under the other. v of a shear load lacks the part that depends on eta.
double v_from(const HalfPlaneParts& parts, SheetLoad load, const Shares& share) {
  return u_from(parts, load == SheetLoad::normal ? SheetLoad::shear : SheetLoad::normal, share);
}

double u_in_quarter(double alpha, double s, SheetLoad load, double poisson) {
  const double constant = load == SheetLoad::shear ? quarter_pi * s : 0;
  const HalfPlaneParts apart =
      is_near(alpha) ? internal::half_plane_u({alpha, s}, load) : HalfPlaneParts{constant, constant};
  return u_from(apart + ComplexParts(varying(alpha, s, I4), s, load).of_u(), load, shares_of(poisson));
}

/// v without the part that depends on eta. Far from the load, v of a shear load also lacks its term -alpha/4.
double v_in_quarter(double alpha, double s, SheetLoad load, double poisson) {
  const double constant = load == SheetLoad::normal ? quarter_pi : 0;
  const HalfPlaneParts apart =
      is_near(alpha) ? internal::half_plane_v({alpha, s}, load) : HalfPlaneParts{constant, constant};
  return v_from(apart + ComplexParts(varying(alpha, s, I4), s, load).of_v(), load, shares_of(poisson));
}

/// v of a shear load. Its parts grow with alpha and eta; far from the load alpha and eta are subtracted first.
double shear_v_in_quarter(double alpha, double eta, double s, double poisson) {
  const int part = static_cast<int>(internal::Component::eta_part_of_I6);
  const double held =
      shares_of(poisson).theta1 * fast::I7(eta) - internal::sheet_code().scalar[part][Accuracy().tier()](eta);
  const double apart = is_near(alpha) ? eta : eta - alpha;
  return apart / 4 + (held * inv_pi + v_in_quarter(alpha, s, SheetLoad::shear, poisson));
}

/// A function that is odd in alpha is proportional to tiny alpha. A tiny alpha is multiplied by 2^64, so that no product
/// with it underflows before the division by the square of a small distance; the result is multiplied by `scale`.
struct Lifted {
  double alpha;
  double scale;
};
Lifted lifted(double alpha, double depth) {
  const double a = std::fabs(alpha);
  const bool tiny = a < 1e-280 && std::fabs(depth) < 1;  // the distance from the face is 2^-53 at least
  return tiny ? Lifted{a * 0x1p64, 0x1p-64} : Lifted{a, 1};
}

/// The stresses at (alpha, depth) from those at (|alpha|, |depth|), by their parities. Stresses that are odd in alpha
/// are multiplied by `scale`.
SheetStresses with_signs(SheetStresses stresses, double alpha, double depth, SheetLoad load,
                         double scale = 1) {
  const double side = scale * sign(alpha), face = sign(depth);
  if (load == SheetLoad::shear) {
    stresses.across *= side;
    stresses.along *= side;
    stresses.shear *= face;
  } else {
    stresses.shear *= side * face;
  }
  return stresses;
}

/// A place on a face.
struct FacePlace {
  double a, q, aq;  ///< |alpha|, 4 + alpha^2 and their product
  bool near;

  FacePlace(double alpha, Derivative order) : a(std::fabs(alpha)), q(4 + a * a), aq(a * q), near(is_near(a)) {
    check(alpha, 1);
    if (order == Derivative::second && a < nearest_of_second)
      throw data::BadInput("alpha", alpha, "must be at least 1e-150 in magnitude: the load is at 0");
  }
  /// A function at alpha + i, near the load without the half-planes' part, elsewhere without the part that does not decay.
  [[nodiscard]] internal::ComplexValue part(internal::FieldFunction f) const { return varying(a, 1, f)[f]; }
  /// The half-planes' part `value` near the load; elsewhere 0, as the residue series includes this part.
  [[nodiscard]] double planes(double value) const { return near ? value : 0; }
};

}  // namespace

internal::StressesAtDepth::StressesAtDepth(double depth)
    : depth_(depth), waves_(std::fabs(depth), field_roots) {}

internal::UnderLoads<SheetStresses> internal::StressesAtDepth::at(double alpha, bool with_shear) const {
  const double a = std::fabs(alpha), s = std::fabs(depth_);
  const FieldFunctions f =
      is_near(a) ? near_rest(a, s, FieldFunction::I5) : decaying(AlongWaves(a), waves_, FieldFunction::I5);
  const auto under = [&](SheetLoad load) {
    return with_signs(whole_stresses(f, a, s, load), alpha, depth_, load);
  };
  return {under(SheetLoad::normal), with_shear ? under(SheetLoad::shear) : SheetStresses{}};
}

internal::DisplacementsFromFace::DisplacementsFromFace(double depth, const Shares& share)
    : depth_(depth), share_(share), waves_(depth, field_roots), of_face_(1, field_roots) {}

internal::UnderLoads<internal::FromFace> internal::DisplacementsFromFace::at(double alpha,
                                                                             bool with_shear) const {
  const double a = std::fabs(alpha), side = sign(alpha);
  const bool near = is_near(a);
  const auto at_depth = [&](double depth, const AcrossWaves& waves) {
    return near ? near_rest(a, depth, FieldFunction::I4) : decaying(AlongWaves(a), waves, FieldFunction::I4);
  };
  const FieldFunctions here = at_depth(depth_, waves_), face = at_depth(1, of_face_);
  const auto under = [&](SheetLoad load) {
    const ComplexParts parts(here, depth_, load), of_face(face, 1, load);
    HalfPlaneParts u = parts.of_u(), u_of_face = of_face.of_u(), v = parts.of_v() - of_face.of_v();
    if (near) {
      const SeenFromLoads place(a, depth_), on_face(a, 1);
      u = u + half_plane_u(place, load);
      u_of_face = u_of_face + half_plane_u(on_face, load);
      v = v + (half_plane_v(place, load) - half_plane_v(on_face, load));
    }
    FromFace of{u_from(u, load, share_) - depth_ * u_from(u_of_face, load, share_), v_from(v, load, share_)};
    (load == SheetLoad::normal ? of.v : of.u) *= side;
    return of;
  };
  return {under(SheetLoad::normal), with_shear ? under(SheetLoad::shear) : FromFace{}};
}

SheetStresses sheet_stresses(double alpha, double depth, SheetLoad load) {
  check(alpha, depth);
  const Lifted place = lifted(alpha, depth);
  const double s = std::fabs(depth);
  SheetStresses result = whole_stresses(varying(place.alpha, s, FieldFunction::I5), place.alpha, s, load);
  if (s == 1) result.across = result.shear = 0;  // exactly, as there is no load
  return with_signs(result, alpha, depth, load, place.scale);
}

// On a face w = alpha + i: the derivative of pi un is Im I7, those of pi vn and pi vs are -Re I7 and -Re I5.

double un_slope(double alpha, Derivative order) {
  const FacePlace at(alpha, order);
  if (order == Derivative::second)
    return (at.part(FieldFunction::I7_slope).im + at.planes(4 * (4 + 3 * at.a * at.a) / at.aq / at.aq)) *
           inv_pi;
  return sign(alpha) * (at.part(FieldFunction::I7).im - at.planes(4 / at.aq)) * inv_pi;
}

double vn_slope(double alpha, Derivative order) {
  const FacePlace at(alpha, order);
  if (order == Derivative::second)
    return sign(alpha) * (at.planes(4 * at.a / at.q / at.q) - at.part(FieldFunction::I7_slope).re) * inv_pi;
  return -(at.part(FieldFunction::I7).re + at.planes(2 / at.q)) * inv_pi;
}

double vs_slope(double alpha, Derivative order) {
  const FacePlace at(alpha, order);
  const double square = at.a * at.a;
  if (order == Derivative::second)
    return (at.planes(2 * (8 + square * (2 + square)) / at.aq / at.aq) -
            at.part(FieldFunction::I5_slope).re) *
           inv_pi;
  const double constant = at.near ? 2 * (2 + square) / at.aq : quarter_pi;
  return -sign(alpha) * (at.part(FieldFunction::I5).re + constant) * inv_pi;
}

double sheet_u(double alpha, double depth, SheetLoad load, double poisson) {
  check(alpha, depth);
  data::ElasticMaterial{1, poisson}.check();
  const Lifted place = lifted(alpha, depth);
  const double signs = sign(depth) * (load == SheetLoad::shear ? sign(alpha) * place.scale : 1);
  return signs * u_in_quarter(place.alpha, std::fabs(depth), load, poisson);
}

double sheet_v(double alpha, double eta, double depth, SheetLoad load, double poisson) {
  check(alpha, depth);
  internal::check_argument("eta", eta, internal::Domain::finite);
  data::ElasticMaterial{1, poisson}.check();
  const double s = std::fabs(depth);
  if (load == SheetLoad::shear) return shear_v_in_quarter(std::fabs(alpha), std::fabs(eta), s, poisson);
  const Lifted place = lifted(alpha, depth);
  return sign(alpha) * place.scale * v_in_quarter(place.alpha, s, load, poisson) + F1(eta, poisson);
}

}  // namespace nipref::fast
