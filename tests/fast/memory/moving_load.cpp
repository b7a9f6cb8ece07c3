#include <nipref/fast/memory/internal/fading.hpp>
#include <nipref/fast/memory/moving_load.hpp>

#include "support/kernels.hpp"
#include "support/test.hpp"

using namespace fast_tests;
using namespace nipref::fast;
using nipref::data::MaterialFunction;
using nipref::data::ViscoelasticMaterial;

TEST_SUITE_BEGIN("fast moving load");

namespace {

constexpr double pi = std::numbers::pi;

/// Compliances that double with time, with one rate; Poisson's ratio is 1/3 throughout.
ViscoelasticMaterial solid(double rate) { return {{1, {{rate, rate}}}, {0.5, {{rate / 2, rate}}}}; }

/// int_from^to f for f with at most a logarithm at the ends: the double-exponential rule.
template <typename Function>
double integral(const Function& f, double from, double to) {
  constexpr double h = 1.0 / 32;
  double sum = 0;
  for (double s = -3.3; s <= 3.3; s += h) {
    const double e = std::exp(pi * std::sinh(s)), x = e / (1 + e);
    sum += f(from + (to - from) * x) * pi * std::cosh(s) * x / (1 + e);
  }
  return (to - from) * h * sum;
}

/// The memory integral as it is defined, kernel by kernel.
double brute_force(double (*kernel)(double, Accuracy), double alpha, double s, double rate) {
  const auto faded = [&](double w) { return std::exp(-rate * (w - alpha)) * (w == 0 ? 0 : kernel(w, {})); };
  std::vector<double> ends{alpha};
  for (const double cut : {-3.0, -1.0, 0.0, 1.0, 3.0}) {
    if (cut > alpha && cut < alpha + s) ends.push_back(cut);
  }
  ends.push_back(alpha + s);
  double sum = 0;
  for (std::size_t i = 1; i < ends.size(); ++i) sum += integral(faded, ends[i - 1], ends[i]);
  return sum;
}

double I2_as_kernel(double alpha, Accuracy) { return I2(alpha); }

/// int_alpha^inf e^(-rate (w - alpha)) I1(w) dw: what a point at alpha remembers of the load while it was
/// farther ahead.
double steady_I1(double alpha, double rate, Accuracy accuracy = {}) {
  using internal::Kernel;
  return internal::steady_memory(Kernel::I1, internal::surface_point({alpha, 0}, accuracy),
                                 internal::fade(internal::Two{rate, 0}, {Kernel::I1}, accuracy), accuracy);
}

}  // namespace

TEST_CASE("the area under I1 is the transform at 0, and half of it is ahead") {
  CHECK(steady_I1(0, 0) == doctest::Approx(pi / 4).epsilon(1e-15));
  CHECK(steady_I1(-30, 0) == doctest::Approx(pi / 2).epsilon(1e-15));
}

TEST_CASE(
    "behind the load memory is the kernel's transform at an imaginary frequency: notes on thesis (6.23)") {
  for (const double L :
       {0.5, 1.0, 1.5, 2.0}) {  // slower than the residues, so that it is all that is left far behind
    const double transform = 2 * std::pow(std::sin(L), 2) / (L * (std::sin(2 * L) + 2 * L));
    CHECK(steady_I1(-300, L) == doctest::Approx(pi * transform * std::exp(-L * 300)).epsilon(1e-12));
  }
  for (const double L : {0.5, 5.0, 50.0, 500.0}) {  // the whole sum, by the jump condition at the load
    const double transform = 2 * std::pow(std::sin(L), 2) / (L * (std::sin(2 * L) + 2 * L));
    double residues = 0;  // of the part that ends at the load, closed by its own integral from -2
    for (int n = 1; n <= 40; ++n) {
      const ComplexL z = root(n);
      const ComplexL c = ComplexL(0, 2 * pi_long) * residue::I1(z) * std::exp(ComplexL(0, 1) * z * 2.0L);
      residues += static_cast<double>((c / (static_cast<long double>(L) + ComplexL(0, 1) * z)).real());
    }
    const double behind = brute_force(I1, -2, 2, L) + std::exp(-2 * L) * steady_I1(0, L);
    CHECK(pi * transform * std::exp(-2 * L) + residues == doctest::Approx(behind).epsilon(1e-12));
    CHECK(steady_I1(-2, L) == doctest::Approx(behind).epsilon(1e-12));
  }
}

