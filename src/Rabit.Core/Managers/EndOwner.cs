namespace Rabit.Core.Managers;

/// <summary>Who holds ends of messages and queues: a manager, a reader or writer of one, or code outside managers.</summary>
internal sealed class EndOwner(string name, bool isManager, WakeUpEvent? wakeUp)
{
    public string Name { get; } = name;

    public bool IsManager { get; } = isManager;

    public WakeUpEvent? WakeUp { get; } = wakeUp;
}
