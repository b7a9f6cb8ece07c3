#pragma once

namespace nipref::data {

/// Line loads of unit intensity on a sheet, one on each face at the same place: pressing against each other, or both
/// along the sheet in the direction in which its length is counted. (thesis 3.14, 3.15)
enum class SheetLoad { normal, shear };

/// Which derivative of a function of one variable.
enum class Derivative { first, second };

}  // namespace nipref::data
