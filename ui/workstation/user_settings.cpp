#include "ui/workstation/user_settings.h"

#include <algorithm>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "core/base/atomic_file.h"
#include "core/base/error.h"

namespace bosk {
namespace fs = std::filesystem;
namespace {

using Json = nlohmann::ordered_json;

constexpr std::uint64_t kMaxFileBytes = 1 << 20;

fs::path file_in(const fs::path& folder) { return folder / "settings.json"; }

fs::path variable(const char* name) {
  const char* value = std::getenv(name);
  return value ? fs::path(value) : fs::path();
}

}  // namespace

fs::path settings_folder() {
  if (const fs::path config = variable("XDG_CONFIG_HOME"); config.is_absolute()) {
    return config / "bosk";
  }
  const fs::path home = variable("HOME");
  return home.is_absolute() ? home / ".config" / "bosk" : fs::path();
}

UserSettings read_settings(const fs::path& folder) {
  UserSettings settings;
  std::error_code none;
  if (folder.empty() || !fs::exists(file_in(folder), none)) return settings;
  try {
    const auto bytes = read_file(file_in(folder), kMaxFileBytes);
    const auto* first = reinterpret_cast<const char*>(bytes.data());
    const Json json = Json::parse(first, first + bytes.size());
    const double scale = json.at("scale").get<double>();
    settings.scale = scale == 0.0 ? 0.0 : std::clamp(scale, 1.0, 3.0);
    for (const Json& project : json.at("recent")) {
      settings.recent.emplace_back(project.get<std::string>());
    }
    if (settings.recent.size() > kMostRecent) settings.recent.resize(kMostRecent);
  } catch (const Json::exception&) {
    return {};
  } catch (const Error&) {
    return {};
  }
  return settings;
}

void save_settings(const UserSettings& settings, const fs::path& folder) {
  if (folder.empty()) return;
  Json json;
  json["scale"] = settings.scale;
  json["recent"] = Json::array();
  for (const fs::path& project : settings.recent) json["recent"].push_back(project.string());
  std::error_code none;
  fs::create_directories(folder, none);
  try {
    write_file_atomically(file_in(folder), json.dump(2) + "\n");
  } catch (const Json::exception&) {  // a path that is not UTF-8
  } catch (const Error&) {
  }
}

void remember(UserSettings& settings, const fs::path& project) {
  const fs::path place = fs::absolute(project).lexically_normal();
  std::erase(settings.recent, place);
  settings.recent.insert(settings.recent.begin(), place);
  if (settings.recent.size() > kMostRecent) settings.recent.resize(kMostRecent);
}

}  // namespace bosk
