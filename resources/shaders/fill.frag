#version 330 core
// SPDX-License-Identifier: GPL-3.0-or-later
uniform vec4 ink; // premultiplied
out vec4 painted;

void main() { painted = ink; }
