#pragma once

#include <string_view>

namespace floe::io {

/// The page without its data, `@DATA@` in its place; made from report/ by the build (empty with
/// -DFLOE_REPORT=OFF).
extern const std::string_view kReportTemplate;

}  // namespace floe::io
