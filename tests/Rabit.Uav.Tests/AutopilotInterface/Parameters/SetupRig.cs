using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Geodesy;
using Rabit.Mavlink;
using Rabit.Mavlink.Messages;
using Rabit.Uav.AutopilotInterface;
using Rabit.Uav.Messages;
using Rabit.Uav.Preflight;

namespace Rabit.Uav.Tests.AutopilotInterface.Parameters;

/// <summary>Reading and writing before a flight, against a server of parameters, in steps of 50 ms.</summary>
internal sealed class SetupRig
{
    private static readonly TimeSpan Step = TimeSpan.FromMilliseconds(50);

    private readonly PreflightFacts _facts = new(new PreflightOptions());
    private readonly AutopilotSetup _setup;

    public SetupRig(
        ParameterServer server, AutopilotSetupOptions? options = null, MemoryOriginals? store = null,
        MavAutopilot make = MavAutopilot.Ardupilotmega)
    {
        Server = server;
        Vehicle = new VehicleState
        {
            IsConnected = true,
            SystemId = 1,
            ComponentId = 1,
            Autopilot = make,
            LandedState = MavLandedState.OnGround,
            PositionTime = TimeSpan.Zero,
            Position = GeodeticPosition.FromDegrees(47.3977, 8.5456, 488),
            BatteryVolts = 12.4,
        };
        _setup = new AutopilotSetup(
            Vehicle, new MavlinkSender(1, 191), new MavlinkAddress(1, 1), options ?? new AutopilotSetupOptions(), store,
            Log.Add);
    }

    public ParameterServer Server { get; }

    public VehicleState Vehicle { get; set; }

    public TimeSpan Now { get; private set; }

    public List<string> Log { get; } = [];

    public AutopilotParameters Report { get; private set; } = AutopilotParameters.None;

    public bool IsStopping { get; set; }

    public bool MustRestore => _setup.MustRestore;

    public static ParameterServer Ardupilot()
    {
        var server = new ParameterServer(MavAutopilot.Ardupilotmega);
        foreach ((string name, double value) in new[]
        {
            ("FS_GCS_ENABLE", 0.0), ("FS_GCS_TIMEOUT", 5), ("MAV_GCS_SYSID", 255), ("FS_THR_ENABLE", 1),
            ("FS_EKF_ACTION", 1), ("FS_OPTIONS", 20), ("BATT_LOW_VOLT", 10.5), ("BATT_FS_LOW_ACT", 0),
            ("BATT_FS_CRT_ACT", 0), ("GUID_TIMEOUT", 3), ("RTL_ALT", 1500), ("RTL_SPEED", 0), ("WPNAV_SPEED", 500), ("FENCE_ENABLE", 0), ("FENCE_TYPE", 3),
            ("FENCE_ACTION", 1), ("FENCE_MARGIN", 2),
        })
            server.Values[name] = (name.EndsWith("VOLT", StringComparison.Ordinal)
                ? MavParamType.Real32
                : MavParamType.Int16, value);
        return server;
    }

    public void Run(double seconds)
    {
        for (TimeSpan end = Now + TimeSpan.FromSeconds(seconds); Now < end; Now += Step)
        {
            _facts.Now = Now;
            _facts.Vehicle = Vehicle;
            _facts.Own = new OwnAddress { SystemId = 1, ComponentId = 191 };
            _setup.Run(_facts, IsStopping);
            var sent = new List<MavlinkFrame>();
            while (_setup.TryTakeFrame(Now, out MavlinkFrame frame))
                sent.Add(frame);
            foreach (MavlinkFrame answer in sent.SelectMany(Server.Answer))
                _setup.Handle(answer, Now);
            if (_setup.TryTakeReport(out AutopilotParameters report))
                Report = report;
        }
    }

    public double ValueOf(string name) => Report.TryGet(name, out AutopilotParameter found) ? found.Value : double.NaN;
}
