// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace app::plug_in {

/// Forks this process, which must have a single thread. The call returns only in the new process,
/// which may load a library. The old process stays as its warden: every process that the
/// library starts, even in its own session or through short-lived parents, becomes a child of the
/// warden when its own parent ends. The warden kills these processes when the library's process
/// ends, when the warden gets SIGTERM, or when the thread that started the warden ends. Then the
/// warden ends like the library's process: by the same signal or with the same exit code.
void stayBehindAsWarden();

} // namespace app::plug_in
