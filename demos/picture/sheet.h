#pragma once

#include <string_view>

#include "picture/image.h"

namespace hooke::picture {

/// Several pictures in one, in columns and rows with a white line between them, numbered row by row.
class Sheet {
 public:
  /// Of `width` x `height` pixels in all. Throws PictureError where that leaves too little for each picture.
  Sheet(int width, int height, int columns, int rows);

  int cell_width() const { return cell_width_; }    ///< [pixels]
  int cell_height() const { return cell_height_; }  ///< [pixels]

  /// Puts a picture of the cells' size into a cell, with a label (see write_label()) in its lower left
  /// corner; none where it is empty.
  void place(int cell, const Image& picture, std::string_view label);

  const Image& image() const { return image_; }

 private:
  int columns_, gap_, cell_width_, cell_height_, left_, top_;
  Image image_;
};

}  // namespace hooke::picture
