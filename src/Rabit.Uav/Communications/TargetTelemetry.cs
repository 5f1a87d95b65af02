using System;
using System.Collections.Generic;
using System.Globalization;
using Rabit.Geodesy;
using Rabit.Mavlink.Messages;
using Rabit.Uav.Messages;

namespace Rabit.Uav.Communications;

/// <summary>
/// What ground stations get of the confirmed targets: each in its turn as CAMERA_TRACKING_GEO_STATUS, one a second, and
/// each once as a text with its coordinates; by option as ADSB_VEHICLE, which ground stations draw on their map. Time
/// comes in, messages go out; for one thread.
/// </summary>
internal sealed class TargetTelemetry
{
    // Of all vehicles' addresses those that no state has given out: the first byte has no country.
    private const uint FirstAddress = 0x00F0_0000;
    private const uint AddressesOfSystem = 0x1000;
    private const double DegE7PerDegree = 1e7;
    private const int MaxCallsign = 8;

    private static readonly TimeSpan Period = TimeSpan.FromSeconds(1);

    private readonly HashSet<int> _named = [];
    private readonly StatusTextChunks _texts = new();
    private TimeSpan _due;
    private TargetTrack? _current;

    /// <summary>Takes the next target; each in its turn.</summary>
    /// <returns>Whether something is to be sent now.</returns>
    public bool TryNext(TrackList tracks, TimeSpan now)
    {
        if (now < _due)
            return false;
        int last = _current?.Id ?? int.MinValue;
        TargetTrack? first = null;
        TargetTrack? next = null;
        foreach (TargetTrack track in tracks.Tracks)
        {
            if (track.State != TrackState.Confirmed || !IsKnown(track.Position))
                continue;
            first = first is null || track.Id < first.Id ? track : first;
            if (track.Id > last && (next is null || track.Id < next.Id))
                next = track;
        }

        _current = next ?? first;
        if (_current is null)
            return false;
        _due = now + Period;
        return true;
    }

    /// <summary>Where it is.</summary>
    public CameraTrackingGeoStatus GeoStatus() => new()
    {
        TrackingStatus = CameraTrackingStatusFlags.Active,
        Lat = DegE7(_current!.Position.Latitude),
        Lon = DegE7(_current.Position.Longitude),
        Alt = (float)_current.Position.AltitudeAmslMetres,
        HAcc = (float)Math.Sqrt(_current.Covariance.NorthNorth + _current.Covariance.EastEast),
        VAcc = float.NaN,
        VelN = (float)_current.VelocityNed.North,
        VelE = (float)_current.VelocityNed.East,
        VelD = (float)_current.VelocityNed.Down,
        VelAcc = float.NaN,
        Dist = float.NaN,
        Hdg = float.NaN,
        HdgAcc = float.NaN,
    };

    /// <summary>Its text, the first time that it is sent; none after that. Valid until the next call.</summary>
    public IReadOnlyList<Statustext> Texts()
    {
        TargetTrack track = _current!;
        if (!_named.Add(track.Id))
            return [];
        string text = string.Format(
            CultureInfo.InvariantCulture, "Rabit: target {0} {1} {2:0.00000},{3:0.00000} +-{4:0} m", track.Id,
            track.Class, track.Position.Latitude.Degrees, track.Position.Longitude.Degrees,
            Math.Ceiling(track.Covariance.HalfMajorAxis95Metres));
        return _texts.Of(text, MavSeverity.Notice);
    }

    /// <summary>The target as if it were traffic: it is none, so that only a ground station may get it.</summary>
    /// <param name="systemId">Ours.</param>
    /// <param name="now">The time.</param>
    public AdsbVehicle Traffic(byte systemId, TimeSpan now)
    {
        TargetTrack track = _current!;
        string callsign = "TGT" + track.Id.ToString("000", CultureInfo.InvariantCulture);
        return new AdsbVehicle
        {
            IcaoAddress = FirstAddress + (systemId * AddressesOfSystem) + ((uint)track.Id % AddressesOfSystem),
            Lat = DegE7(track.Position.Latitude),
            Lon = DegE7(track.Position.Longitude),
            AltitudeType = AdsbAltitudeType.Geometric,
            Altitude = (int)Math.Round(track.Position.AltitudeAmslMetres * 1000),
            Heading = ushort.MaxValue,
            HorVelocity = 0,
            VerVelocity = 0,
            Callsign = new Text9(callsign.Length <= MaxCallsign ? callsign : callsign.Substring(0, MaxCallsign)),
            EmitterType = AdsbEmitterType.PointObstacle,
            Tslc = (byte)Math.Max(0, Math.Min(byte.MaxValue, (now - track.LastSeen).ExactSeconds)),
            Flags = AdsbFlags.ValidCoords | AdsbFlags.ValidAltitude | AdsbFlags.ValidCallsign,
        };
    }

    private static bool IsKnown(GeodeticPosition place)
        => Math.Abs(place.Latitude.Degrees) <= 90 && Math.Abs(place.Longitude.Degrees) <= 180;

    private static int DegE7(Angle angle) => (int)Math.Round(angle.Degrees * DegE7PerDegree);
}
