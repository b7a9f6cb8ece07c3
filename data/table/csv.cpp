#include <istream>

#include <nipref/data/input_file.hpp>
#include <nipref/data/internal/common.hpp>
#include <nipref/data/table/csv.hpp>

namespace nipref::data {
namespace {

/// Cuts one line into fields.
class LineReader {
 public:
  LineReader(const std::filesystem::path& path, std::string_view line, std::size_t number)
      : path_(path), line_(line), number_(number) {}

  std::vector<CsvField> fields() {
    std::vector<CsvField> result;
    while (true) {
      result.push_back(line_.substr(next_).starts_with('"') ? quoted() : bare());
      if (next_ == line_.size()) return result;
      if (line_[next_] != ',')
        refuse(path_, here(), "must have a comma or the end of line after a closing quote");
      ++next_;
    }
  }

 private:
  [[nodiscard]] TextPosition here() const { return {number_, next_ + 1}; }

  CsvField bare() {
    const TextPosition start = here();
    const std::size_t end = std::min(line_.find(',', next_), line_.size());
    const std::string_view text = line_.substr(next_, end - next_);
    if (text.find('"') != text.npos) refuse(path_, start, "must have its quotes around the whole field");
    next_ = end;
    return {std::string(text), start};
  }

  CsvField quoted() {
    CsvField field{"", here()};
    ++next_;
    while (true) {
      const std::size_t quote = line_.find('"', next_);
      if (quote == line_.npos) refuse(path_, field.position, "must close its quote on the same line");
      field.text += line_.substr(next_, quote - next_);
      next_ = quote + 1;
      if (!line_.substr(next_).starts_with('"')) return field;
      field.text += '"';
      ++next_;
    }
  }

  const std::filesystem::path& path_;
  std::string_view line_;
  std::size_t number_;
  std::size_t next_ = 0;
};

void add_comment(CsvFile& file, std::string_view line, std::size_t number) {
  if (!file.records.empty())
    refuse(file.path, {number, 1}, "must have its comment lines above the column names");
  if (!line.starts_with("# ")) refuse(file.path, {number, 2}, "must have a blank after #");
  file.comments.push_back({std::string(line.substr(2)), {number, 3}});
}

/// A hint for the files of spreadsheets that write decimal commas and separate fields by semicolons.
constexpr auto other_separators = "fields are separated by commas, numbers have decimal points";

void add_record(CsvFile& file, std::string_view line, std::size_t number) {
  file.records.push_back(LineReader(file.path, line, number).fields());
  const auto& record = file.records.back();
  const std::size_t expected = file.records.front().size();
  if (record.size() == expected) {
    if (file.records.size() == 1 && expected == 1 && line.find(';') != line.npos)
      refuse(file.path, {number, line.find(';') + 1},
             fmt::format("must have no semicolon: {}", other_separators));
    return;
  }
  refuse(file.path, record[std::min(record.size(), expected + 1) - 1].position,
         fmt::format("must have {} fields in each record, has {}: {}", expected, record.size(),
                     other_separators));
}

}  // namespace

void refuse(const std::filesystem::path& path, TextPosition position, std::string_view requirement) {
  throw BadInput("file", fmt::format("{}:{}:{}", path.string(), position.line, position.column), requirement);
}

namespace {

constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";

/// Reads the lines of a stream, without the characters that end them.
class Lines {
 public:
  Lines(std::istream& stream, const std::filesystem::path& path)
      : stream_(stream), path_(path), buffer_(longest_csv_line + 1) {}

  bool next(std::string& line, std::size_t number) {
    stream_.getline(buffer_.data(), static_cast<std::streamsize>(buffer_.size()));
    auto length = static_cast<std::size_t>(stream_.gcount());
    if (stream_.fail() && length + 1 == buffer_.size())
      refuse(path_, {number, longest_csv_line + 1},
             fmt::format("must have lines of at most {} bytes", longest_csv_line));
    if (stream_.fail()) return false;
    if (!stream_.eof()) --length;  // gcount() includes the end of the line
    line.assign(buffer_.data(), length);
    return true;
  }

 private:
  std::istream& stream_;
  const std::filesystem::path& path_;
  std::vector<char> buffer_;
};

}  // namespace

CsvFile read_csv(const std::filesystem::path& path) {
  CsvFile file{path, {}, {}};
  std::ifstream stream = open_input_file(path, "file");
  Lines lines(stream, path);
  std::string line;
  for (std::size_t number = 1; lines.next(line, number); ++number) {
    if (number > most_csv_lines)
      refuse(path, {number, 1}, fmt::format("must have at most {} lines", most_csv_lines));
    if (number == 1 && line.starts_with(byte_order_mark)) line.erase(0, byte_order_mark.size());
    if (line.ends_with('\r')) line.pop_back();
    if (line.empty()) refuse(path, {number, 1}, "must have no blank lines");
    if (line.starts_with('#')) {
      add_comment(file, line, number);
    } else {
      add_record(file, line, number);
    }
  }
  if (stream.bad()) refuse(path, {1, 1}, "must be a readable file");
  if (file.records.empty()) refuse(path, {1, 1}, "must name its columns");
  return file;
}

}  // namespace nipref::data
