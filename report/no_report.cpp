#include "io/report_template.hpp"

namespace floe::io {

const std::string_view kReportTemplate;

}  // namespace floe::io