TEST_CASE("steady memory of I1 satisfies M' = L M - I1 from piece to piece") {
  for (const double L : {1e-8, 0.03, 1.0, 20.0, 1e3}) {
    for (const double from :
         {-9.0, -1.4, -1.0, -0.8, -0.5, -0.2, -0.01, 0.0, 0.004, 0.3, 0.5, 0.9, 1.0, 4.0}) {
      const double s = 0.35;
      const double sum = brute_force(I1, from, s, L) + std::exp(-L * s) * steady_I1(from + s, L);
      CHECK(steady_I1(from, L) == doctest::Approx(sum).epsilon(2e-13));
    }
  }
}

TEST_CASE("steady memory of a fast rate is the kernel over the rate, the next term one order down") {
  for (const double alpha : {-5.0, -0.3, 0.2, 0.7, 2.0}) {
    const auto error = [&](double L) { return std::fabs(L * steady_I1(alpha, L) - I1(alpha)); };
    CHECK(error(1e10) < 1e-7);
    CHECK(error(1e5) / error(1e4) == doctest::Approx(0.1).epsilon(0.01));
  }
}

TEST_CASE("steady memory with less accuracy") {
  for (const double alpha : {-40.0, -2.0, -0.7, -1e-5, 0.0, 1e-9, 0.3, 0.8, 1.5, 30.0}) {
    const double value = steady_I1(alpha, 0.8);
    for (const double rtol : {1e-3, 1e-6, 1e-8, 1e-12}) {
      CHECK(std::fabs(steady_I1(alpha, 0.8, Accuracy(rtol)) - value) <= rtol * std::fabs(value) * 4);
    }
  }
}

TEST_CASE("Un and Vn are the memory integrals of the elastic kernels, in all four cases") {
  const double speed = 3, b = 0.5, unit = b / speed;  // times below in units of b/F0
  const double l1 = 0.4, l2 = 2.5;
  ViscoelasticMaterial material{{1, {{0.05 * l1 / unit, l1 / unit}}},
                                {0.4, {{0.4 * l1 / unit, l1 / unit}, {0.3 * l2 / unit, l2 / unit}}}};
  const MovingLoad load(material, speed, b);
  for (const double t : {1e-6, 0.02, 0.8, 4.0, 20.0}) {
    for (const double T : {-6.0, -1.2, -0.3, 0.013, 0.6, 3.0, 9.0}) {
      const double alpha = T - t;
      CAPTURE(t);
      CAPTURE(T);
      const auto memory = [&](double (*kernel)(double, Accuracy), double at, double rate) {
        return brute_force(kernel, at, t, rate);
      };
      double un = 1.4 * I1(alpha) + 0.45 * l1 * memory(I1, alpha, l1) + 0.3 * l2 * memory(I1, alpha, l2);
      CHECK(load.normal_displacement(t * unit, T * unit) ==
            doctest::Approx(un / pi).epsilon(1e-12).scale(1e-3));
      for (const double t0 : {-2.0, 0.4, 7.0}) {
        const double eta = t0 - t;
        double vn = 1.4 * I3(alpha) - 0.4 * I2(alpha) + 0.4 * I4(eta) - I5(eta);
        vn += 0.05 * l1 * (memory(I3, alpha, l1) - memory(I5, eta, l1));
        for (const auto& [amplitude, rate] : {std::pair(0.4 * l1, l1), std::pair(0.3 * l2, l2)}) {
          vn += amplitude *
                (memory(I3, alpha, rate) - memory(I2_as_kernel, alpha, rate) + memory(I4, eta, rate));
        }
        CHECK(load.tangential_displacement(t * unit, T * unit, t0 * unit) ==
              doctest::Approx(vn / pi).epsilon(1e-12).scale(0.1));
      }
    }
  }
}

TEST_CASE("the four cases meet") {
  const MovingLoad load(solid(0.7), 1, 1);
  constexpr double h = 1e-11;
  for (const double t : {0.3, 1.0, 5.0}) {
    CHECK(load.normal_displacement(t, h) ==
          doctest::Approx(load.normal_displacement(t, -h)).epsilon(1e-8));  // T = 0
    CHECK(load.normal_displacement(t, t + h) ==
          doctest::Approx(load.normal_displacement(t, t - h)).epsilon(1e-8));  // T = t, symmetric logarithm
    for (const double T : {-1.0, 0.2, 8.0}) {
      CHECK(load.tangential_displacement(t, T, h) ==
            doctest::Approx(load.tangential_displacement(t, T, -h)).epsilon(1e-8));  // t0 = 0
    }
    CHECK(load.tangential_displacement(t, h, 0.5) ==
          doctest::Approx(load.tangential_displacement(t, -h, 0.5)).epsilon(1e-8));
  }
  CHECK(load.normal_displacement(0, 0.3) ==
        doctest::Approx(1.5 * I1(0.3) / pi).epsilon(1e-15));  // no memory yet
}

