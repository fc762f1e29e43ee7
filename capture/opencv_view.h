#pragma once

#include <opencv2/core.hpp>

#include "core/grid.h"

/// Grids as OpenCV sees them, without a copy. Included by sources only.
namespace hada {

template <class T>
cv::Mat view(Grid<T>& grid) {
  return cv::Mat(grid.rows(), grid.cols(), cv::traits::Type<T>::value, grid.data());
}

/// OpenCV has no read-only matrix: the result may only be read.
template <class T>
cv::Mat view(const Grid<T>& grid) {
  return view(const_cast<Grid<T>&>(grid));
}

}  // namespace hada
