#include "data/scene_results.hpp"

#include <algorithm>
#include <array>

namespace nipref::data {
namespace {

constexpr std::array results{
    SceneResult{"contact_length", "length", "length L of the contact", false},
    SceneResult{"leading_length", "length",
                "contact L1 ahead of the line through the rollers' centres, on the entry side", false},
    SceneResult{"trailing_length", "length",
                "contact L2 = L - L1 behind that line; negative if all of it is ahead", false},
    SceneResult{"load", "force/length", "load W per unit width", false},
    SceneResult{"indentation", "length", "approach d0 of roller and middle plane", false},
    SceneResult{"edge_displacement", "length",
                "normal displacement d1 = d0 - L1^2/(2R) at the leading end of the contact", false},
    SceneResult{"trailing_displacement", "length", "the same d2 = d0 - L2^2/(2R) at its trailing end", false},
    SceneResult{"rolling_resistance", "1", "moment of the pressure over W R: resistance over load", false},
    SceneResult{"creep_ratio", "1",
                "strain v' of the surface in the contact; without friction its mean, (v(L1) - v(-L2))/L",
                false},
    SceneResult{"peak_pressure", "stress", "largest pressure", false},
    SceneResult{"peak_shear", "stress", "largest magnitude of the shear", false},
    SceneResult{"pressure", "stress", "pressure", true},
    SceneResult{"shear", "stress", "shear on the sheet along Y", true},
    SceneResult{"normal_displacement", "length", "displacement u towards the middle plane", true},
    SceneResult{"tangential_displacement", "length",
                "displacement v along Y, relative to the line through the rollers' centres", true},
};

}  // namespace

std::span<const SceneResult> scene_results() { return results; }

const SceneResult* find_scene_result(std::string_view name) {
  const auto found = std::ranges::find(results, name, &SceneResult::name);
  return found == results.end() ? nullptr : &*found;
}

}  // namespace nipref::data
