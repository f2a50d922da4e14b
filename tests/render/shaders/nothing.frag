// SPDX-License-Identifier: MIT
// Colours nothing: for depth maps and for captured vertices.
void main() {}
