using System;
using Rabit.Geodesy;

namespace Rabit.Uav.Messages;

/// <summary>
/// A picture that was searched for targets: which ground it showed. It goes out after the reports of the picture, also when there are
/// none, so that a miss counts only for what could be seen. A plain value.
/// </summary>
public struct CameraObservation
{
    /// <summary>MAVLink system id of the vehicle that looked.</summary>
    public byte SourceSystemId { get; set; }

    /// <summary>Number of the picture.</summary>
    public long Number { get; set; }

    /// <summary>When: mid-exposure by the clock of the run; of the middle row, where rows are exposed one after the other.</summary>
    public TimeSpan Time { get; set; }

    /// <summary>How many reports went out for it.</summary>
    public int Reports { get; set; }

    /// <summary>Where the centre of the top left pixel meets the ground.</summary>
    public GeodeticPosition TopLeft { get; set; }

    /// <summary>Where the top right pixel does.</summary>
    public GeodeticPosition TopRight { get; set; }

    /// <summary>Where the bottom right pixel does.</summary>
    public GeodeticPosition BottomRight { get; set; }

    /// <summary>Where the bottom left pixel does.</summary>
    public GeodeticPosition BottomLeft { get; set; }
}
