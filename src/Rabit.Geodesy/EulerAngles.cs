namespace Rabit.Geodesy;

/// <summary>
/// Attitude of the body (forward-right-down) in the local north-east-down frame: yaw about down, then pitch, then roll
/// (MAVLink ATTITUDE, message 30). A plain value.
/// </summary>
/// <remarks>Made from angles, or from numbers by a method that names the unit; never from bare numbers.</remarks>
public readonly struct EulerAngles
{
    /// <summary>Makes it.</summary>
    /// <param name="roll">Right wing down positive.</param>
    /// <param name="pitch">Nose up positive.</param>
    /// <param name="yaw">From true north, clockwise positive.</param>
    public EulerAngles(Angle roll, Angle pitch, Angle yaw)
        => (RollRadians, PitchRadians, YawRadians) = (roll.Radians, pitch.Radians, yaw.Radians);

    /// <summary>Right wing down positive, -pi to pi.</summary>
    public double RollRadians { get; }

    /// <summary>Nose up positive, -pi/2 to pi/2.</summary>
    public double PitchRadians { get; }

    /// <summary>From true north, clockwise positive, -pi to pi.</summary>
    public double YawRadians { get; }

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
}
