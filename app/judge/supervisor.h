// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace app::plug_in {

/// Forks this process, which must have a single thread. The call returns only in the new process,
/// which may load a library. The old process stays as its supervisor: every process that the
/// library starts, even in its own session or through short-lived parents, becomes a child of the
/// supervisor when its own parent ends. The supervisor kills these processes when the library's
/// process ends, when the supervisor gets SIGTERM, or when the thread that started the supervisor
/// ends. Then the supervisor ends like the library's process: by the same signal or with the same
/// exit code.
void forkUnderSupervisor();

} // namespace app::plug_in
