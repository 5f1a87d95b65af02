using System;
using Rabit.Core;

namespace OrderBugSearch;

/// <summary>
/// Presses the button for one period, and again after a tenth of a second as long as the valve is closed: three times
/// in all.
/// </summary>
internal sealed class Panel : RabitManager
{
    private const int PeriodsPerPress = 5;
    private const int Presses = 3;

    private readonly MessagePublisher<Button> _button;
    private readonly MessageSubscriber<ValveState> _valve;
    private int _periods;

    public Panel()
        : base("panel")
    {
        _button = Publish<Button>("button");
        _valve = Subscribe<ValveState>("valve");
        Period = TimeSpan.FromMilliseconds(20);
    }

    protected override void ExecuteUnitOfWork()
    {
        _valve.Fetch();
        bool isTimeToPress = _periods % PeriodsPerPress == 0 && _periods < Presses * PeriodsPerPress;
        _periods++;

        bool press = isTimeToPress && !_valve.Value.IsOpen;
        if (press == _button.Value.IsPressed)
            return;
        Log(press ? "presses" : "releases");
        _button.Value.IsPressed = press;
        _button.Post();
    }
}
