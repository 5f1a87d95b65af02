using System;
using Rabit.Core;

namespace Wheelchair;

/// <summary>
/// Drives as the driver wants, at 50 Hz, and stops before an obstacle, or when it receives nothing from joystick or
/// sensor any more.
/// </summary>
internal sealed class DriveManager : RabitManager
{
    // Both devices report every 50 ms: three missing readings in a row are a broken device.
    private static readonly TimeSpan OldestInput = TimeSpan.FromMilliseconds(200);

    private readonly MessageSubscriber<Joystick> _joystick;
    private readonly MessageSubscriber<Obstacle> _obstacle;
    private readonly MessagePublisher<Drive> _drive;
    private readonly BlockingWriter<MotorCommand> _motors;
    private double _speed;   // metres per second, as commanded: positive is ahead
    private bool _isSafetyStop;

    public DriveManager(IWriterTarget<MotorCommand> motors)
        : base("drive")
    {
        _joystick = Subscribe<Joystick>("joystick");
        _obstacle = Subscribe<Obstacle>("obstacle");
        _drive = Publish<Drive>("drive");
        _motors = AttachWriter("motors", motors);
        Period = Braking.ControlPeriod;
    }

    protected override void ExecuteUnitOfWork()
    {
        _joystick.Fetch();
        _obstacle.Fetch();
        double wanted = _joystick.Value.Forward * Braking.TopSpeedMetresPerSecond;

        if (MustStop())
            _isSafetyStop = true;
        else if (wanted <= 0)
            _isSafetyStop = false;   // the driver has let go, or backs away

        _speed = _isSafetyStop
            ? Approach(0, Braking.EmergencyMetresPerSecondSquared)
            : Approach(wanted, Braking.ComfortMetresPerSecondSquared);
        Command();
    }

    // The chair must stand before its managers end, whatever ended them.
    protected override void Shutdown()
    {
        _speed = 0;
        Command();
    }

    private bool MustStop()
    {
        if (_joystick.Age > OldestInput || _obstacle.Age > OldestInput)
            return true;
        if (_speed <= 0)
            return false;

        // The chair has gone on since the distance was measured.
        double left = _obstacle.Value.DistanceMetres - (_speed * _obstacle.Age.TotalSeconds);
        return left <= Braking.StoppingDistanceMetres(_speed) + Braking.ClearanceMetres;
    }

    private double Approach(double wanted, double metresPerSecondSquared)
    {
        double step = metresPerSecondSquared * Braking.ControlPeriod.TotalSeconds;
        return wanted > _speed ? Math.Min(wanted, _speed + step) : Math.Max(wanted, _speed - step);
    }

    private void Command()
    {
        // The next one follows within a control period.
        _ = _motors.Push(new MotorCommand(_speed, Now));
        _drive.Value = new Drive { SpeedMetresPerSecond = _speed, IsSafetyStop = _isSafetyStop };
        _drive.Post();
    }
}
