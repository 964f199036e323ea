#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace bosk {

// What belongs to a person rather than to a project; kept in FOLDER/settings.json.
struct UserSettings {
  double scale = 0.0;                         // of the interface, 1 to 3; 0: the screen's own
  std::vector<std::filesystem::path> recent;  // project folders, absolute, newest first
};
inline constexpr std::size_t kMostRecent = 12;

// $XDG_CONFIG_HOME/bosk, else ~/.config/bosk; empty where neither is known.
std::filesystem::path settings_folder();

// Defaults where there is no such file or it is damaged: settings are never worth an error.
UserSettings read_settings(const std::filesystem::path& folder);
// Does nothing for an empty folder or where it cannot be written.
void save_settings(const UserSettings& settings, const std::filesystem::path& folder);

// Puts a project in front of the list.
void remember(UserSettings& settings, const std::filesystem::path& project);

}  // namespace bosk
