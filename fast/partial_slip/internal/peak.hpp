#pragma once
#include <vector>

#include <nipref/fast/partial_slip/internal/zone_contact.hpp>

namespace nipref::fast {

struct Peak {
  double size, e;
};

/// The local maxima of a traction's size in the contact, and its size at the boundaries of zones, where it may have cusps.
std::vector<Peak> peaks(const ZoneContact& contact, double ZoneContact::Traction::*part);

Peak largest(const std::vector<Peak>& peaks);

}  // namespace nipref::fast
