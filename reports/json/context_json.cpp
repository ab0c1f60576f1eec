#include "reports/json/context_json.hpp"

#include <nlohmann/json.hpp>

namespace ff::reports {

std::string context_json(const std::map<std::string, std::string>& context) {
    // File names of the command need not be UTF-8, as JSON has to be.
    return nlohmann::json(context).dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

}  // namespace ff::reports
