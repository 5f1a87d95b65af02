using System;
using Rabit.Mavlink.Messages;

namespace Rabit.Uav.Simulation;

/// <summary>
/// The pilot's sticks as MANUAL_CONTROL reports them. What takes over is the speed of a stick, not where it stands.
/// </summary>
internal sealed class Px4Sticks
{
    private const double Expo = 0.6;         // MPC_XY_MAN_EXPO
    private const double DeadZone = 0.1;     // MPC_HOLD_DZ
    private const double MaxStepSeconds = 0.5;   // a longer gap says nothing about a speed

    private TimeSpan? _received;
    private double _speed;

    /// <summary>Nose down to fly ahead: -1 to 1.</summary>
    public double Pitch { get; private set; }

    /// <summary>To the right: -1 to 1.</summary>
    public double Roll { get; private set; }

    /// <summary>Up: -1 to 1, 0 is the middle.</summary>
    public double Throttle { get; private set; }

    public double Yaw { get; private set; }

    /// <summary>Whether any were ever received.</summary>
    public bool WereReceived => _received is not null;

    /// <summary>Whether they are received now; <see cref="Update"/> sets it.</summary>
    public bool AreValid { get; private set; }

    /// <summary>When the last ones came.</summary>
    public TimeSpan Received => _received ?? TimeSpan.Zero;

    public static double Curve(double stick)
    {
        double part = Math.Abs(stick) < DeadZone ? 0 : stick;
        return ((1 - Expo) * part) + (Expo * part * part * part);
    }

    public void Receive(in ManualControl message, TimeSpan time)
    {
        double pitch = Part(message.X);
        double roll = Part(message.Y);
        double throttle = Part((2 * message.Z) - 1000);
        double yaw = Part(message.R);
        double seconds = _received is { } last ? (time - last).ExactSeconds : 0;
        if (seconds > 0 && seconds < MaxStepSeconds)
        {
            double change = Math.Max(
                Math.Max(Math.Abs(pitch - Pitch), Math.Abs(roll - Roll)),
                Math.Max(Math.Abs(throttle - Throttle), Math.Abs(yaw - Yaw)));
            _speed = Math.Max(_speed, change / seconds);
        }

        (Pitch, Roll, Throttle, Yaw) = (pitch, roll, throttle, yaw);
        _received = time;
    }

    /// <summary>The sticks of a remote control that nothing moves.</summary>
    public void ReceiveCentred(TimeSpan time)
    {
        (Pitch, Roll, Throttle, Yaw) = (0, 0, 0, 0);
        _received = time;
    }

    /// <summary>Looks whether they are still received.</summary>
    public void Update(TimeSpan time, double lossSeconds)
        => AreValid = _received is { } last && (time - last).ExactSeconds <= lossSeconds;

    /// <summary>The highest speed of a stick since the last call, 1/s of its whole way from the middle.</summary>
    public double TakeSpeed()
    {
        double speed = _speed;
        _speed = 0;
        return speed;
    }

    private static double Part(int value) => NedMath.Limited(value / 1000.0, -1, 1);
}
