using Rabit.Core.Wiring;

namespace Rabit.Core.Managers;

/// <summary>
/// A call into the code of a manager: from <see cref="Enter"/> to <see cref="Leave"/> it is the one that runs on this
/// thread. A local variable of the method that makes the call, so that the code it calls lies below it on the stack.
/// </summary>
/// <remarks>
/// A manager's mark is on the stack of a thread only while the manager is the <see cref="RunningManager.Current"/> of
/// that thread: one that is interrupted by another (in virtual time they share a thread) loses its mark for as long.
/// Two threads run one manager at once only where it was restarted after a hang. The mark is then that of the thread
/// that entered last; a thread never writes the mark of another one, at worst it clears it, and then the
/// thread-static field decides.
/// </remarks>
internal ref struct RunningScope
{
    private EndpointOwner _owner;
    private EndpointOwner? _outer;
    private StackMark _mark;
    private StackMark _outerMark;

    /// <summary>The manager runs on this thread, until <see cref="Leave"/>.</summary>
    public void Enter(EndpointOwner owner)
    {
        _owner = owner;
        _outer = RunningManager.Replace(owner);
        if (_outer is not null && _outer.Mark.Covers(ref _mark))
        {
            _outerMark = _outer.Mark;
            _outer.Mark = default;
        }

        _mark = StackMark.At(ref _mark);
        owner.Mark = _mark;
    }

    /// <summary>What ran before runs again.</summary>
    public readonly void Leave()
    {
        if (_owner.Mark.IsSameAs(_mark))
            _owner.Mark = default;
        RunningManager.Replace(_outer);
        if (_outerMark.IsSet)
            _outer!.Mark = _outerMark;
    }

    /// <summary>Ends a scope that an exception has left: no manager runs on this thread.</summary>
    public static void Abandon(EndpointOwner owner)
    {
        owner.Mark = default;
        RunningManager.Replace(null);
    }
}
