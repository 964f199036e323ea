#include "core/project/html.h"

namespace bosk {
namespace {

std::string row(const std::vector<std::string>& cells, const std::string& tag) {
  const std::string begin = "<" + tag + ">", end = "</" + tag + ">";
  std::string text = "<tr>";
  for (const std::string& cell : cells) text.append(begin).append(html_text(cell)).append(end);
  return text + "</tr>\n";
}

}  // namespace

std::string html_text(const std::string& text) {
  std::string safe;
  for (const char c : text) {
    if (c == '&')
      safe += "&amp;";
    else if (c == '<')
      safe += "&lt;";
    else if (c == '>')
      safe += "&gt;";
    else if (c == '"')
      safe += "&quot;";
    else
      safe += c;
  }
  return safe;
}

std::string base64(std::span<const std::byte> bytes) {
  static constexpr char kDigits[] =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  const auto at = [&](std::size_t i) { return i < bytes.size() ? unsigned(bytes[i]) : 0u; };
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const unsigned group = at(i) << 16 | at(i + 1) << 8 | at(i + 2);
    for (int digit = 0; digit < 4; ++digit) {
      const bool used = i + std::size_t(digit) <= bytes.size();
      text += used ? kDigits[group >> (18 - 6 * digit) & 63] : '=';
    }
  }
  return text;
}

std::string data_url(const std::string& kind, std::span<const std::byte> bytes) {
  return "data:image/" + kind + ";base64," + base64(bytes);
}

std::string html_table(const std::vector<std::vector<std::string>>& rows) {
  std::string text = "<table>\n";
  for (std::size_t i = 0; i < rows.size(); ++i) text += row(rows[i], i == 0 ? "th" : "td");
  return text + "</table>\n";
}

}  // namespace bosk
