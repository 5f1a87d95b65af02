
using Rabit.Core.WakeUp;

namespace Rabit.Core;

/// <summary>What the threads of a run in real time sleep on.</summary>
public enum WaitEngine
{
    /// <summary>
    /// The best one that works here: futex on Linux, else an event. The environment variable <c>RABIT_WAIT_ENGINE</c>
    /// (<c>event</c> or <c>futex</c>) chooses another.
    /// </summary>
    Best,

    /// <summary>
    /// An <see cref="System.Threading.AutoResetEvent"/>: everywhere; its timer counts in milliseconds.
    /// </summary>
    Event,

    /// <summary>
    /// The futex of the Linux kernel, with absolute deadlines in nanoseconds. Where the kernel refuses it, an event is
    /// used instead, and the log has a note.
    /// </summary>
    Futex,
}
