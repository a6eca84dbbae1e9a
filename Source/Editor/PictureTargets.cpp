#include "Editor/PictureTargets.h"

using namespace juce::gl;

namespace idiophone {
namespace {

int boundTarget() {
    GLint bound = 0;
    glGetIntegerv(GL_FRAMEBUFFER_BINDING, &bound);
    return bound;
}

bool isComplete() {
    return glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
}

void bindTarget(int target) {
    glBindFramebuffer(GL_FRAMEBUFFER, static_cast<GLuint>(target));
}

} // namespace

bool MultisampledImage::begin(int newWidth, int newHeight) {
    former = boundTarget();
    if (frame == 0 || width != newWidth || height != newHeight) {
        width = newWidth;
        height = newHeight;
        create(4);
        if (!isComplete())
            create(0);
    }
    glBindFramebuffer(GL_FRAMEBUFFER, frame);
    if (isComplete()) {
        glEnable(GL_MULTISAMPLE);
        return true;
    }
    bindTarget(former);
    return false;
}

/// With 0 samples the image has no multisampling.
void MultisampledImage::create(int samples) {
    release();
    glGenFramebuffers(1, &frame);
    glBindFramebuffer(GL_FRAMEBUFFER, frame);
    const auto add = [&](GLuint& buffer, GLenum format, GLenum attachment) {
        glGenRenderbuffers(1, &buffer);
        glBindRenderbuffer(GL_RENDERBUFFER, buffer);
        glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, format, width, height);
        glFramebufferRenderbuffer(GL_FRAMEBUFFER, attachment, GL_RENDERBUFFER, buffer);
    };
    add(colour, GL_RGBA8, GL_COLOR_ATTACHMENT0);
    add(depth, GL_DEPTH_COMPONENT24, GL_DEPTH_ATTACHMENT);
}

void MultisampledImage::finish() {
    glBindFramebuffer(GL_READ_FRAMEBUFFER, frame);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, static_cast<GLuint>(former));
    glBlitFramebuffer(0, 0, width, height, 0, 0, width, height, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    bindTarget(former);
}

void MultisampledImage::release() {
    glDeleteFramebuffers(1, &frame);
    glDeleteRenderbuffers(1, &colour);
    glDeleteRenderbuffers(1, &depth);
    frame = colour = depth = 0;
}

bool ShadowMap::begin() {
    former = boundTarget();
    if (frame == 0) {
        glGenTextures(1, &texture);
        glBindTexture(GL_TEXTURE_2D, texture);
        glTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT24, size, size, 0, GL_DEPTH_COMPONENT,
                     GL_UNSIGNED_INT, nullptr);
        const auto set = [](GLenum name, GLint value) {
            glTexParameteri(GL_TEXTURE_2D, name, value);
        };
        set(GL_TEXTURE_MIN_FILTER, GL_LINEAR);
        set(GL_TEXTURE_MAG_FILTER, GL_LINEAR);
        set(GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
        set(GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
        set(GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
        set(GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);
        glGenFramebuffers(1, &frame);
        glBindFramebuffer(GL_FRAMEBUFFER, frame);
        glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, texture, 0);
        glDrawBuffer(GL_NONE);
        glReadBuffer(GL_NONE);
    }
    glBindFramebuffer(GL_FRAMEBUFFER, frame);
    if (!isComplete()) {
        bindTarget(former);
        return false;
    }
    glViewport(0, 0, size, size);
    glClear(GL_DEPTH_BUFFER_BIT);
    return true;
}

void ShadowMap::finish() const {
    bindTarget(former);
}

void ShadowMap::bindTexture() const {
    glBindTexture(GL_TEXTURE_2D, texture);
}

void ShadowMap::release() {
    glDeleteFramebuffers(1, &frame);
    glDeleteTextures(1, &texture);
    frame = texture = 0;
}

} // namespace idiophone
