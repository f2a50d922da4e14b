// SPDX-License-Identifier: MIT
#include <cstdio>

#include "sample_manifest.hpp"

int main() {
    const std::string text = posepack::recipe::write_manifest(posepack::recipe::sample_manifest());
    return std::fwrite(text.data(), 1, text.size(), stdout) == text.size() ? 0 : 1;
}
