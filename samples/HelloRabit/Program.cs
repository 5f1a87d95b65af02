using System;
using Rabit.Core;

var reactor = new RabitReactor { new Thermometer(), new Heater() };
return (await reactor.RunAsync()).ExitCode;   // until Ctrl-C, SIGTERM or StopSystem

internal struct Temperature { public double Celsius; }

internal sealed class Thermometer : RabitManager
{
    private readonly MessagePublisher<Temperature> _cabin;

    public Thermometer() : base("thermometer")
    {
        _cabin = Publish<Temperature>("cabin", new Temperature { Celsius = 21 });
        WakeUpDelay = TimeSpan.FromMilliseconds(100);
    }

    protected override void ExecuteUnitOfWork()
    {
        _cabin.Value.Celsius -= 0.3;   // fill in the local copy ...
        _cabin.Post();                 // ... and post it
    }
}

internal sealed class Heater : RabitManager
{
    private readonly MessageSubscriber<Temperature> _cabin;

    public Heater() : base("heater") => _cabin = Subscribe<Temperature>("cabin", wakeOnPost: true);

    protected override void ExecuteUnitOfWork()
    {
        if (!_cabin.Fetch()) return;   // woken, but no news
        Console.WriteLine($"{_cabin.Value.Celsius:0.0} degrees: heater {(_cabin.Value.Celsius < 20 ? "on" : "off")}");
        if (_cabin.Value.Celsius < 19) StopSystem("it is too cold");
    }
}
