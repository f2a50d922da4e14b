// SPDX-License-Identifier: MIT
#include "render/headless.hpp"

#include <epoxy/egl.h>
#include <epoxy/gl.h>
#include <fmt/format.h>

#include <array>

namespace posepack::render {
namespace {

constexpr EGLint kMaxDevices = 16;

// Extensions that a client has before it has a display.
bool has_client_extension(const char* name) {
    return epoxy_has_egl_extension(EGL_NO_DISPLAY, name);
}

EGLContext make_context(EGLDisplay display) {
    const std::array<EGLint, 3> wanted_config = {EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_NONE};
    EGLConfig config = nullptr;
    EGLint count = 0;
    // A display without any surface type may list no config: such a context draws into framebuffers all the
    // same.
    if (eglChooseConfig(display, wanted_config.data(), &config, 1, &count) == EGL_FALSE || count == 0)
        config = EGL_NO_CONFIG_KHR;
    const std::array<EGLint, 7> wanted = {EGL_CONTEXT_MAJOR_VERSION,
                                          3,
                                          EGL_CONTEXT_MINOR_VERSION,
                                          3,
                                          EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                          EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                          EGL_NONE};
    return eglCreateContext(display, config, EGL_NO_CONTEXT, wanted.data());
}

}  // namespace

std::unique_ptr<HeadlessContext> HeadlessContext::on_display(void* display, std::string& why_not) {
    if (display == EGL_NO_DISPLAY) {
        why_not += " no display;";
        return nullptr;
    }
    EGLContext context = EGL_NO_CONTEXT;
    if (eglInitialize(display, nullptr, nullptr) == EGL_TRUE && eglBindAPI(EGL_OPENGL_API) == EGL_TRUE)
        context = make_context(display);
    if (context != EGL_NO_CONTEXT &&
        eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context) == EGL_TRUE)
        return std::unique_ptr<HeadlessContext>(new HeadlessContext(display, context));
    why_not += fmt::format(" EGL error {:#x};", eglGetError());
    if (context != EGL_NO_CONTEXT) eglDestroyContext(display, context);
    eglTerminate(display);
    return nullptr;
}

std::unique_ptr<HeadlessContext> HeadlessContext::open(std::string& why_not) {
    if (has_client_extension("EGL_EXT_device_enumeration") &&
        has_client_extension("EGL_EXT_platform_device")) {
        std::array<EGLDeviceEXT, kMaxDevices> devices{};
        EGLint count = 0;
        if (eglQueryDevicesEXT(kMaxDevices, devices.data(), &count) == EGL_FALSE) count = 0;
        for (EGLint index = 0; index < count; ++index) {
            why_not += fmt::format(" device {}:", index);
            EGLDisplay display = eglGetPlatformDisplayEXT(EGL_PLATFORM_DEVICE_EXT,
                                                          devices[static_cast<std::size_t>(index)], nullptr);
            if (auto opened = on_display(display, why_not)) return opened;
        }
    }
    if (has_client_extension("EGL_MESA_platform_surfaceless")) {
        why_not += " surfaceless:";
        return on_display(
            eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr), why_not);
    }
    why_not += " no further platform";
    return nullptr;
}

HeadlessContext::~HeadlessContext() {
    eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    eglDestroyContext(display_, context_);
    eglTerminate(display_);
}

std::string HeadlessContext::description() const {
    const auto text = [](GLenum name) { return reinterpret_cast<const char*>(glGetString(name)); };
    return fmt::format("OpenGL {} on {}", text(GL_VERSION), text(GL_RENDERER));
}

}  // namespace posepack::render
