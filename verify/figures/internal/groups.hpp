#pragma once
#include <map>
#include <string>
#include <vector>

#include <nipref/verify/figures/figure.hpp>

namespace nipref::verify {

/// What a row of data/statements/figures.csv asks a drawing to show.
struct FigureSubject {
  std::string text;                ///< the row's field `of`
  std::vector<std::string> words;  ///< the words of that field
  std::vector<std::string> tables;

  [[nodiscard]] double number(std::size_t i) const { return std::stod(words.at(i)); }
};

/// The panels of each kind of figure, by its name in the column `drawing`.
using Drawings = std::map<std::string, std::vector<Panel> (*)(const FigureSubject&)>;

Drawings kernel_drawings();           ///< thesis 7-13
Drawings creep_range_drawing();       ///< thesis 15
Drawings elastic_load_drawing();      ///< thesis 17-25
Drawings elastic_profile_drawings();  ///< thesis 26-29
Drawings moving_load_drawings();      ///< thesis 32-38
Drawings rolling_drawings();          ///< thesis 41-53
Drawings stress_drawing();            ///< inside the sheet, thesis ch. III
Drawings half_space_drawings();       ///< behind the papers' tables

}  // namespace nipref::verify
