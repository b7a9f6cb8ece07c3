#pragma once

namespace nipref::data {

/// Which derivative of a function of one variable.
enum class Derivative { first, second };

}  // namespace nipref::data
