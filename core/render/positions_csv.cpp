#include "core/render/positions_csv.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numbers>
#include <optional>

#include "core/base/atomic_file.h"
#include "core/base/system_error.h"

namespace bosk {
namespace {

constexpr std::uint64_t kMaxFileBytes = std::uint64_t(1) << 30;

// Where in the file we are, for messages.
struct Line {
  const std::string& name;
  std::size_t number;

  [[noreturn]] void refuse(const std::string& what) const {
    throw Error(printable(name) + ", line " + std::to_string(number) + ": " + what);
  }
};

std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \t\r");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r") + 1 - first);
}

// Up to the next comma outside quotes; the rest stays in `text`.
std::string next_field(std::string_view& text, const Line& line) {
  std::string field;
  bool quoted = false;
  std::size_t i = 0;
  for (; i < text.size() && (quoted || text[i] != ','); ++i) {
    if (text[i] == '"') {
      if (quoted && text.substr(i, 2) == "\"\"")
        field += text[i++];
      else
        quoted = !quoted;
    } else {
      field += text[i];
    }
  }
  if (quoted) line.refuse("a double quote is not closed: close it on the same line");
  text.remove_prefix(i);
  return std::string(trimmed(field));
}

std::vector<std::string> fields_of(std::string_view text, const Line& line) {
  std::vector<std::string> fields = {next_field(text, line)};
  while (!text.empty()) {
    text.remove_prefix(1);
    fields.push_back(next_field(text, line));
  }
  return fields;
}

// Which field holds what; none where the table has no such column.
struct Columns {
  std::size_t count = 0;
  std::optional<std::size_t> x, y, z, turn, scale, tree;
};

Columns columns_of(const std::vector<std::string>& header, const Line& line) {
  Columns columns;
  columns.count = header.size();
  const std::pair<const char*, std::optional<std::size_t>*> known[] = {
      {"x", &columns.x},           {"y", &columns.y},         {"z", &columns.z},
      {"turn_deg", &columns.turn}, {"scale", &columns.scale}, {"tree", &columns.tree}};
  for (std::size_t i = 0; i < header.size(); ++i) {
    for (const auto& [name, place] : known) {
      if (header[i] != name) continue;
      if (place->has_value()) line.refuse("two columns are named " + header[i] + ": leave one out");
      *place = i;
    }
  }
  if (!columns.x || !columns.y) {
    line.refuse(
        "no columns x and y: let the first line name the columns, such as x,y,turn_deg,scale");
  }
  return columns;
}

class Row {
 public:
  Row(const std::vector<std::string>& fields, const Columns& columns, const Line& line)
      : fields_(fields), line_(line) {
    if (fields.size() == columns.count) return;
    line.refuse("has " + std::to_string(fields.size()) + " fields where the first line names " +
                std::to_string(columns.count) + " columns");
  }

  // None where the column is missing or the field empty.
  std::optional<std::string> text(const std::optional<std::size_t>& column) const {
    if (!column || fields_[*column].empty()) return std::nullopt;
    return fields_[*column];
  }
  std::optional<double> number(const std::optional<std::size_t>& column, const char* name) const {
    const auto field = text(column);
    if (!field) return std::nullopt;
    double value = 0.0;
    const char* begin = field->data() + ((*field)[0] == '+' ? 1 : 0);
    const char* end = field->data() + field->size();
    const auto [rest, failure] = std::from_chars(begin, end, value);
    if (failure != std::errc() || rest != end || !std::isfinite(value)) {
      line_.refuse(std::string(name) + " is \"" + printable(*field) +
                   "\": give a number, with a point before decimals");
    }
    return value;
  }
  double needed_number(const std::optional<std::size_t>& column, const char* name) const {
    const auto value = number(column, name);
    if (!value) line_.refuse(std::string(name) + " is empty: give a number in metres");
    if (std::abs(*value) > 1e6) {
      line_.refuse(std::string(name) + " lies " + fields_[*column] +
                   " m away: subtract a common offset, so that places stay below 1000 km");
    }
    return *value;
  }

 private:
  const std::vector<std::string>& fields_;
  const Line& line_;
};

std::uint32_t tree_of(const std::optional<std::string>& field,
                      std::span<const std::string> tree_names, const Line& line) {
  if (!field) return 0;
  const auto named = std::find(tree_names.begin(), tree_names.end(), *field);
  if (named != tree_names.end()) return std::uint32_t(named - tree_names.begin());
  std::size_t number = 0;
  const char* end = field->data() + field->size();
  const auto [rest, failure] = std::from_chars(field->data(), end, number);
  if (failure != std::errc() || rest != end || number < 1 || number > tree_names.size()) {
    std::string known;
    for (const std::string& name : tree_names) known += (known.empty() ? "" : ", ") + name;
    line.refuse("tree is \"" + printable(*field) + "\": give a number from 1 to " +
                std::to_string(tree_names.size()) + ", or one of " + printable(known));
  }
  return std::uint32_t(number - 1);
}

TreeInstance instance_of(const Row& row, const Columns& columns, const Line& line,
                         std::span<const std::string> tree_names, const Terrain& terrain) {
  TreeInstance instance;
  instance.place.x = row.needed_number(columns.x, "x");
  instance.place.y = row.needed_number(columns.y, "y");
  const auto z = row.number(columns.z, "z");
  instance.place.z = z ? *z : height_at(terrain, instance.place.x, instance.place.y);
  instance.turn = row.number(columns.turn, "turn_deg").value_or(0.0) * std::numbers::pi / 180.0;
  instance.scale = row.number(columns.scale, "scale").value_or(1.0);
  if (instance.scale < 0.001 || instance.scale > 1000.0) {
    line.refuse("scale is " + *row.text(columns.scale) + ": give a number from 0.001 to 1000");
  }
  instance.tree = tree_of(row.text(columns.tree), tree_names, line);
  return instance;
}

}  // namespace

std::vector<TreeInstance> parse_positions(std::string_view text, const std::string& name,
                                          std::span<const std::string> tree_names,
                                          const Terrain& terrain) {
  constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";
  if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
  std::vector<TreeInstance> instances;
  std::optional<Columns> columns;
  for (std::size_t number = 1; !text.empty(); ++number) {
    const Line line{name, number};
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view content = trimmed(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
    if (content.empty() || content.front() == '#') continue;
    const std::vector<std::string> fields = fields_of(content, line);
    if (!columns) {
      columns = columns_of(fields, line);
      continue;
    }
    instances.push_back(
        instance_of(Row(fields, *columns, line), *columns, line, tree_names, terrain));
  }
  if (instances.empty()) {
    throw Error(printable(name) +
                ": holds no tree: name the columns in the first line, such as "
                "x,y, and give one tree a line after it");
  }
  return instances;
}

std::vector<TreeInstance> read_positions(const std::filesystem::path& path,
                                         std::span<const std::string> tree_names,
                                         const Terrain& terrain) {
  const std::vector<std::byte> bytes = read_file(path, kMaxFileBytes);
  return parse_positions({reinterpret_cast<const char*>(bytes.data()), bytes.size()}, path.string(),
                         tree_names, terrain);
}

}  // namespace bosk
