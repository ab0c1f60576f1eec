#pragma once

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

namespace ff::app {

struct ManPage {
    std::string file;  ///< "ffstudy-run.1"
    std::string text;  ///< man(7)
};

/// One page for the program and one for each command, from the definitions that --help shows.
std::vector<ManPage> man_pages(const CLI::App& app, const std::string& version);

}  // namespace ff::app
