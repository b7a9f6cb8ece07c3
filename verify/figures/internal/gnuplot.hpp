#pragma once
#include <string>

#include <nipref/verify/support/internal/template.hpp>

namespace nipref::verify {

/// What has gnuplot draw what figure_json gives; of what panel_json gives a drawing without a caption, small enough for a
/// page: readable at half the width of a sheet of paper and on a telephone.
std::string gnuplot_script(const TemplateData& drawing);

}  // namespace nipref::verify
