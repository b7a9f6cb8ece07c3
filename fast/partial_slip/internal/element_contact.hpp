#pragma once
#include <vector>

#include <nipref/fast/partial_slip/internal/zones.hpp>

namespace nipref::fast {

/// A contact of equal elements with constant tractions, for line loads, held to the rollers at their middles. In steady
/// rolling the slip of an element is the change of the displacement against the roller from the middle of the element
/// before it to its own middle. An active-set method finds the elements that press, stick or slip.
struct ElementContact {
  struct Element {
    double e;  ///< place of its middle, from the line through the rollers' centres along the motion
    bool presses;
    int sign;                ///< as a Zone's
    double pressure, shear;  ///< 0 if it does not press
  };
  std::vector<Element> elements;
  double width, creep, approach;
  bool settled;  ///< whether all conditions are met
};

/// Half the total width of the elements, over half the length of the contact without friction.
inline constexpr double element_reach = 1.3;

/// The contact with so many elements, for a given load. In rare cases it does not settle; its last state is returned.
ElementContact element_contact(const PartialSlipTask& task, int elements);

}  // namespace nipref::fast
