// SPDX-License-Identifier: MIT
// An OpenGL 3.3 core context without a window.
#pragma once

#include <memory>
#include <string>

namespace posepack::render {

// Current on the thread that opened it until it is destroyed.
class HeadlessContext {
 public:
    // Tries every EGL device, then Mesa's surfaceless platform. Gives nothing where no display can make a
    // context; `why_not` then says what each one answered.
    static std::unique_ptr<HeadlessContext> open(std::string& why_not);

    HeadlessContext(const HeadlessContext&) = delete;
    HeadlessContext& operator=(const HeadlessContext&) = delete;
    ~HeadlessContext();

    // Version and renderer, as the driver names them.
    std::string description() const;

 private:
    HeadlessContext(void* display, void* context) : display_(display), context_(context) {}
    static std::unique_ptr<HeadlessContext> on_display(void* display, std::string& why_not);

    void* display_;
    void* context_;
};

}  // namespace posepack::render
