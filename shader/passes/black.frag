// SPDX-License-Identifier: MIT
layout(location = 0) out vec4 black;

void main() { black = vec4(0.0); }
