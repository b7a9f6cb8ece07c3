#include <nipref/verify/report/report.hpp>

#include "reading.hpp"

using namespace nipref;

/// An older report is compared with itself: whatever is in it, nothing but texts comes of it.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string older(reinterpret_cast<const char*>(data), size);
  if (verify::is_report(older))
    static_cast<void>(verify::comparison_json(verify::compare_reports(older, older)));
  return 0;
}
