#pragma once
#include <nipref/fast/elastic_nip/line_loads.hpp>

namespace nipref::fast {

/// The sheet under loads across its faces and, if it is gripped, along them.
LineLoadSheet elastic_sheet(const data::ElasticNip& nip, const LineLoadMethod& method, bool sticks);

}  // namespace nipref::fast