TEST_CASE("fading memory: the start is forgotten like e^(-lambda t)") {
  const MovingLoad load(solid(2), 1, 1);
  for (const double alpha : {-3.0, -0.4, 0.2, 1.7}) {
    const auto forgotten = [&](double t) {
      return std::fabs(load.normal_displacement(t, t + alpha) - load.steady_normal_displacement(alpha));
    };
    CHECK(forgotten(30) <= 1e-13);
    CHECK(load.tangential_displacement(30, 30 + alpha, 29) ==
          doctest::Approx(load.steady_tangential_displacement(alpha, -1)).epsilon(1e-14));
  }
}

TEST_CASE("slow and fast relaxation: the two elastic limits, approached in first order") {
  for (const double alpha : {-2.5, -0.6, 0.3, 1.3}) {
    const double elastic = 1.5 * I1(alpha) / pi;
    const auto stiff = [&](double rate) {
      return std::fabs(MovingLoad(solid(rate), 1, 1).normal_displacement(4, 4 + alpha) - elastic);
    };
    const auto soft = [&](double rate) {
      return std::fabs(MovingLoad(solid(rate), 1, 1).normal_displacement(4, 4 + alpha) - 2 * elastic);
    };
    CHECK(stiff(1e-5) / stiff(1e-4) == doctest::Approx(0.1).epsilon(0.01));
    CHECK(soft(1e5) / soft(1e4) == doctest::Approx(0.1).epsilon(0.01));
    CHECK(stiff(1e-12) < 1e-11);
    CHECK(soft(1e12) < 1e-11);
  }
}

TEST_CASE("rates beyond any scale of the sheet neither overflow nor lose digits") {
  for (const double alpha : {-1e4, -300.0, -1.0, -1e-9, 1e-9, 1.0, 300.0, 1e4}) {
    for (const double rate : {1e-12, 1.0, 1e12}) {
      const MovingLoad load(solid(rate), 1, 1);
      const double un = load.steady_normal_displacement(alpha);
      CHECK(std::isfinite(un));
      CHECK(std::isfinite(load.normal_displacement(2e4, 2e4 + alpha)));
      if (std::fabs(alpha) > 200 && rate >= 1) CHECK(std::fabs(un) < 1e-120);
      if (rate == 1e12 && std::fabs(alpha) <= 1) {
        CHECK(un == doctest::Approx(3 * I1(alpha) / pi).epsilon(1 / std::fabs(alpha * 1e12)));
      }
    }
  }
}

TEST_CASE("a way too short to be seen beside the distance still counts") {
  const MovingLoad load(solid(1e25), 1, 1);
  for (const double T : {-2.5, -0.75, -0.4, 0.4, 0.75, 2.5}) {
    CHECK(load.normal_displacement(1e-25, T) ==
          doctest::Approx(1.5 * I1(T) * (2 - std::exp(-1.0)) / pi).epsilon(1e-14));
  }
}

TEST_CASE("a pair of complex rates: brute force again, and a pair that is nearly real is two real ones") {
  const std::complex<double> rate(0.8, 0.3), amplitude(0.2, 0.05);
  const std::vector<nipref::data::RelaxationTerm> pair{{amplitude, rate},
                                                       {std::conj(amplitude), std::conj(rate)}};
  const auto doubled = [](std::vector<nipref::data::RelaxationTerm> terms, double factor) {
    for (auto& term : terms) term.amplitude *= factor;
    return terms;
  };
  const MovingLoad load({{1, pair}, {0.5, doubled(pair, 0.5)}}, 1, 1);
  for (const double alpha : {-4.0, -1.0, -0.3, 0.02, 0.7, 2.5}) {
    for (const double t : {0.01, 0.7, 6.0}) {
      // Re and Im of e^(-rate d) by the real integral with its oscillation folded into the sum over quarters.
      const auto faded = [&](double w) {
        return w == 0 ? 0 : 2 * (amplitude * std::exp(-rate * (w - alpha))).real() * I1(w);
      };
      double sum = I1(alpha);
      std::vector<double> ends{alpha};
      for (const double cut : {-2.0, 0.0, 2.0}) {
        if (cut > alpha && cut < alpha + t) ends.push_back(cut);
      }
      ends.push_back(alpha + t);
      for (std::size_t i = 1; i < ends.size(); ++i) sum += integral(faded, ends[i - 1], ends[i]);
      CHECK(load.normal_displacement(t, t + alpha) ==
            doctest::Approx(1.5 * sum / pi).epsilon(1e-12).scale(1e-3));
    }
    const double steady = load.steady_normal_displacement(alpha);
    CHECK(load.normal_displacement(60, 60 + alpha) == doctest::Approx(steady).epsilon(1e-13));
  }
}

