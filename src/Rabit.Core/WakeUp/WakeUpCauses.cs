using System;

namespace Rabit.Core;

/// <summary>Why a unit of work runs. Several causes may come together, since wake-ups do not stack.</summary>
[Flags]
public enum WakeUpCauses
{
    /// <summary>None: no unit of work is running.</summary>
    None = 0,

    /// <summary>The first unit of work, right after every manager has started up.</summary>
    Start = 1,

    /// <summary>The wake-up delay passed.</summary>
    Timer = 2,

    /// <summary>A message was posted that the manager asked to be woken by.</summary>
    Post = 4,

    /// <summary>Something was pushed into a queue that the manager receives.</summary>
    Push = 8,

    /// <summary>Something was popped from a queue that the manager sends to and asked to be woken by.</summary>
    Pop = 16,

    /// <summary>User code called <see cref="RabitManager.WakeUp"/>.</summary>
    Request = 32,

    /// <summary>A reader or writer of the manager ended, failed, or opened its device again.</summary>
    Device = 64,

    /// <summary>
    /// A stop of the run was requested, and a manager delays it (<see cref="RabitManager.DelaysStop"/>).
    /// </summary>
    StopRequested = 128,
}
