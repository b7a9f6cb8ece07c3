#include "support/run_nipref.hpp"

using nlohmann::json;

TEST_CASE("solve --full tells the thesis's search: each length by (2.13), the last load met") {
  struct Search {
    const char* scene;
    double load, tolerance;
  };
  for (const auto& [scene, load, tolerance] :
       {Search{"thick-frictionless-line-loads load.per_length=100", 100, 2e-3},
        Search{"intermediate-full-friction-line-loads", 100, 2e-3},
        Search{"viscoelastic-thesis-line-loads load.per_length=50", 50, 1e-2}}) {
    CAPTURE(scene);
    const json steps = answer_to(std::string("solve --full ") + scene).at("search");
    REQUIRE(steps.size() > 1);
    for (std::size_t i = 0; i < steps.size(); ++i) {
      const double excess = steps[i].at("load").get<double>() / load;
      CHECK((std::fabs(excess - 1) <= tolerance) == (i + 1 == steps.size()));
      if (i + 1 == steps.size()) break;
      const double next = steps[i].at("contact_length").get<double>() / std::cbrt(excess);
      CHECK(steps[i + 1].at("contact_length").get<double>() == doctest::Approx(next).epsilon(1e-14));
    }
  }
}
