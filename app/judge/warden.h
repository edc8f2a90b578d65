// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace app::plug_in {

/// Splits this process, which must have one thread, in two. It returns in the new one alone, which
/// may load a library. The old one stays as its warden: whatever the library starts, also in a
/// session of its own or by way of processes that end at once, becomes a child of the warden when
/// its own parent ends, and is killed when the library's process ends, when the warden gets
/// SIGTERM, or when the thread that started the warden ends. Then the warden ends as the library's
/// process did: by the same signal or with the same exit code.
void stayBehindAsWarden();

} // namespace app::plug_in
