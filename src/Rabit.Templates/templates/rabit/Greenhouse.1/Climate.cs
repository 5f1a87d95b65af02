using Rabit.Core;

namespace Greenhouse._1;

/// <summary>
/// Decides: opens the window when it gets too warm, and ends the program when that does not help. It sleeps until a
/// temperature is posted, and knows nothing of thermometers and motors.
/// </summary>
public sealed class Climate : RabitManager
{
    private const double OpensAboveCelsius = 24;
    private const double ClosesBelowCelsius = 23;   // hysteresis: the window does not flutter
    private const double MaxCelsius = 40;

    private readonly MessageSubscriber<AirTemperature> _air;
    private readonly QueueSender<WindowCommand> _window;
    private bool _isOpen;

    // The constructor only says what the manager publishes, subscribes to, sends and receives.
    public Climate()
        : base("climate")
    {
        _air = Subscribe<AirTemperature>(Names.Air, wakeOnPost: true);
        _window = Send<WindowCommand>(Names.WindowCommands);
    }

    protected override void ExecuteUnitOfWork()
    {
        if (!_air.Fetch())
            return;   // woken, but nothing new was posted
        double celsius = _air.Value.Celsius;
        if (celsius > MaxCelsius)
            StopSystem("it is too warm");

        bool opens = celsius > (_isOpen ? ClosesBelowCelsius : OpensAboveCelsius);
        if (opens != _isOpen && _window.Push(new WindowCommand(opens)) != PushResult.Rejected)
            _isOpen = opens;   // where the queue was full, the next temperature tries again
    }
}
