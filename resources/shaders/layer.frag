#version 330 core
// SPDX-License-Identifier: GPL-3.0-or-later
uniform sampler2D layer; // premultiplied
uniform float opacity;
in vec2 at;
out vec4 painted;

void main() { painted = texture(layer, at) * opacity; }
