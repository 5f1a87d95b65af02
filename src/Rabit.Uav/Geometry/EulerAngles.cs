namespace Rabit.Uav.Geometry;

/// <summary>
/// Attitude of the body (forward-right-down) in the local north-east-down frame: yaw about down, then pitch, then roll
/// (MAVLink ATTITUDE, message 30). A plain value.
/// </summary>
/// <param name="rollRadians">Right wing down positive, -pi to pi.</param>
/// <param name="pitchRadians">Nose up positive, -pi/2 to pi/2.</param>
/// <param name="yawRadians">From true north, clockwise positive, -pi to pi.</param>
public readonly struct EulerAngles(double rollRadians, double pitchRadians, double yawRadians)
{
    /// <summary>Right wing down positive, -pi to pi.</summary>
    public double RollRadians { get; } = rollRadians;

    /// <summary>Nose up positive, -pi/2 to pi/2.</summary>
    public double PitchRadians { get; } = pitchRadians;

    /// <summary>From true north, clockwise positive, -pi to pi.</summary>
    public double YawRadians { get; } = yawRadians;
}
