using System;

namespace Rabit.Geodesy;

/// <summary>
/// Attitude of the body (forward-right-down) in the local north-east-down frame: yaw about down, then pitch, then roll
/// (MAVLink ATTITUDE, message 30). A plain value.
/// </summary>
/// <remarks>Made from angles, or from numbers by a method that names the unit; never from bare numbers.</remarks>
/// <example>
/// <code>
/// EulerAngles attitude = EulerAngles.FromDegrees(rollDegrees: 5, pitchDegrees: -2, yawDegrees: 90);
/// NedVector nose = Rotation.FromEuler(attitude).ToNed(new BodyVector(1, 0, 0));
/// </code>
/// </example>
public readonly record struct EulerAngles
{
    private readonly double _roll;
    private readonly double _pitch;
    private readonly double _yaw;

    /// <summary>Makes it.</summary>
    /// <param name="roll">Right wing down positive.</param>
    /// <param name="pitch">Nose up positive.</param>
    /// <param name="yaw">From true north, clockwise positive.</param>
    public EulerAngles(Angle roll, Angle pitch, Angle yaw)
        => (_roll, _pitch, _yaw) = (roll.Radians, pitch.Radians, yaw.Radians);

    /// <summary>Right wing down positive, -pi to pi.</summary>
    public Angle Roll => Angle.FromRadians(_roll);

    /// <summary>Nose up positive, -pi/2 to pi/2.</summary>
    public Angle Pitch => Angle.FromRadians(_pitch);

    /// <summary>From true north, clockwise positive, -pi to pi.</summary>
    public Angle Yaw => Angle.FromRadians(_yaw);

    /// <summary>Whether all three are numbers, and not infinite ones.</summary>
    public bool IsFinite => FiniteNumbers.AreFinite(_roll, _pitch, _yaw);

    /// <summary>From radians.</summary>
    /// <param name="rollRadians">Right wing down positive.</param>
    /// <param name="pitchRadians">Nose up positive.</param>
    /// <param name="yawRadians">From true north, clockwise positive.</param>
    public static EulerAngles FromRadians(double rollRadians, double pitchRadians, double yawRadians)
        => new(Angle.FromRadians(rollRadians), Angle.FromRadians(pitchRadians), Angle.FromRadians(yawRadians));

    /// <summary>From degrees.</summary>
    /// <param name="rollDegrees">Right wing down positive.</param>
    /// <param name="pitchDegrees">Nose up positive.</param>
    /// <param name="yawDegrees">From true north, clockwise positive.</param>
    public static EulerAngles FromDegrees(double rollDegrees, double pitchDegrees, double yawDegrees)
        => new(Angle.FromDegrees(rollDegrees), Angle.FromDegrees(pitchDegrees), Angle.FromDegrees(yawDegrees));

    /// <summary>As roll 5°, pitch -2°, yaw 90°.</summary>
    public override string ToString()
        => FormattableString.Invariant(
            $"roll {Roll.Degrees:0.###}°, pitch {Pitch.Degrees:0.###}°, yaw {Yaw.Degrees:0.###}°");
}
