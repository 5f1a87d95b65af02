using System;
using Rabit.Geodesy;
using Rabit.Mavlink.Messages;

namespace Rabit.Uav.Simulation.Tests.Autopilot;

/// <summary>Items of missions that a ground station uploads to the simulated autopilot.</summary>
internal static class MissionItems
{
    /// <summary>An item at a place, metres from home and above it.</summary>
    public static MissionItemInt Item(
        GeodeticPosition home, MavCmd command, double north = 0, double east = 0, double height = 0, float param1 = 0,
        float param2 = 0)
    {
        GeodeticPosition place = LocalNedFrame.IgnoringGeoid(home).ToGeodetic(new NedPosition(north, east, 0));
        return new MissionItemInt
        {
            TargetSystem = 1,
            TargetComponent = 1,
            Command = command,
            Frame = MavFrame.GlobalRelativeAlt,
            Autocontinue = 1,
            Param1 = param1,
            Param2 = param2,
            X = (int)Math.Round(place.Latitude.Degrees * 1e7),
            Y = (int)Math.Round(place.Longitude.Degrees * 1e7),
            Z = (float)height,
        };
    }
}
