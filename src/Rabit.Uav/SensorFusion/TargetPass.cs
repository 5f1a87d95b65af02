using System;
using Rabit.Geodesy;
using Rabit.Uav.Messages;

namespace Rabit.Uav.SensorFusion;

/// <summary>
/// The reports of one target in a few pictures in a row: their mean place, where that would be if the times of the
/// pictures were wrong, and how it moves for other errors.
/// </summary>
internal sealed class TargetPass
{
    /// <summary>
    /// How many errors are estimated beside that of the time: pitch, roll, heading, height of the ground.
    /// </summary>
    public const int Others = 4;

    // Within that the place in the picture changes little.
    private static readonly TimeSpan MaxDuration = TimeSpan.FromSeconds(2);

    // A wrong time moves all reports of a pass alike; their noise is below a metre.
    private const double MaxDistanceMetres = 4;

    private readonly NedVector[] _byOffset = new NedVector[TargetSensitivity.Offsets];
    private readonly NedVector[] _by = new NedVector[Others];
    private double _northSum;
    private double _eastSum;
    private double _varianceSum;
    private TimeSpan _first;
    private int _count;

    public TargetClassName Class { get; private set; }

    /// <summary>Of the mean place, each axis, square metres.</summary>
    public double Variance => _varianceSum / _count / _count;

    private double North => _northSum / _count;

    private double East => _eastSum / _count;

    public void Begin(in LocatedReport report)
    {
        Class = report.Report.Class;
        (_count, _northSum, _eastSum, _varianceSum, _first) = (0, 0, 0, 0, report.Report.Time);
        Array.Clear(_byOffset, 0, _byOffset.Length);
        Array.Clear(_by, 0, Others);
        Add(report);
    }

    /// <summary>Takes a report that belongs to it; false for any other.</summary>
    public bool TryAdd(in LocatedReport report)
    {
        TimeSpan since = report.Report.Time - _first;
        if (report.Report.Class != Class || since <= TimeSpan.Zero || since > MaxDuration
            || Math.Abs(report.North - North) > MaxDistanceMetres || Math.Abs(report.East - East) > MaxDistanceMetres)
            return false;
        Add(report);
        return true;
    }

    /// <summary>The mean place if the time was wrong; not a number where no pose says.</summary>
    /// <param name="index">Of <see cref="TargetSensitivity.OffsetOf"/>.</param>
    public NedVector PlaceAt(int index)
        => new(
            (_northSum + _byOffset[index].North) / _count, (_eastSum + _byOffset[index].East) / _count, 0);

    /// <summary>The same between two of them.</summary>
    /// <param name="offset">How much later the time is than the exposure was, seconds.</param>
    /// <param name="place">The mean place.</param>
    /// <param name="derivative">How it moves for each second more.</param>
    /// <returns>False beyond what was tried, and where no pose says.</returns>
    public bool TryPlace(double offset, out NedVector place, out NedVector derivative)
    {
        (place, derivative) = (default, default);
        double position = (offset + TargetSensitivity.MaxOffsetSeconds) / TargetSensitivity.StepSeconds;
        if (!(position >= 0 && position < TargetSensitivity.Offsets - 1))
            return false;
        int before = (int)position;
        NedVector start = PlaceAt(before);
        NedVector step = PlaceAt(before + 1) - start;
        place = start + ((position - before) * step);
        derivative = step / TargetSensitivity.StepSeconds;
        return place.IsFinite;
    }

    /// <summary>How the mean place moves for another error: a radian, a metre.</summary>
    public NedVector By(int error) => _by[error] / _count;

    private void Add(in LocatedReport report)
    {
        TargetSensitivity by = report.Report.Sensitivity!;
        _count++;
        _northSum += report.North;
        _eastSum += report.East;
        _varianceSum += (report.Report.Covariance.NorthNorth + report.Report.Covariance.EastEast) / 2;
        for (int i = 0; i < _byOffset.Length; i++)
            _byOffset[i] += by.ByOffset[i];
        _by[0] += by.ByPitch;
        _by[1] += by.ByRoll;
        _by[2] += by.ByHeading;
        _by[3] += by.ByGroundHeight;
    }
}
