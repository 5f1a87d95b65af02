using Rabit.Geodesy;
using Rabit.Uav.Messages;

namespace Rabit.Uav.SensorFusion;

/// <summary>A report with its place in the local frame, metres. A plain value.</summary>
internal readonly struct LocatedReport(in TargetReport report, NedPosition place, bool isOwn)
{
    public TargetReport Report { get; } = report;

    public double North { get; } = place.North;

    public double East { get; } = place.East;

    public double Down { get; } = place.Down;

    /// <summary>Whether it is of our own camera.</summary>
    public bool IsOwn { get; } = isOwn;
}
