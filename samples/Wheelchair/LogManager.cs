using System;
using System.Globalization;
using Rabit.Core;

namespace Wheelchair;

/// <summary>Prints a line twice a second, and one at once when the safety stop sets in or is over.</summary>
internal sealed class LogManager : RabitManager
{
    private readonly Action<string> _print;
    private readonly MessageSubscriber<Drive> _drive;
    private readonly MessageSubscriber<Obstacle> _obstacle;
    private TimeSpan _nextLine;
    private bool _wasSafetyStop;

    public LogManager(Action<string> print)
        : base("log")
    {
        _print = print;
        _drive = Subscribe<Drive>("drive", wakeOnPost: true);
        _obstacle = Subscribe<Obstacle>("obstacle");
    }

    protected override void ExecuteUnitOfWork()
    {
        _obstacle.Fetch();
        if (!_drive.Fetch() || (Now < _nextLine && _drive.Value.IsSafetyStop == _wasSafetyStop))
            return;
        _wasSafetyStop = _drive.Value.IsSafetyStop;
        _nextLine = Now + TimeSpan.FromMilliseconds(500);
        _print(string.Format(
            CultureInfo.InvariantCulture,
            "{0,5:0.0} s  {1,5:0.00} m/s  obstacle in {2:0.00} m{3}",
            Now.TotalSeconds,
            _drive.Value.SpeedMetresPerSecond,
            _obstacle.Value.DistanceMetres,
            _wasSafetyStop ? "  SAFETY STOP" : string.Empty));
    }
}
