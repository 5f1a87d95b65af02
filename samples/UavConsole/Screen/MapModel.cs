using System.Collections.Generic;
using System.Linq;
using Rabit.Geodesy;
using Rabit.Uav.Messages;
using Rabit.Uav.Reporting;

namespace UavConsole;

/// <summary>What the map of the screen shows, in a local frame, metres. Immutable.</summary>
internal sealed class MapModel
{
    /// <summary>Corners, in order.</summary>
    public IReadOnlyList<NedPosition> Area { get; init; } = [];

    /// <summary>Ends of the lanes, two for each.</summary>
    public IReadOnlyList<NedPosition> Lanes { get; init; } = [];

    /// <summary>The path that was flown, oldest first.</summary>
    public IReadOnlyList<NedPosition> Path { get; init; } = [];

    /// <summary>Null where it is not known.</summary>
    public NedPosition? Home { get; init; }

    /// <summary>Null where it is not known.</summary>
    public NedPosition? Vehicle { get; init; }

    /// <summary>Clockwise from north.</summary>
    public double VehicleYawRadians { get; init; }

    /// <summary>The vehicles of a group, where there are several.</summary>
    public IReadOnlyList<MapVehicle> Group { get; init; } = [];

    /// <summary>Targets, tentative ones too.</summary>
    public IReadOnlyList<MapTrack> Tracks { get; init; } = [];

    /// <returns>Empty where nothing is known of any place.</returns>
    public static MapModel Of(FlightRecord record)
    {
        SearchPlan? plan = record.Mission.Plan;
        FlightSample[] samples = record.Samples.Where(s => s.HasPosition).ToArray();
        if (plan is null && samples.Length == 0)
            return new MapModel();
        var frame = LocalNedFrame.IgnoringGeoid(plan?.Home ?? samples[0].Position);
        return new MapModel
        {
            Area = plan is null ? [] : [.. plan.Area.Select(frame.ToNed)],
            Lanes = plan is null ? [] : [.. plan.Lanes.Select(frame.ToNed)],
            Home = plan is null ? null : new NedPosition(0, 0, 0),
            Path = [.. samples.Select(s => frame.ToNed(s.Position))],
            Vehicle = samples.Length == 0 ? null : frame.ToNed(samples[samples.Length - 1].Position),
            VehicleYawRadians = samples.Length == 0 ? 0 : samples[samples.Length - 1].Yaw.Radians,
            Tracks = [.. record.Tracks.Tracks.Select(t => new MapTrack(frame.ToNed(t.Position), t))],
        };
    }

    /// <summary>
    /// The same with several vehicles, each by its number; area, lanes and targets are those of the first.
    /// </summary>
    public static MapModel Of(IReadOnlyList<FlightRecord> group)
    {
        SearchPlan? plan = group.Select(r => r.Mission.Plan).FirstOrDefault(p => p is not null);
        if (plan is null)
            return new MapModel();
        var frame = LocalNedFrame.IgnoringGeoid(plan.Home);
        return new MapModel
        {
            Area = [.. plan.Area.Select(frame.ToNed)],
            Lanes = [.. plan.Lanes.Select(frame.ToNed)],
            Tracks = [.. group[0].Tracks.Tracks.Select(t => new MapTrack(frame.ToNed(t.Position), t))],
            Group = [.. group.Select((record, index) => new MapVehicle
            {
                Mark = (char)('1' + index),
                Path = [.. record.Samples.Where(s => s.HasPosition).Select(s => frame.ToNed(s.Position))],
            })],
        };
    }
}
