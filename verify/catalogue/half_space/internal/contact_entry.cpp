#include <algorithm>
#include <utility>

#include <nipref/fast/half_space/isotropic.hpp>
#include <nipref/verify/catalogue/half_space/internal/contact_entry.hpp>

namespace nipref::verify {

Quantity contact_entry(std::string name, std::string definition, std::string source, double promise) {
  Quantity entry;
  entry.name = std::move(name);
  entry.definition = std::move(definition);
  entry.source = std::move(source);
  entry.scale = "the value";
  entry.promise = promise;
  entry.envelope = [](Doubles) { return 0.0; };
  entry.audit_points = 20;
  entry.is_costly = true;
  return entry;
}

std::vector<Argument> isotropic_arguments() {
  return {{"poisson", ArgumentKind::poisson, {}, {}}, {"speed", ArgumentKind::nonnegative, {}, {}}};
}

void draw_isotropic(Quantity& entry, double largest_share, std::function<Point(Random&)> more) {
  entry.draw = [=, more = std::move(more)](Random& random) {
    const double poisson = random.uniform(-0.5, 0.49);
    const double share =
        random.chance(0.5) ? 1 - random.log_uniform(1 - largest_share, 1) : random.uniform(0, largest_share);
    Point x{poisson, share * fast::isotropic_rayleigh_speed(poisson)};
    const Point rest = more(random);
    x.insert(x.end(), rest.begin(), rest.end());
    return x;
  };
  entry.keep_off = [=](Point& x) {
    x[0] = std::clamp(x[0], -0.5, 0.49);
    x[1] = std::min(x[1], largest_share * fast::isotropic_rayleigh_speed(x[0]));
  };
}

double draw_angle(Random& random) { return random.uniform(-90, 90); }
double draw_friction(Random& random) { return random.chance(0.2) ? 0 : random.uniform(0, 1); }

}  // namespace nipref::verify
