#include <imgui.h>

#include "ui/widgets/theme.h"
#include "ui/workstation/photos/photo_panels.h"
#include "ui/workstation/photos/wheel_picture.h"
#include "ui/workstation/workspace.h"

namespace bosk {

void draw_camera_wheel(Workspace& workspace) {
  const std::vector<Camera> cameras = photo_cameras(workspace);
  const CameraWheel wheel = wheel_of(cameras, middle_of(cameras));
  const auto widest = widest_gap(wheel);
  const bool wide = widest && widest->size > kWideGap;
  ImGui::TextUnformatted("From above");
  badge(wide ? Tone::note : Tone::good, wide ? "gaps" : "from all around");
  paragraph(words_of(wheel) + ".");
  std::vector<WheelArc> arcs;
  for (const WheelGap& gap : wheel.gaps) {
    if (gap.size > kWideGap) arcs.push_back({gap.start, gap.size, "no photo\nfrom here"});
  }
  const WheelHand hand = draw_wheel("photos/wheel", "photos/spoke/", wheel, arcs, {},
                                    ImGui::GetContentRegionAvail().x, workspace.photos.pointed_at);
  if (hand.pointed_at) workspace.photos.pointed_at = *hand.pointed_at;
  const PhotoRow* row = row_of(workspace, hand.clicked);
  if (row) show_photo(workspace, row->photo);
  paragraph(Tone::muted, "Point at a camera to see which photo it is; click to open it.");
}

}  // namespace bosk
