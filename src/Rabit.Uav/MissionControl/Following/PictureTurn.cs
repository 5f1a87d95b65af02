using System;
using Rabit.Geodesy;

namespace Rabit.Uav.MissionControl;

/// <summary>
/// The heading of a vehicle that follows a target with a camera that turns with it: the longer side of the picture lies
/// along the way of the target, since it is there that it leaves the picture. The vehicle leans along that way to keep
/// up, and is late or early on it. One thread.
/// </summary>
/// <param name="headingRadians">Until the target is fast, and of a picture without a longer side.</param>
/// <param name="longerSide">From forward of the vehicle to the longer side; null for a picture without.</param>
internal sealed class PictureTurn(double headingRadians, Angle? longerSide)
{
    // Slower than that the direction of the velocity is mostly its error, and the vehicle hardly leans.
    private const double MinMetresPerSecond = 3;

    /// <summary>Of the vehicle, radians clockwise from north.</summary>
    public double HeadingRadians { get; private set; } = headingRadians;

    /// <summary>Takes the newest state of the target.</summary>
    public void Update(FollowMark mark)
    {
        if (longerSide is not { } side || mark.Velocity.Length < MinMetresPerSecond)
            return;

        // Either end of the side may be ahead: the nearer turn.
        double turn = Math.IEEERemainder(mark.Velocity.HeadingRadians - side.Radians - HeadingRadians, Math.PI);
        HeadingRadians = Math.IEEERemainder(HeadingRadians + turn, 2 * Math.PI);
    }
}
