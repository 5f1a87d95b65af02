using System;
using System.Collections.Generic;
using System.Collections.Immutable;
using System.Linq;
using Rabit.Geodesy;
using Rabit.Mavlink.Messages;
using Rabit.Uav.Messages;
using Rabit.Uav.Preflight;

namespace Rabit.Uav.Tests.Preflight;

/// <summary>Facts that pass, to be spoilt one by one.</summary>
internal static class PreflightCases
{
    public static readonly TimeSpan Now = TimeSpan.FromSeconds(100);

    public static readonly GeodeticPosition Place = GeodeticPosition.FromDegrees(47.3977, 8.5456, 488);

    private static readonly Dictionary<string, double> Ardupilot = new(StringComparer.Ordinal)
    {
        ["FS_GCS_ENABLE"] = 1,
        ["FS_GCS_TIMEOUT"] = 5,
        ["MAV_GCS_SYSID"] = 255,
        ["FS_THR_ENABLE"] = 1,
        ["FS_EKF_ACTION"] = 1,
        ["FS_OPTIONS"] = 16,
        ["BATT_LOW_VOLT"] = 10.5,
        ["BATT_FS_LOW_ACT"] = 2,
        ["BATT_FS_CRT_ACT"] = 1,
        ["GUID_TIMEOUT"] = 3,
        ["RTL_ALT_M"] = 40,
        ["FENCE_ENABLE"] = 1,
        ["FENCE_ACTION"] = 1,
        ["FENCE_MARGIN"] = 2,
    };

    private static readonly Dictionary<string, double> Px4 = new(StringComparer.Ordinal)
    {
        ["COM_OF_LOSS_T"] = 0.5,
        ["COM_OBL_RC_ACT"] = 3,
        ["COM_RCL_EXCEPT"] = 0,
        ["COM_RC_OVERRIDE"] = 3,
        ["COM_RC_IN_MODE"] = 1,
        ["NAV_RCL_ACT"] = 2,
        ["NAV_DLL_ACT"] = 2,
        ["COM_LOW_BAT_ACT"] = 3,
        ["GF_ACTION"] = 3,
        ["RTL_RETURN_ALT"] = 40,
    };

    public static PreflightFacts Facts(
        MavAutopilot make = MavAutopilot.Ardupilotmega, Action<PreflightOptions>? options = null)
    {
        var made = new PreflightOptions
        {
            ObstacleHeightMetres = 20,
            UtcNow = () => DateTimeOffset.FromUnixTimeSeconds(1_700_000_000),
            MinBatteryFraction = 0.5,
        };
        options?.Invoke(made);
        return new PreflightFacts(made)
        {
            Now = Now,
            Vehicle = Vehicle(make),
            Own = new OwnAddress { SystemId = 1, ComponentId = 191 },
            Navigation = new NavigationStatus
            {
                DilutionTime = Now,
                HorizontalDilution = 0.8,
                EstimatorTime = Now,
                HomeTime = Now,
                Home = Place,
            },
            Imaging = new ImagingStatus { HasCamera = true, LastFrameTime = Now },
            FramesIn = 1000,
            Computer = Computer(1_000_000_000),
            Parameters = Parameters(make),
        };
    }

    public static ComputerStatus Computer(long? free)
    {
        ComputerStatus status = ComputerStatus.Unknown;
        status.DiskFreeBytes = free;
        return status;
    }

    public static AutopilotParameters Parameters(MavAutopilot make, params (string Name, double? Value)[] changes)
    {
        var values = new Dictionary<string, double>(make == MavAutopilot.Px4 ? Px4 : Ardupilot, StringComparer.Ordinal);
        foreach ((string name, double? value) in changes)
        {
            values.Remove(name);
            if (value is { } number)
                values[name] = number;
        }

        return new AutopilotParameters
        {
            IsComplete = true,
            All = values.Select(v => new AutopilotParameter(v.Key, v.Value, MavParamType.Int32)).ToImmutableArray(),
        };
    }

    public static PreflightFacts With(this PreflightFacts facts, string name, double? value)
    {
        facts.Parameters = Parameters(facts.Vehicle.Autopilot, (name, value));
        return facts;
    }

    public static PreflightLine Line(this PreflightFacts facts, string name)
        => PreflightChecklist.Evaluate(facts).Lines.Single(l => l.Name == name);

    private static VehicleState Vehicle(MavAutopilot make) => new()
    {
        IsConnected = true,
        LastHeartbeatTime = Now,
        SystemId = 1,
        ComponentId = 1,
        Autopilot = make,
        VehicleType = MavType.Quadrotor,
        LandedState = MavLandedState.OnGround,
        PositionTime = Now,
        Position = Place,
        BatteryTime = Now,
        BatteryVolts = 12.4,
        BatteryRemaining = 0.9,
        GpsTime = Now,
        GpsFix = GpsFixType.Type3dFix,
        Satellites = 12,
        GpsUtcMicroseconds = 1_700_000_000_000_000,
        UtcTime = Now,
    };
}
