#include <fstream>

#include <nipref/data/scene/file.hpp>
#include <nipref/data/table/index.hpp>
#include <nipref/verify/catalogue/arguments.hpp>
#include <nipref/verify/catalogue/axes.hpp>
#include <nipref/verify/catalogue/catalogue.hpp>
#include <nipref/verify/catalogue/ranges.hpp>
#include <nipref/verify/cli/run_folder.hpp>
#include <nipref/verify/golden/check.hpp>
#include <nipref/verify/golden/golden.hpp>
#include <nipref/verify/grade/baseline.hpp>
#include <nipref/verify/grade/measured_points.hpp>
#include <nipref/verify/report/report.hpp>

#include "reading.hpp"

// Readers of files and of words. Each program is built for one of them, NIPREF_READER.

using namespace nipref;

namespace readers {

void scene(const std::string& text, const GivenFile&) {
  take_or_refuse([&] { static_cast<void>(data::parse_scene(text, "given")); });
  take_or_refuse([&] { static_cast<void>(data::scene_sweep({"given", text})); });
}

void table(const std::string&, const GivenFile& file) {
  take_or_refuse([&] { static_cast<void>(data::summarize(data::load_table(file.path()))); });
}

/// The given text is the errata of a folder with one table, the working folder of the run.
void errata(const std::string& text, const GivenFile&) {
  static const std::string table = "thesis-VIII.csv", errata = "errata.csv";
  static const bool is_there = std::filesystem::copy_file(data::tables_directory() / table, table,
                                                          std::filesystem::copy_options::overwrite_existing);
  if (!is_there) std::abort();
  std::ofstream(errata, std::ios::binary) << text;
  take_or_refuse([&] { static_cast<void>(data::summarize(data::load_table(table))); });
  take_or_refuse([&] { static_cast<void>(data::load_known_misses(errata)); });
}

/// The given text is a file of golden values, and the checksums of a folder of them, the working folder of the run.
void golden(const std::string& text, const GivenFile&) {
  std::ofstream(verify::checksums_name, std::ios::binary) << text;
  take_or_refuse([&] { static_cast<void>(verify::checksums_text(verify::checksums_of("."))); });
  take_or_refuse([&] {
    const verify::GoldenFile file = verify::read_golden(verify::checksums_name);
    for (const verify::GoldenRow& row : file.rows) static_cast<void>(row.number());
    static_cast<void>(verify::golden_text(file));
  });
}

/// Golden files are files of measured points too: they name their quantity and have a column of values.
void measured_points(const std::string&, const GivenFile& file) {
  take_or_refuse([&] { static_cast<void>(verify::read_measured_points(file.path(), {}, {})); });
  take_or_refuse([&] { static_cast<void>(verify::read_measured_points(file.path(), "I6", "value")); });
}

void baseline(const std::string&, const GivenFile& file) {
  take_or_refuse([&] { static_cast<void>(verify::Baseline::read(file.path()).text()); });
}

/// An older report is compared with itself. The comparison must cope with any content.
void report(const std::string& text, const GivenFile&) {
  if (verify::is_report(text))
    static_cast<void>(verify::comparison_json(verify::compare_reports(text, text)));
}

/// The text behind a name and '=' on a command line.
void numbers(const std::string& text, const GivenFile&) {
  constexpr double a_third = 1.0 / 3;
  take_or_refuse([&] { static_cast<void>(verify::parse_range("alpha", text).at(a_third)); });
  take_or_refuse([&] { static_cast<void>(verify::axis_of("alpha", text, 5)); });
  take_or_refuse([&] { static_cast<void>(verify::parse_integer("digits", text)); });
  take_or_refuse([&] { static_cast<void>(verify::parse_real("rtol", text)); });
  take_or_refuse([&] { static_cast<void>(verify::parse_shard(text)); });
  take_or_refuse([&] {
    const verify::Quantity& quantity = verify::find_quantity("I6");
    const verify::ParsedArguments arguments =
        verify::parse_arguments(quantity, {{"alpha", text}, {"eta", text}});
    static_cast<void>(arguments.exact.front().text());
    static_cast<void>(arguments.exact.front().log2_magnitude());
    static_cast<void>(arguments.nearest(quantity));
  });
}

}  // namespace readers

void read_given(const std::string& text, const GivenFile& file) { readers::NIPREF_READER(text, file); }
