namespace Rabit.Uav.Simulation;

/// <summary>One thing that a failsafe watches, and whether its action stands.</summary>
internal sealed class Px4FailsafeCondition(Px4Cause cause, bool lasts = false)
{
    public Px4Cause Cause { get; } = cause;

    public Px4Action Action { get; private set; }

    /// <summary>Whether it is so now.</summary>
    public bool IsTrue { get; private set; }

    /// <summary>Whether its action stands: it may outlast the condition.</summary>
    public bool IsPresent { get; private set; }

    /// <summary>Whether the action has been taken, and not only announced.</summary>
    public bool IsActivated { get; set; }

    /// <summary>
    /// Return and landing, and all that the fence does, last until the mode is changed; the others until the condition
    /// is over.
    /// </summary>
    private bool LastsUntilModeChange => lasts || Action is Px4Action.Return or Px4Action.Land;

    /// <summary>Updates it; true where it has become so.</summary>
    public bool Update(bool isTrue, Px4Action action)
    {
        bool isNew = isTrue && !IsTrue;
        IsTrue = isTrue;
        if (isTrue)
        {
            Action = action;
            IsPresent = action != Px4Action.None;
        }
        else if (!LastsUntilModeChange || !IsActivated)
        {
            Clear();
        }

        return isNew && IsPresent;
    }

    /// <summary>The pilot or a ground station has changed the mode: what is over ends with that.</summary>
    public void ChangeMode()
    {
        IsActivated = false;
        if (!IsTrue)
            IsPresent = false;
    }

    public void Clear()
    {
        IsPresent = false;
        IsActivated = false;
    }
}
