#pragma once

#include "app/command_line/command_model.hpp"

#include <string>
#include <vector>

namespace ff::app {

struct ManPage {
    std::string file;  ///< "ffstudy-run.1"
    std::string text;  ///< man(7)
};

/// One page for the program and one for each command, from the definitions that --help shows.
std::vector<ManPage> man_pages(const ProgramModel& program, const std::string& version);

}  // namespace ff::app
