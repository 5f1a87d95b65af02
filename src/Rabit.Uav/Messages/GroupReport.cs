using System;
using Rabit.Geodesy;

namespace Rabit.Uav.Messages;

/// <summary>
/// What a vehicle reports of itself, once a second, to the others that search the same area with it. A plain value.
/// </summary>
public struct GroupReport
{
    /// <summary>
    /// Identifies area, keep-outs and lanes: vehicles with another value are not of one group.
    /// </summary>
    public uint LanesKey { get; set; }

    /// <summary>Whether it can search.</summary>
    public GroupMemberState State { get; set; }

    /// <summary>Where it is, metres above mean sea level.</summary>
    public GeodeticPosition Position { get; set; }

    /// <summary>Where it took off, or will: it lands there.</summary>
    public GeodeticPosition LandingPlace { get; set; }

    /// <summary>The altitude at which it searches, metres above mean sea level.</summary>
    public double SearchAltitudeAmslMetres { get; set; }

    /// <summary>Its ground speed on the lanes, metres per second.</summary>
    public double SpeedMetresPerSecond { get; set; }

    /// <summary>How long it can search before it has to return; up to 18 hours.</summary>
    public TimeSpan SearchTime { get; set; }

    /// <summary>What is left of the lanes that are its share, metres.</summary>
    public double MetresLeft { get; set; }

    /// <summary>
    /// How much of the area it knows to be seen, by itself or by others, 0 to 1: the group has seen that much or more.
    /// </summary>
    public double SeenFraction { get; set; }

    /// <summary>MAVLink system id of the vehicle whose division of the lanes it follows; 0 for none.</summary>
    public byte DivisionAuthor { get; set; }

    /// <summary>The number of that division.</summary>
    public ushort DivisionNumber { get; set; }
}
