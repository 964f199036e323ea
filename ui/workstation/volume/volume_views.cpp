#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "ui/widgets/fitted_picture.h"
#include "ui/widgets/theme.h"
#include "ui/workstation/volume/volume_step.h"
#include "ui/workstation/workspace.h"

namespace bosk {
namespace {

constexpr int kSlice_px = 192, kTallest_px = 400;
constexpr double kRadiansPerPoint = 0.01;  // of a drag
constexpr double kZoomOfStep = 1.15;       // of the wheel
constexpr double kHighest = 1.5;           // elevation, just below the zenith

// Draws the view on a worker when it isn't the one shown; one at a time, so that a moving hand
// always sees the newest that could be made.
void keep_drawn(Workspace& workspace, VolumePicture& picture, const VolumeView& wanted,
                const Camera& camera, const std::string& key) {
  if (picture.shown == wanted && picture.revision > 0) return;
  if (workspace.jobs.is_open(picture.job)) return;
  const int width_px = std::max(
      1, int(std::lround(double(wanted.height_px) * camera.lens.width_px / camera.lens.height_px)));
  picture.job = workspace.jobs.start(
      "Drawing the volume",
      [look = workspace.volume.look, camera, width_px, wanted](Progress&) {
        const bool fine = look->fine && !wanted.in_motion;
        return volume_picture(fine ? *look->fine : look->volume, camera, width_px,
                              wanted.height_px);
      },
      [&picture, wanted](Image<glm::u8vec4> pixels) {
        picture.pixels = std::move(pixels);
        picture.shown = wanted;
        ++picture.revision;
      },
      Lane::interactive, key);
}

Texture texture_of(Workspace& workspace, const std::string& name, const VolumePicture& picture) {
  return workspace.pictures.show(name, picture.revision, [&] { return picture.pixels; });
}

// What lies behind a half-clear tree: a plain grey.
ImU32 ground_colour() { return ImGui::GetColorU32(ImVec4(0.45f, 0.47f, 0.48f, 1.0f)); }

void draw_on_ground(const Texture& texture, const ImVec2& least, const ImVec2& area) {
  ImGui::GetWindowDrawList()->AddRectFilled(least, {least.x + area.x, least.y + area.y},
                                            ground_colour());
  draw_fitted(texture, least, area);
}

std::uint64_t slice_revision(const VolumeStepState& state, int axis) {
  const auto place = std::uint64_t(std::lround(state.cut[axis] * 1000.0));
  return (state.look_revision * 1001 + place) * 2 + (state.slice_look == SliceLook::colour ? 1 : 0);
}

void draw_slice(Workspace& workspace, int axis, float edge) {
  static constexpr const char* kNames[] = {"x", "y", "z"};
  VolumeStepState& state = workspace.volume;
  const std::string name = std::string("volume/slice_") + kNames[axis];
  const Texture texture = workspace.pictures.show(name, slice_revision(state, axis), [&] {
    return slice_picture(state.look->volume, axis, state.cut[axis], kSlice_px, state.slice_look);
  });
  ImGui::BeginGroup();
  const ImVec2 least = ImGui::GetCursorScreenPos();
  ImGui::Dummy({edge, edge});
  mark(name);
  draw_on_ground(texture, least, {edge, edge});
  auto position = float(state.cut[axis]);
  ImGui::SetNextItemWidth(edge);
  const std::string label = std::string("##cut_") + kNames[axis];
  const std::string format = std::string(kNames[axis]) + " %.2f";
  if (ImGui::SliderFloat(label.c_str(), &position, 0.0f, 1.0f, format.c_str(),
                         ImGuiSliderFlags_AlwaysClamp)) {
    state.cut[axis] = double(position);
  }
  mark(std::string("volume/cut_") + kNames[axis]);
  ImGui::EndGroup();
}

void draw_slices(Workspace& workspace) {
  VolumeStepState& state = workspace.volume;
  const ImVec2 left = ImGui::GetContentRegionAvail();
  const float em = ImGui::GetFontSize();
  const float edge = std::max(4.0f * em, std::min(left.x, (left.y - 2.0f * em) / 3.0f - 2.4f * em));
  for (int axis = 0; axis < 3; ++axis) draw_slice(workspace, axis, edge);
  bool colours = state.slice_look == SliceLook::colour;
  if (ImGui::Checkbox("colours", &colours)) {
    state.slice_look = colours ? SliceLook::colour : SliceLook::extinction;
  }
  mark("volume/slice_colours");
}

void hear_orbit(VolumeStepState& state) {
  const ImGuiIO& io = ImGui::GetIO();
  state.orbiting = ImGui::IsItemActive();
  if (state.orbiting) {
    state.orbit.azimuth -= kRadiansPerPoint * double(io.MouseDelta.x);
    state.orbit.elevation += kRadiansPerPoint * double(io.MouseDelta.y);
    state.orbit.elevation = std::clamp(state.orbit.elevation, -kHighest, kHighest);
  }
  if (ImGui::IsItemHovered() && io.MouseWheel != 0.0f) {
    state.orbit.distance *= std::pow(kZoomOfStep, -double(io.MouseWheel));
    state.orbit.distance = std::clamp(state.orbit.distance, 0.3, 6.0);
  }
}

void draw_orbit(Workspace& workspace, const ImVec2& area) {
  VolumeStepState& state = workspace.volume;
  const ImVec2 least = ImGui::GetCursorScreenPos();
  ImGui::InvisibleButton("volume/orbit", area);
  mark("volume/orbit");
  hear_orbit(state);
  tooltip(state.orbiting ? "" : "drag to walk around it, wheel to come nearer");
  VolumeView wanted = state.orbit;
  wanted.look = state.look_revision;
  wanted.in_motion = state.orbiting;
  wanted.height_px = std::clamp(int(area.y), 32, kTallest_px) / (state.orbiting ? 2 : 1);
  const int width_px = std::max(1, int(double(wanted.height_px) * double(area.x) / double(area.y)));
  const Camera camera = orbit_camera(state.look->volume, wanted.azimuth, wanted.elevation,
                                     wanted.distance, width_px, wanted.height_px);
  keep_drawn(workspace, state.orbit_picture, wanted, camera, "volume/orbit");
  draw_on_ground(texture_of(workspace, "volume/orbit", state.orbit_picture), least, area);
}

// The photo at the working size, or else the tree cut out of it; empty where neither is at hand.
Image<glm::u8vec4> photo_pixels(const Workspace& workspace, const std::string& name) {
  Image<glm::u8vec4> picture;
  const auto fill = [&](const auto& pixels, const auto& rgba_of) {
    picture = Image<glm::u8vec4>(pixels.width(), pixels.height());
    for (std::size_t i = 0; i < pixels.size(); ++i) {
      picture.pixels()[i] =
          glm::u8vec4(glm::clamp(rgba_of(pixels.pixels()[i]), 0.0f, 1.0f) * 255.0f + 0.5f);
    }
  };
  if (workspace.results.imported) {
    for (const Photo& photo : workspace.results.imported->photos) {
      if (photo.name != name || photo.srgb.empty()) continue;
      fill(photo.srgb, [](const glm::vec3& srgb) { return glm::vec4(srgb, 1.0f); });
      return picture;
    }
  }
  if (!workspace.results.mattes) return picture;
  for (const Matte& matte : *workspace.results.mattes) {
    if (matte.name == name) fill(matte.rgba, [](const glm::vec4& rgba) { return rgba; });
  }
  return picture;
}

void draw_photo(Workspace& workspace, const std::string& name, const glm::dvec2& size_px,
                const ImVec2& area) {
  VolumeStepState& state = workspace.volume;
  const char* source = workspace.results.imported ? "photo" : "matte";
  const auto made = workspace.made.find(source);
  const std::uint64_t revision = made == workspace.made.end() ? 0 : made->second.low;
  const Texture texture =
      workspace.pictures.show(std::string("volume/") + source + "/" + name, revision,
                              [&] { return photo_pixels(workspace, name); });
  draw_image_view("volume/photo", state.photo_view, texture, size_px, area);
}

void draw_rendering(Workspace& workspace, const Camera& camera, const glm::dvec2& size_px,
                    const ImVec2& area) {
  VolumeStepState& state = workspace.volume;
  VolumeView wanted;
  wanted.look = state.look_revision;
  wanted.photo = state.photo;
  wanted.height_px = std::min(camera.lens.height_px, kTallest_px);
  keep_drawn(workspace, state.photo_picture, wanted, camera, "volume/rendering");
  const ImVec2 least = ImGui::GetCursorScreenPos();
  ImGui::GetWindowDrawList()->AddRectFilled(least, {least.x + area.x, least.y + area.y},
                                            ground_colour());
  draw_image_view("volume/rendering", state.photo_view,
                  texture_of(workspace, "volume/rendering", state.photo_picture), size_px, area);
}

// A photo and the volume from the same place, zoomed as one.
void draw_comparison(Workspace& workspace, const ImVec2& area) {
  VolumeStepState& state = workspace.volume;
  if (state.look->cameras.empty()) return;
  const Camera& camera = state.look->cameras[std::size_t(state.photo)];
  const glm::dvec2 size_px(camera.lens.width_px, camera.lens.height_px);
  const float space = ImGui::GetStyle().ItemSpacing.x;
  const ImVec2 half(std::max(1.0f, 0.5f * (area.x - space)), area.y);
  draw_photo(workspace, camera.name, size_px, half);
  ImGui::SameLine();
  draw_rendering(workspace, camera, size_px, half);
}

// As a format that shows just this text.
std::string format_of(const std::string& text) {
  std::string format;
  for (const char c : text) format += c == '%' ? std::string("%%") : std::string(1, c);
  return format;
}

void draw_photo_choice(VolumeStepState& state) {
  const int photos = int(state.look->cameras.size());
  if (photos == 0) return;
  ImGui::SetNextItemWidth(12.0f * ImGui::GetFontSize());
  ImGui::SliderInt("##photo", &state.photo, 0, photos - 1,
                   format_of(state.look->cameras[std::size_t(state.photo)].name).c_str(),
                   ImGuiSliderFlags_AlwaysClamp | ImGuiSliderFlags_NoInput);
  mark("volume/photo_choice");
  ImGui::SameLine();
  ImGui::TextDisabled("photo | volume");
}

}  // namespace

void draw_volume_views(Workspace& workspace) {
  const ImVec2 left = ImGui::GetContentRegionAvail();
  const float slices = std::min(0.22f * left.x, left.y / 3.4f);
  ImGui::BeginChild("slices", {slices, 0}, false, ImGuiWindowFlags_NoScrollWithMouse);
  draw_slices(workspace);
  ImGui::EndChild();
  ImGui::SameLine();
  const float wide = std::max(2.0f, ImGui::GetContentRegionAvail().x);
  draw_orbit(workspace, {std::max(1.0f, 0.4f * wide), std::max(1.0f, left.y)});
  ImGui::SameLine();
  ImGui::BeginGroup();
  draw_photo_choice(workspace.volume);
  const ImVec2 rest = ImGui::GetContentRegionAvail();
  draw_comparison(workspace, {std::max(2.0f, rest.x), std::max(1.0f, rest.y)});
  ImGui::EndGroup();
}

}  // namespace bosk
