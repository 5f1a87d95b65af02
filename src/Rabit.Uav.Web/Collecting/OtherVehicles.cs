using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Core;
using Rabit.Geodesy;
using Rabit.Mavlink.Messages;
using Rabit.Uav.Communications;
using Rabit.Uav.Messages;

namespace Rabit.Uav.Web.Collecting;

/// <summary>
/// Other vehicles, by the positions that they send over our links. No more than a few; thread of the manager.
/// </summary>
internal sealed class OtherVehicles(MavlinkMessageReceiver<GlobalPositionInt> positions)
{
    private const int MaxVehicles = 16;

    // Positions come at least every few seconds; an older one is where it was.
    private static readonly TimeSpan Kept = TimeSpan.FromSeconds(60);

    private readonly Dictionary<byte, OtherVehicle> _vehicles = [];

    /// <summary>Takes the positions that came in since the last time.</summary>
    /// <param name="now">By the clock of the run.</param>
    /// <param name="own">Our own system id: it is none of them.</param>
    public IReadOnlyList<OtherVehicle> Take(TimeSpan now, byte own)
    {
        while (positions.TryPop(out GlobalPositionInt message, out LinkFrame frame))
        {
            byte id = frame.Frame.SystemId;
            GeodeticPosition position =
                GeodeticPosition.FromDegrees(message.Lat / 1e7, message.Lon / 1e7, message.Alt / 1e3);
            bool isPlace = position.IsValid && (message.Lat != 0 || message.Lon != 0);
            if (id == 0 || id == own || !isPlace || (_vehicles.Count >= MaxVehicles && !_vehicles.ContainsKey(id)))
                continue;
            _vehicles[id] = new OtherVehicle(
                id, position, message.RelativeAlt / 1e3,
                message.Hdg == ushort.MaxValue ? Angle.FromRadians(double.NaN) : Angle.FromDegrees(message.Hdg / 100.0),
                frame.Time);
        }

        foreach (byte id in _vehicles.Values.Where(v => v.SystemId == own || now - v.ReceivedAt > Kept)
            .Select(v => v.SystemId).ToArray())
            _vehicles.Remove(id);
        return _vehicles.Count == 0 ? [] : [.. _vehicles.Values.OrderBy(v => v.SystemId)];
    }
}
