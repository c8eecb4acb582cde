// SPDX-License-Identifier: MIT
#pragma once

#include <bitset>

struct GLFWwindow;

namespace sl {

/// Dear ImGui looks at keys once in a frame, so it misses those that go down and up within a slow one. This
/// holds them down for the frame. Made after ImGui's own callbacks are set, and while it lives the only one.
class KeyTaps {
  public:
    explicit KeyTaps(GLFWwindow* window);
    KeyTaps(const KeyTaps&) = delete;
    KeyTaps& operator=(const KeyTaps&) = delete;

    /// Before and after ImGui's frame.
    void hold();
    void release();

  private:
    static constexpr std::size_t key_count = 512;  // as ImGui counts them

    static void on_key(GLFWwindow* window, int key, int scancode, int action, int modifiers);

    std::bitset<key_count> pressed_, held_;
};

}  // namespace sl
