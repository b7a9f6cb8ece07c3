#include <algorithm>
#include <cmath>

#include <nipref/fast/number/internal/chebyshev.hpp>
#include <nipref/fast/viscoelastic_nip/internal/layout.hpp>

namespace nipref::fast {

double ViscoelasticPanel::xi(double x) const { return at_end() ? std::sqrt(x) : x; }

ViscoelasticLayout::ViscoelasticLayout(double half_length, const std::vector<int>& pieces, int terms)
    : half_length_(half_length), terms_(terms) {
  const auto panels = static_cast<int>(pieces.size() / 2);
  for (int p = 0; p < 2 * panels; ++p) {
    const Half half = p < panels ? Half::leading : Half::trailing;
    const int i = half == Half::leading ? p : 2 * panels - 1 - p;
    const double right = std::ldexp(half_length, i + 1 - panels), left = i == 0 ? 0 : right / 2;
    const int count = pieces[static_cast<std::size_t>(p)];
    // From left to twice that: differences between neighbours are exact, and leave no gap.
    const auto cut = [&](int k) { return k == count ? right : left + (right - left) * k / count; };
    for (int k = 0; k < count; ++k) {
      const int at = half == Half::leading ? k : count - 1 - k;
      panels_.push_back({half, cut(at), cut(at + 1) - cut(at)});
    }
  }
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
  // The innermost that begins before it: where it ends, rounding may have put the place beyond.
  std::size_t found = 0;
  double nearest = -1;
  for (std::size_t p = 0; p < panels_.size(); ++p) {
    const ViscoelasticPanel& panel = panels_[p];
    if (panel.half != place.half || panel.left > std::max(place.e, 0.0) || panel.left <= nearest) continue;
    found = p;
    nearest = panel.left;
  }
  return found;
}

}  // namespace nipref::fast
