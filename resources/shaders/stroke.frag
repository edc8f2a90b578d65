#version 330 core
// SPDX-License-Identifier: GPL-3.0-or-later
// How much of the pixel the piece covers, by the distance to its edge.
in vec2 along;
flat in vec2 halfSize;
flat in vec4 ink;
flat in uvec2 cap;
out vec4 painted;

void main()
{
    uint kind = along.x < 0.0 ? cap.x : cap.y;
    float past = abs(along.x) - halfSize.x;
    float cover;
    if (kind == 1u)
        cover = clamp(0.5 + halfSize.y - length(vec2(max(past, 0.0), along.y)), 0.0, 1.0);
    else
        cover = clamp(0.5 - past + (kind == 2u ? halfSize.y : 0.0), 0.0, 1.0)
              * clamp(0.5 + halfSize.y - abs(along.y), 0.0, 1.0);
    painted = ink * cover;
}
