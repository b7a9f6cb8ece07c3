#include <algorithm>
#include <span>
#include <utility>

#include <nipref/data/bad_input.hpp>
#include <nipref/ref/half_space/internal/smooth_lines.hpp>

namespace nipref::ref {
namespace {

Float size_of(std::span<const ComplexFloat> numbers) {
  Float largest;
  for (const ComplexFloat& each : numbers) largest = std::max(largest, abs(each));
  return largest;
}

bool agree(const SmoothLines::Line& found, const SmoothLines::Line& truth, int digits) {
  SmoothLines::Line off;
  for (std::size_t i = 0; i < truth.size(); ++i) off.push_back(found[i] - truth[i]);
  const auto is_small = [&](auto part) {
    return size_of(part(std::span(off))) <= tolerance(digits) * size_of(part(std::span(truth)));
  };
  return is_small([](auto all) { return all.first(3); }) && is_small([](auto all) { return all.subspan(3); });
}

}  // namespace

SmoothLines::SmoothLines(const WorkingSurface& surface, const PeakOfCompliance& peak, bool with_decay,
                         int digits)
    : centre_(peak.degrees * pi() / 180), width_(peak.width), last_(asinh(Float(pi() / 2 / width_))) {
  const auto line = [&](const Float& v) {
    const Exact off = to_exact(Float(width_ * sinh(v) * 180 / pi()));
    const LineAnswer y = surface.at(Exact(mpq_class(Exact(peak.degrees).value() + off.value())));
    Line found{
        {y.shear_compliance, y.coupling}, {y.shear_compliance_across, y.coupling_across}, y.compliance};
    if (!with_decay) return found;
    const Decay& decay = y.decay.value();
    for (std::size_t k = 0; k < 9; ++k) found.emplace_back(decay.re[k], decay.im[k]);
    return found;
  };
  const auto panels = static_cast<long>(ceil(Float(2 * last_)));
  for (long i = 0; i < panels; ++i)
    add_panels((Float(2 * i) / panels - 1) * last_, (Float(2 * i + 2) / panels - 1) * last_, digits, line);
}

template <class Of>
void SmoothLines::add_panels(const Float& left, const Float& right, int digits, const Of& line) {
  // On a panel of length 1 the polynomial converges like (pi + sqrt(pi^2 + 1))^-count = 10^(-0.81 count). The lines between
  // its own are compared in every fifth gap, the first and the last included.
  constexpr int gaps = 5;
  const int count = gaps * static_cast<int>((digits + 4) / (0.75 * gaps)) + 1;
  const Float middle = (left + right) / 2, half = (right - left) / 2;
  if (half < Float(1e-4))
    throw data::BadInput("surface", "(as given)", "must be smooth from line to line, to all its digits");
  const auto place = [&](int twice) -> Float { return middle - half * cos(pi() * twice / (2 * count)); };
  Panel panel{right, {}, {}};
  for (int k = 0; k <= count; ++k) {
    panel.places.push_back(place(2 * k));
    panel.lines.push_back(line(panel.places.back()));
  }
  for (int k = 0; k < count; k += gaps) {
    const Float between = place(2 * k + 1);
    if (agree(panel.at(between), line(between), digits)) continue;
    add_panels(left, middle, digits, line);
    return add_panels(middle, right, digits, line);
  }
  panels_.push_back(std::move(panel));
}

/// By the barycentric formula, whose weights at Chebyshev's points are 1 by turns of sign, and half at the ends.
SmoothLines::Line SmoothLines::Panel::at(const Float& v) const {
  Line sum(lines[0].size());
  Float total, scratch;
  for (std::size_t k = 0; k < places.size(); ++k) {
    const Float off = v - places[k];
    if (off == Float(0)) return lines[k];
    const bool is_end = k == 0 || k + 1 == places.size();
    const Float weight = (k % 2 == 0 ? 1 : -1) / (is_end ? Float(2 * off) : off);
    total += weight;
    for (std::size_t i = 0; i < sum.size(); ++i) {
      add_product(sum[i].re, scratch, weight, lines[k][i].re);
      add_product(sum[i].im, scratch, weight, lines[k][i].im);
    }
  }
  for (ComplexFloat& each : sum) each = each / total;
  return sum;
}

Float SmoothLines::v(const Float& angle) const {
  const Float off = angle - centre_;
  return asinh(Float((off - pi() * round(Float(off / pi()))) / width_));
}

SmoothLines::Line SmoothLines::at(const Float& v) const {
  const auto panel = std::ranges::find_if(panels_, [&](const Panel& each) { return v <= each.right; });
  return (panel == panels_.end() ? panels_.back() : *panel).at(v);
}

}  // namespace nipref::ref