TEST_CASE("Maxwell's sheet flows for ever: the limit of slow rates, and the memory of its whole way") {
  const auto sheet = [](double rate) {
    return MovingLoad(ViscoelasticMaterial({1, {{0.6, rate}}}, {0.4, {{0.3, rate}}}), 1, 1);
  };
  const MovingLoad fluid = sheet(0), slow = sheet(1e-8);
  for (const double alpha : {-8.0, -1.0, -0.3, 0.02, 0.7, 2.5}) {
    // It falls short by rate times way.
    CHECK(fluid.steady_normal_displacement(alpha) ==
          doctest::Approx(slow.steady_normal_displacement(alpha)).epsilon(4e-7));
    for (const double eta : {-3.0, -0.4, 0.5, 6.0}) {
      CHECK(fluid.steady_tangential_displacement(alpha, eta) ==
            doctest::Approx(slow.steady_tangential_displacement(alpha, eta)).epsilon(1e-6).scale(1));
    }
    const double t = 2.5;
    const double un = 1.4 * I1(alpha) + 0.9 * brute_force(I1, alpha, t, 0);
    CHECK(fluid.normal_displacement(t, t + alpha) == doctest::Approx(un / pi).epsilon(1e-12));
  }
}

TEST_CASE("Kelvin's and Voigt's sheet gives way to nothing at once: its memory alone") {
  const MovingLoad load(ViscoelasticMaterial({0, {{0.6, 0.8}}}, {0, {{0.3, 0.8}}}), 1, 1);
  for (const double alpha : {-2.0, -0.3, 0.02, 0.7}) {
    CHECK(load.normal_displacement(1.5, 1.5 + alpha) ==
          doctest::Approx(0.9 * brute_force(I1, alpha, 1.5, 0.8) / pi).epsilon(1e-12));
    CHECK(load.normal_displacement(0, alpha) == 0);
  }
}

TEST_CASE("bad input to the moving load") {
  using nipref::data::BadInput;
  CHECK_THROWS_AS(MovingLoad(solid(1), 0, 1), BadInput);
  CHECK_THROWS_AS(MovingLoad(solid(1), -1, 1), BadInput);
  CHECK_THROWS_AS(MovingLoad(solid(1), 1, 0), BadInput);
  CHECK_THROWS_AS(MovingLoad(solid(1), 1, HUGE_VAL), BadInput);
  CHECK_THROWS_AS(MovingLoad(solid(-1), 1, 1), BadInput);
  const MovingLoad load(solid(1), 1, 1);
  CHECK_THROWS_AS(static_cast<void>(load.normal_displacement(2, 2)), BadInput);
  CHECK_THROWS_AS(static_cast<void>(load.normal_displacement(-1, 2)), BadInput);
  CHECK_THROWS_AS(static_cast<void>(load.normal_displacement(1, std::nan(""))), BadInput);
  CHECK_THROWS_AS(static_cast<void>(load.steady_normal_displacement(0)), BadInput);
  CHECK_THROWS_AS(static_cast<void>(load.tangential_displacement(1, 2, HUGE_VAL)), BadInput);
  CHECK_NOTHROW(static_cast<void>(load.tangential_displacement(2, 2, 2)));
  const MovingLoad far(solid(1), 90, 1e-12);
  CHECK_THROWS_WITH_AS(static_cast<void>(far.normal_displacement(1000, -1e308)),
                       "T = -1e+308: must be within 1e100 half_thickness/speed of both 0 and t", BadInput);
  CHECK_THROWS_WITH_AS(static_cast<void>(far.tangential_displacement(1, 2, -1e308)),
                       doctest::Contains("t0 = -1e+308: must be within 1e100"), BadInput);
  CHECK(load.normal_displacement(1e100, 1) == 0);
}

TEST_SUITE_END();
