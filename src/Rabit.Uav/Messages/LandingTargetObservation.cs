using System;
using Rabit.Geodesy;

namespace Rabit.Uav.Messages;

/// <summary>
/// Where the marker of the place to land on was in a picture, from the vehicle. Posted by Image Processing for each
/// picture that shows it, for Autopilot Interface, which sends it on as LANDING_TARGET. A plain value.
/// </summary>
public struct LandingTargetObservation
{
    /// <summary>When: mid-exposure of the marker's row, by the clock of the run.</summary>
    public TimeSpan Time { get; set; }

    /// <summary>Number of the picture.</summary>
    public long PictureNumber { get; set; }

    /// <summary>Id of the marker.</summary>
    public int MarkerId { get; set; }

    /// <summary>
    /// Centre of the marker from the point whose position the autopilot reports, in the frame of the body, metres: the
    /// lever arms of the camera are taken into account.
    /// </summary>
    public BodyVector PositionMetres { get; set; }

    /// <summary>The same, turned by the attitude of the vehicle at that time to north-east-down.</summary>
    public NedVector OffsetNedMetres { get; set; }
}
