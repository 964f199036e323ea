#pragma once

#include <opencv2/core.hpp>

#include "core/image/image.h"

namespace bosk {

template <class T>
constexpr int cv_type() {
  constexpr int kChannels = T::length();
  if constexpr (std::is_same_v<typename T::value_type, double>) return CV_64FC(kChannels);
  return CV_8UC(kChannels);
}
template <>
constexpr int cv_type<double>() {
  return CV_64FC1;
}

// The same pixels as OpenCV sees them, not copied; the image must outlive the view.
template <class T>
cv::Mat cv_view(Image<T>& image) {
  return cv::Mat(image.height(), image.width(), cv_type<T>(), image.data());
}
template <class T>
const cv::Mat cv_view(const Image<T>& image) {
  return cv::Mat(image.height(), image.width(), cv_type<T>(), const_cast<T*>(image.data()));
}

}  // namespace bosk
