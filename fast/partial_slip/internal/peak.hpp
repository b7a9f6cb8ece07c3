#pragma once
#include <nipref/fast/partial_slip/internal/zone_contact.hpp>

namespace nipref::fast {

struct Peak {
  double size, e;
};

/// The largest size of a traction in the contact and where it is.
Peak peak(const ZoneContact& contact, double ZoneContact::Traction::*part);

}  // namespace nipref::fast
