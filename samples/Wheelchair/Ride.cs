using System;
using Rabit.Core;
using Wheelchair.Devices;

namespace Wheelchair;

/// <summary>Puts a chair, its devices and its managers together.</summary>
internal sealed class Ride
{
    /// <param name="time">Real or virtual.</param>
    /// <param name="print">Where the logger writes its lines.</param>
    public Ride(RabitTime time, Action<string> print)
    {
        Chair = new SimulatedChair(wallAtMetres: 6);
        Sensor = new SimulatedRangeSensor(Chair);
        Reactor = new RabitReactor(time)
        {
            new JoystickManager(new ScriptedJoystick()),
            new ObstacleManager(Sensor),
            new DriveManager(new SimulatedMotors(Chair)),
            new LogManager(print),
        };
    }

    public RabitReactor Reactor { get; }

    public SimulatedChair Chair { get; }

    public SimulatedRangeSensor Sensor { get; }
}
