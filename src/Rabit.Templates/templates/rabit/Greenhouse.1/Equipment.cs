using System;
using Rabit.Core;

namespace Greenhouse._1;

/// <summary>
/// The thermometer and the motor of the window: the only manager that touches devices. Here they are simulated, so that
/// the program runs anywhere; replace <see cref="Measure"/> and <see cref="Move"/> by yours.
/// </summary>
public sealed class Equipment : RabitManager
{
    private const double WarmsCelsiusPerSecond = 1;     // the sun, with the window closed
    private const double CoolsCelsiusPerSecond = 0.5;   // with the window open

    private readonly MessagePublisher<AirTemperature> _air;
    private readonly QueueReceiver<WindowCommand> _commands;
    private readonly Action<string> _report;
    private TimeSpan _measured;
    private bool _isOpen;

    public Equipment(Action<string> report)
        : base("equipment")
    {
        _air = Publish(Names.Air, new AirTemperature { Celsius = 21 });
        _commands = Receive<WindowCommand>(Names.WindowCommands, capacity: 10);
        _report = report;
        Period = TimeSpan.FromMilliseconds(100);
    }

    // Ten times a second, and at once when a command is pushed.
    protected override void ExecuteUnitOfWork()
    {
        while (_commands.TryPop(out WindowCommand command))
            Move(command);

        _air.Value.Celsius = Measure();   // the local copy
        _air.Post();                      // now the global one, and who subscribed is woken
    }

    private void Move(WindowCommand command)
    {
        _isOpen = command.Opens;
        _report(FormattableString.Invariant(
            $"{Now.TotalSeconds:0.0} s: {_air.Value.Celsius:0.0} degrees, window {(_isOpen ? "opens" : "closes")}"));
    }

    private double Measure()
    {
        double seconds = (Now - _measured).TotalSeconds;   // Now: real or virtual, the manager does not know
        _measured = Now;
        return _air.Value.Celsius + (seconds * (_isOpen ? -CoolsCelsiusPerSecond : WarmsCelsiusPerSecond));
    }
}
