using System.Collections.Generic;
using System.Linq;
using Rabit.Core;
using Rabit.Uav;
using Rabit.Uav.Messages;
using Rabit.Uav.Reporting;
using Rabit.Uav.Simulation;

namespace UavConsole;

/// <summary>One vehicle of a group: its companion computer, and what is shown and kept of it.</summary>
internal sealed class GroupVehicle
{
    private readonly RabitReactor _reactor;
    private readonly MessageSubscriber<GroupStatus> _status; // of the thread of the view
    private readonly MessageSubscriber<MissionStatus> _mission; // of the thread that simulates

    public GroupVehicle(
        int number, SimulatedGroupVehicle simulated, UavSystem uav, RabitReactor reactor, RunLog log)
    {
        (Number, Simulated, Uav, _reactor, Log) = (number, simulated, uav, reactor, log);
        var recorder = new FlightRecorderManager(new FlightRecorderOptions
        {
            ManagerNames = reactor.Select(m => m.Name).ToArray(),
            ImageChips = () => uav.ImageProcessing.ImageChips,
            FindPictureOverview = number => uav.ImageProcessing.FindPictureOverview(number),
        });
        reactor.Add(recorder);
        _status = reactor.Workspace.Subscribe<GroupStatus>(MessageNames.Group);
        _mission = reactor.Workspace.Subscribe<MissionStatus>(MessageNames.Mission);
        Monitor = new FlightMonitor(reactor, recorder, uav.LinkCount);
    }

    /// <summary>Which of the group, from 0.</summary>
    public int Number { get; }

    /// <summary>What it had sent by radio, once a second; for the thread that simulates.</summary>
    public List<RadioSample> RadioSamples { get; } = [];

    /// <summary>For the thread that simulates.</summary>
    public SimulatedGroupVehicle Simulated { get; }

    /// <summary>Whether it is switched on. Any thread.</summary>
    public bool HasStarted => _reactor.IsWired;

    public UavSystem Uav { get; }

    /// <summary>For the thread of the view.</summary>
    public FlightMonitor Monitor { get; }

    public RunLog Log { get; }

    /// <summary>The group as it knows it; for the thread of the view.</summary>
    public GroupStatus Group { get; private set; }

    public MissionStatus Mission => Monitor.Record.Mission;

    /// <summary>Whether its mission is over, or it is lost; for the thread that simulates.</summary>
    public bool FetchIsOver()
    {
        if (!Simulated.HasStarted)
            return false;
        _mission.Fetch();
        return Simulated.IsLost
            || _mission.Value.Phase is MissionPhase.Done or MissionPhase.Failed or MissionPhase.HandedOver;
    }

    /// <summary>Fetches all news; there is none before it is switched on.</summary>
    public void Refresh()
    {
        if (!HasStarted)
            return;
        Monitor.Refresh();
        _status.Fetch();
        Group = _status.Value;
    }
}
