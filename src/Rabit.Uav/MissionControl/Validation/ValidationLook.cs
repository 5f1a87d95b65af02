using System;
using Rabit.Geodesy;
using Rabit.Uav.Messages;

namespace Rabit.Uav.MissionControl;

/// <summary>What our own pictures show of a place while we validate a target there. One thread.</summary>
internal sealed class ValidationLook(ValidationTask task, LocalNedFrame frame)
{
    // So often it must be reported, and so many pictures without it are enough to reject it.
    private const int MinReports = 4;
    private const int MinEmptyPictures = 10;

    // The errors of our own reports.
    private const double OwnErrorMetres = 6;

    private readonly PlanePoint _place = PlaceOf(frame, task.Position);

    public ValidationTask Task { get; } = task;

    /// <summary>Where the target is said to be.</summary>
    public PlanePoint Place => _place;

    /// <summary>How many of our pictures showed the place.</summary>
    public int Pictures { get; private set; }

    /// <summary>How many of them had such a target there.</summary>
    public int Reports { get; private set; }

    public bool IsEnough => Reports >= MinReports;

    public ValidationResult Result => IsEnough ? ValidationResult.Confirmed
        : Reports == 0 && Pictures >= MinEmptyPictures ? ValidationResult.Rejected
        : ValidationResult.Unknown;

    /// <summary>Takes a picture that was searched.</summary>
    public void Take(in CameraObservation observation)
    {
        if (IsInside(
            PlaceOf(frame, observation.TopLeft), PlaceOf(frame, observation.TopRight),
            PlaceOf(frame, observation.BottomRight), PlaceOf(frame, observation.BottomLeft)))
            Pictures++;
        foreach (TargetReport report in observation.Reports)
        {
            bool isSuch = report.Class == Task.Class && report.MarkerId == Task.MarkerId;
            if (!isSuch || PlaceOf(frame, report.Position).DistanceTo(_place) > Task.RadiusMetres + OwnErrorMetres)
                continue;
            Reports++;
            return;
        }
    }

    /// <summary>The place in the plane of a frame; the altitude is not used.</summary>
    public static PlanePoint PlaceOf(LocalNedFrame frame, GeodeticPosition position)
    {
        NedPosition ned = frame.ToNed(GeodeticPosition.FromRadians(
            position.Latitude.Radians, position.Longitude.Radians, frame.Origin.AltitudeAmslMetres));
        return new PlanePoint(ned.North, ned.East);
    }

    // Convex, in either direction.
    private bool IsInside(PlanePoint a, PlanePoint b, PlanePoint c, PlanePoint d)
    {
        double first = Side(a, b);
        return first * Side(b, c) > 0 && first * Side(c, d) > 0 && first * Side(d, a) > 0;
    }

    private double Side(PlanePoint from, PlanePoint to) => (to - from).Cross(_place - from);
}
