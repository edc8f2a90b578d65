// SPDX-License-Identifier: GPL-3.0-or-later
#version 330 core
uniform vec4 ink; // premultiplied
out vec4 painted;

void main() { painted = ink; }
