using System;
using System.Collections.Immutable;
using Rabit.Geodesy;

namespace Rabit.Uav.Messages;

/// <summary>
/// A picture that was searched for targets: which ground it shows, and the reports of the targets that were found, also
/// when there are none, so that a miss counts only for what could be seen. Of a picture that reaches towards the
/// horizon only a part is searched, what shows the smallest target large enough, and the corners are those of that
/// part. A plain value; the reports are immutable, and copies share them.
/// </summary>
public struct CameraObservation
{
    private ImmutableArray<TargetReport> _reports;

    /// <summary>MAVLink system id of the vehicle whose camera it was.</summary>
    public byte SourceSystemId { get; set; }

    /// <summary>Number of the picture.</summary>
    public long Number { get; set; }

    /// <summary>
    /// When: mid-exposure by the clock of the run; of the middle row, where rows are exposed one after the other.
    /// </summary>
    public TimeSpan Time { get; set; }

    /// <summary>The targets that were found, by <see cref="TargetReport.Index"/>; never default.</summary>
    public ImmutableArray<TargetReport> Reports
    {
        readonly get => _reports.IsDefault ? [] : _reports;
        set => _reports = value;
    }

    /// <summary>Where the centre of the top left pixel of what was searched meets the ground.</summary>
    public GeodeticPosition TopLeft { get; set; }

    /// <summary>Where the top right pixel does.</summary>
    public GeodeticPosition TopRight { get; set; }

    /// <summary>Where the bottom right pixel does.</summary>
    public GeodeticPosition BottomRight { get; set; }

    /// <summary>Where the bottom left pixel does.</summary>
    public GeodeticPosition BottomLeft { get; set; }
}
