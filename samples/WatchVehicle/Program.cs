using System;
using Rabit.Core;
using Rabit.Links;
using Rabit.Uav;
using Rabit.Uav.Messages;

// Watches a vehicle, live or recorded, and prints a line every ten seconds. Nothing is commanded: MayCommand is false.
//     WatchVehicle udpin:0.0.0.0:14550
//     WatchVehicle 'tlog:flight.tlog?speed=max'
if (args.Length != 1)
{
    Console.Error.WriteLine("WatchVehicle LINK, for example udpin:0.0.0.0:14550");
    return 2;
}

if (!LinkUrl.TryParse(args[0], out LinkUrl? link, out string? error))
{
    Console.Error.WriteLine($"WatchVehicle: {error}");   // what is wrong with it, and what the right form is
    return 2;
}

try
{
    var watcher = new Watcher(Console.WriteLine);
    using UavSystem uav = UavSystem.Open(new UavOptions { Links = [link], OtherManagers = [watcher] });
    RabitReactor reactor = uav.CreateReactor(new ReactorOptions());
    return (await reactor.RunAsync()).ExitCode;   // until Ctrl-C or the end of the log
}
catch (LinkException e)
{
    Console.Error.WriteLine(e.Message);   // one line that names the link and the reason
    return 1;
}

/// <summary>A manager beside the six: it subscribes to what they post.</summary>
internal sealed class Watcher : RabitManager
{
    private static readonly TimeSpan LinePeriod = TimeSpan.FromSeconds(10);

    private readonly MessageSubscriber<VehicleState> _vehicle;
    private readonly MessageSubscriber<HealthReport> _health;
    private readonly Action<string> _print;

    public Watcher(Action<string> print)
        : base("watcher")
    {
        _vehicle = Subscribe<VehicleState>(MessageNames.VehicleState);
        _health = Subscribe<HealthReport>(MessageNames.Health);
        _print = print;
        Period = LinePeriod;
    }

    protected override void ExecuteUnitOfWork()
    {
        _vehicle.Fetch();
        _health.Fetch();
        VehicleState v = _vehicle.Value;
        if (v.Mode is null)
            _print($"{Now.TotalSeconds,6:0} s  no heartbeat of an autopilot received yet");
        else
            _print(FormattableString.Invariant(
                $"{Now.TotalSeconds,6:0} s  {v.Autopilot} {v.Mode,-8} {(v.IsArmed ? "armed" : "disarmed"),-8} {Math.Max(0, v.HeightAboveHomeMetres),6:0.0} m  battery {v.BatteryRemaining:P0}  {_health.Value.Level}"));
    }
}
