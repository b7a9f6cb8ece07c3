#pragma once
#include <vector>

#include <nipref/data/problem/viscoelastic_nip.hpp>

namespace nipref::fast {

/// The thesis's discretisation of the viscoelastic nip: line loads at the centres of equal elements that
/// started, all at once, `approach` before the first matching point came into the nip. (thesis 2.2, 7.2)
struct ViscoelasticLineLoadMethod {
  int leading_elements;   ///< m1, >= 1; at most 500
  int trailing_elements;  ///< m2, >= 0; at most 500
  double approach;        ///< C_L, half-thicknesses, > 0
  int residue_terms;      ///< of the plain sums, 1 to 500; 0: exact kernels
  /// Of theta1 + theta2 at once, 0 to 1: the plain sum after the load has passed ends with its first term below it.
  double smallest_term = 0;

  /// BadInput unless all are in their domains.
  void check() const;
};

struct ViscoelasticLineLoads {
  double leading_length;         ///< L1, unit of length
  double trailing_length;        ///< L2
  double indentation;            ///< d0
  double leading_displacement;   ///< d1 = d0 - L1^2/(2R)
  double trailing_displacement;  ///< d2 = d0 - L2^2/(2R)
  double load;                   ///< W, force per unit width
  double peak_pressure;          ///< largest load over its element's width, unit of stress
  double rolling_resistance;     ///< (7.15), dimensionless
  int systems;                   ///< linear systems solved on the way here
  std::vector<double> loads;     ///< P_j from the leading end on, force per unit width

  [[nodiscard]] double contact_length() const { return leading_length + trailing_length; }
  [[nodiscard]] double element_width() const { return contact_length() / static_cast<double>(loads.size()); }
  /// (2.1): no tension.
  [[nodiscard]] bool presses_everywhere() const;
};

/// (7.6)-(7.11) for a given leading length L1, > 0 and at most the roller's radius; otherwise BadInput.
ViscoelasticLineLoads viscoelastic_line_loads_for_length(const data::ViscoelasticNip& nip,
                                                         const ViscoelasticLineLoadMethod& method,
                                                         double leading_length);

/// The same with the length that carries `load`, found by secants of ln(load) over ln(length) to 1e-10 of the load; > 0, otherwise
/// BadInput.
ViscoelasticLineLoads viscoelastic_line_loads_for_load(const data::ViscoelasticNip& nip,
                                                       const ViscoelasticLineLoadMethod& method, double load);

/// The thesis's search for m2: from m1 down to the first that leaves no tension at `load`;
/// method.trailing_elements is not used. (thesis 2.5)
ViscoelasticLineLoads viscoelastic_line_loads_by_search(const data::ViscoelasticNip& nip,
                                                        ViscoelasticLineLoadMethod method, double load);

/// (v(L1) - v(-L2))/L, v relative to the point of the middle plane on the line through the rollers' centres;
/// dimensionless. (thesis 7.16, 7.17)
double creep_ratio(const data::ViscoelasticNip& nip, const ViscoelasticLineLoads& loads,
                   const ViscoelasticLineLoadMethod& method);

}  // namespace nipref::fast
