#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace bosk {

// Pieces of the pages that Bosk writes; each page shows all by itself, without other files.

inline constexpr const char* kHtmlStyle =
    "body{font:16px/1.5 system-ui,sans-serif;margin:2em auto;max-width:70em;padding:0 1em;"
    "color:#222;background:#fff}table{border-collapse:collapse;margin:1em 0}"
    "td,th{border:1px solid #bbb;padding:.2em .7em;text-align:right}td:first-child,"
    "th:first-child{text-align:left}img{max-width:100%}";

// Text as HTML shows it.
std::string html_text(const std::string& text);
// For data: URLs.
std::string base64(std::span<const std::byte> bytes);
// "data:image/jpeg;base64,..." for kind "jpeg".
std::string data_url(const std::string& kind, std::span<const std::byte> bytes);
// The first row is the head; cells are text.
std::string html_table(const std::vector<std::vector<std::string>>& rows);

}  // namespace bosk
