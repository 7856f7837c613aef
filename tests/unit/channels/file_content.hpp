// A file of the tests as one text; an empty one when it is not there.
#pragma once
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

namespace polyturn::channels {

inline std::string content(const std::filesystem::path& path) {
    std::ifstream in(path, std::ios::binary);
    std::stringstream text;
    text << in.rdbuf();
    return text.str();
}

}  // namespace polyturn::channels
