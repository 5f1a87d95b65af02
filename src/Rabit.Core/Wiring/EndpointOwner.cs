using Rabit.Core.Managers;
using Rabit.Core.WakeUp;

namespace Rabit.Core.Wiring;

/// <summary>
/// Who holds endpoints of messages and queues: a manager, a reader or writer of one, or code outside managers.
/// </summary>
internal sealed class EndpointOwner(string name, bool isManager, WakeUpEvent? wakeUp)
{
    /// <summary>
    /// Where the manager's code begins on the stack of the thread on which it runs. Written by that thread
    /// (<see cref="RunningScope"/>), read by any: a word that is read and written whole.
    /// </summary>
    public StackMark Mark;

    public string Name { get; } = name;

    public bool IsManager { get; } = isManager;

    /// <summary>Code outside managers: it cannot be woken, and is on no thread of ours.</summary>
    public bool IsOutside => !IsManager && WakeUp is null;

    public WakeUpEvent? WakeUp { get; } = wakeUp;

    /// <summary>Whether it has asked for a real-time priority. Set before anything is wired.</summary>
    public bool HasPriority { get; set; }
}
