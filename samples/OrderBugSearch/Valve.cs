using System;
using Rabit.Core;

namespace OrderBugSearch;

/// <summary>Opens when it sees the button pressed.</summary>
/// <remarks>
/// The bug: a message holds the latest value, and a valve that looks every 20 ms does not see one that stood there for
/// a shorter time. It happens when the valve looks just before the button is pressed and next time just after it was
/// released. The second and third press hide it: all three are missed in one run of 64.
/// </remarks>
internal sealed class Valve : RabitManager
{
    private readonly MessageSubscriber<Button> _button;
    private readonly MessagePublisher<ValveState> _valve;

    /// <param name="isFixed">
    /// With the fix: a post wakes the valve, so that it sees every one. (A queue would do as well.)
    /// </param>
    public Valve(bool isFixed)
        : base("valve")
    {
        _button = Subscribe<Button>("button", wakeOnPost: isFixed);
        _valve = Publish<ValveState>("valve");
        Period = TimeSpan.FromMilliseconds(20);
    }

    public bool IsOpen { get; private set; }

    protected override void ExecuteUnitOfWork()
    {
        _button.FetchAndCountMissed(out int missed);
        if (missed > 0)
            Log($"missed {missed} of what the button did");
        if (!_button.Value.IsPressed || IsOpen)
            return;
        IsOpen = true;
        Log("opens");
        _valve.Value.IsOpen = true;
        _valve.Post();
    }
}
