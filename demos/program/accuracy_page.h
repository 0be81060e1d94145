#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "program/accuracy_report.h"

namespace hooke::program {

/// A picture to put into a page.
struct PagePicture {
  std::string caption;
  std::string svg;  ///< the whole file; empty where it could not be drawn
};

/// A study as one HTML page that needs nothing else: its pictures are in it.
std::string accuracy_page(const AccuracyReport& report, const std::vector<PagePicture>& pictures);

/// Text with what HTML would read as its own replaced.
std::string html_text(std::string_view text);

/// As data URIs want binary data.
std::string base64(std::string_view bytes);

}  // namespace hooke::program
