#version 330 core
// SPDX-License-Identifier: GPL-3.0-or-later
// One instance is one straight piece of a stroke, in logical pixels from the middle of the view. The
// four corners of its quad come from gl_VertexID.
layout(location = 0) in vec4 ends;   // a, b
layout(location = 1) in vec4 colour; // not premultiplied
layout(location = 2) in float thickness;
layout(location = 3) in uint caps;   // of a: caps & 3u, of b: caps >> 2: 0 butt, 1 round, 2 square
uniform vec2 viewport;               // device pixels
uniform float pixelRatio;
uniform float scale;                 // of a picture of another view
uniform vec2 shift;                  // and its place, in logical pixels
out vec2 along;                      // from the piece's middle: along it and across it
flat out vec2 halfSize;
flat out vec4 ink;
flat out uvec2 cap;

void main()
{
    vec2 a = (ends.xy * scale + shift) * pixelRatio, b = (ends.zw * scale + shift) * pixelRatio;
    vec2 d = b - a;
    float width = max(thickness * pixelRatio, 1.0), fade = min(thickness * pixelRatio, 1.0);
    float len = length(d);
    vec2 u = len > 1e-6 ? d / len : vec2(1, 0), n = vec2(-u.y, u.x);
    float room = 0.5 * width + 1.0;
    vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0 - 1.0;
    along = corner * vec2(0.5 * len + room, room);
    halfSize = vec2(0.5 * len, 0.5 * width);
    ink = vec4(colour.rgb, 1.0) * (colour.a * fade); // premultiplied
    cap = uvec2(caps & 3u, caps >> 2);
    vec2 at = 0.5 * (a + b) + u * along.x + n * along.y;
    gl_Position = vec4(at * vec2(2.0, -2.0) / viewport, 0.0, 1.0);
}
