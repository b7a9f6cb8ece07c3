#include <nipref/ref/half_space/elliptic.hpp>

#include "support/isotropic_surface.hpp"
#include "support/test.hpp"

using namespace nipref;
using ref::Exact;

TEST_CASE("the reference's ellipse turns with a narrow peak of the compliance") {
  // K = 1 + 1/(gap + sin^2(psi - peak)). The ellipse of a sphere turns with the peak.
  const auto peaked = [](double gap, const Exact& peak) -> ref::SurfaceAnswer {
    return [=](const Exact& degrees, int digits) -> ref::LineAnswer {
      const ref::WorkingDigits working(digits + 20);
      const ref::Float off = ref::to_float(Exact(mpq_class(degrees.value() - peak.value())));
      const ref::Float s = sin(off * ref::pi() / 180), none = 0;
      const ref::Float compliance = 1 + 1 / (gap + s * s);
      return {compliance, none, none, none};
    };
  };
  for (const double gap : {1e-2, 1e-6, 1e-9}) {
    const auto along = ref::elliptic_axis_ratio(peaked(gap, Exact(0.0)), Exact(1.0), 20);
    const auto askew = ref::elliptic_axis_ratio(peaked(gap, Exact::parse("33.3")), Exact(1.0), 20);
    CHECK(along.to_double() < 1);
    CHECK(along.to_double() == doctest::Approx(askew.to_double()).epsilon(1e-15));
  }
}

TEST_CASE("the reference's search for an ellipse asks for no more lines than it did") {
  struct Scene {
    double speed, curvature_ratio;
    int most;
  };
  for (const auto& [speed, curvature_ratio, most] :
       {Scene{1e-30, 1, 120}, Scene{1e-30, 1e-6, 350}, Scene{0.8, 1, 210}, Scene{0.8, 1e4, 670}}) {
    CAPTURE(speed, curvature_ratio);
    int lines = 0;
    const ref::SurfaceAnswer surface = isotropic_surface(0.25, speed);
    const ref::SurfaceAnswer counted = [&](const Exact& degrees, int digits) {
      ++lines;
      return surface(degrees, digits);
    };
    static_cast<void>(ref::elliptic_axis_ratio(counted, Exact(curvature_ratio), 20));
    CHECK(lines <= most);
  }
}

TEST_CASE("what the reference cannot make an ellipse of is refused by name") {
  const auto surface = isotropic_surface(0.25, 1e-30);
  const auto refused = [](const ref::SurfaceAnswer& answer, const Exact& ratio, const char* name) {
    CHECK_REFUSED(ref::elliptic_axis_ratio(answer, ratio, 18), name);
    CHECK_REFUSED(ref::elliptic_stiffness(answer, ratio, 18), name);
  };
  refused(surface, Exact(0.0), "curvature_ratio = 0");
  refused(surface, Exact::parse("1.1e12"), "curvature_ratio = 1100000000000");
  refused(surface, Exact::parse("1e-5000"), "curvature_ratio = 1e-5000");
  const ref::SurfaceAnswer no_number = [&](const Exact& degrees, int digits) {
    ref::LineAnswer line = surface(degrees, digits);
    mpfr_set_nan(ref::raw(line.compliance));
    return line;
  };
  refused(no_number, Exact(1.0), "surface = nan");
  // A surface whose response is not a smooth function of the direction.
  const ref::SurfaceAnswer broken = [&](const Exact& degrees, int digits) {
    ref::LineAnswer line = surface(degrees, digits);
    if (degrees.value() > 33) line.compliance /= 2;
    return line;
  };
  const ref::EllipticContact contact(surface, {Exact(1.0), Exact(1.0)}, data::GivenSpan{1}, 18);
  CHECK_REFUSED(contact.displacement(broken, Exact(0.0)), "surface = (as given)");
  CHECK_REFUSED(contact.displacement(surface, Exact(-1.0)), "depth = -1");
}

TEST_CASE("displacements of many places take the reference no more lines than that of one") {
  int lines = 0;
  const ref::SurfaceAnswer surface = isotropic_surface(0.25, 0.5);
  const ref::SurfaceAnswer counted = [&](const Exact& degrees, int digits) {
    ++lines;
    return surface(degrees, digits);
  };
  const ref::EllipticContact contact(surface, {Exact(1.0), Exact(3.0)}, data::GivenSpan{1}, 16);
  const auto displacement = contact.displacement(counted, Exact(0.0));
  const int before = lines;
  CHECK(before < 400);
  const ref::Estimate first = displacement(Exact(0.0), Exact(0.0))[2],
                      farther = displacement(Exact(70.0), Exact(2.0))[2];
  CHECK(farther.to_double() < first.to_double());
  CHECK(lines == before);
}
