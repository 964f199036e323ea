#pragma once

#include <opencv2/core.hpp>
#include <string>
#include <vector>

#include "core/calibrate/boards.h"

// Private to this folder: the header shows OpenCV.
namespace bosk {

// Throws Error that lists the names when OpenCV has no such dictionary.
void check_dictionary(const std::string& name);

// find_board for a ChArUco. The numbers of markers say which square is which, in both layouts that
// are in use: the top left square dark (OpenCV from 4.7 on, calib.io) or with a marker (OpenCV
// until 4.6 where the board has an even number of rows of squares); the one that more markers agree
// with holds. Markers of other boards, and misread ones, disagree with the rest and are dropped.
std::vector<BoardCorner> find_charuco(const cv::Mat& grey, const BoardShape& shape,
                                      const Progress& progress);

}  // namespace bosk
