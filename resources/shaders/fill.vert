#version 330 core
// SPDX-License-Identifier: GPL-3.0-or-later
layout(location = 0) in vec2 point; // logical pixels from the middle of the view
uniform vec2 viewport;
uniform float pixelRatio;
uniform float scale; // of a picture of another view
uniform vec2 shift;  // and its place, in logical pixels

void main()
{
    vec2 at = (point * scale + shift) * pixelRatio;
    gl_Position = vec4(at * vec2(2.0, -2.0) / viewport, 0.0, 1.0);
}
