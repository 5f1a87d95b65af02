using Rabit.Geodesy;
using Rabit.Mavlink.Messages;

namespace Rabit.Uav.Reporting;

/// <summary>The ranges of GLOBAL_POSITION_INT, in the integers of the wire; null before the first.</summary>
internal readonly struct PositionRanges(
    FlightRange? latitude, FlightRange? longitude, FlightRange? altitudeAmsl, FlightRange? heightAboveHome)
{
    public FlightRange? Latitude { get; } = latitude;

    public FlightRange? Longitude { get; } = longitude;

    public FlightRange? AltitudeAmsl { get; } = altitudeAmsl;

    public FlightRange? HeightAboveHome { get; } = heightAboveHome;

    public PositionRanges With(in GlobalPositionInt position) => new(
        FlightRange.Extend(Latitude, position.Lat),
        FlightRange.Extend(Longitude, position.Lon),
        FlightRange.Extend(AltitudeAmsl, position.Alt),
        FlightRange.Extend(HeightAboveHome, position.RelativeAlt));
}
