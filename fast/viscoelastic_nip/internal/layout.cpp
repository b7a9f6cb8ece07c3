#include <algorithm>
#include <cmath>

#include <nipref/fast/number/internal/chebyshev.hpp>
#include <nipref/fast/viscoelastic_nip/internal/layout.hpp>

namespace nipref::fast {

double ViscoelasticPanel::xi(double x) const { return at_end() ? std::sqrt(x) : x; }

ViscoelasticLayout::ViscoelasticLayout(double half_length, int panels, int terms)
    : half_length_(half_length), terms_(terms) {
  const auto append = [&](Half half, int i) {
    const double right = std::ldexp(half_length, i + 1 - panels);
    const double left = i == 0 ? 0 : right / 2;
    panels_.push_back({half, left, right - left});
  };
  for (int i = 0; i < panels; ++i) append(Half::leading, i);
  for (int i = panels - 1; i >= 0; --i) append(Half::trailing, i);
}

void ViscoelasticLayout::pressure_basis(const ViscoelasticPanel& panel, double xi,
                                        std::vector<double>& values) const {
  values.resize(static_cast<std::size_t>(terms_));
  internal::shifted_chebyshev(panel.x(xi), values);
  if (!panel.at_end()) return;
  for (double& value : values) value *= xi;
}

std::vector<ContactPlace> ViscoelasticLayout::matching_points() const {
  std::vector<ContactPlace> points;
  for (const ViscoelasticPanel& panel : panels_) {
    const int count = terms_ + (panel.at_end() ? 1 : 0);
    for (int i = 0; i < count; ++i) {
      const double x = internal::shifted_chebyshev_zero(i, count);
      points.push_back({panel.half, panel.left + panel.width * x});
    }
  }
  return points;
}

std::size_t ViscoelasticLayout::panel_of(ContactPlace place) const {
  const auto found = std::ranges::find_if(panels_, [&](const ViscoelasticPanel& panel) {
    return panel.half == place.half && panel.left <= place.e && place.e <= panel.left + panel.width;
  });
  return static_cast<std::size_t>(found - panels_.begin());
}

}  // namespace nipref::fast
